// SPDX-License-Identifier: GPL-3.0-or-later
#include "lzf.h"

#include <stdexcept>
#include <vector>

namespace nb = nanobind;

namespace neuralmesh::python {
namespace {

constexpr unsigned mostLiterals = 32; ///< a control byte below it announces so many bytes, less one
constexpr unsigned longLength = 7;    ///< a length that goes on in the next byte
constexpr std::size_t leastCopied = 2; ///< is added to each length of a repetition

/// The packed bytes, one after the other.
class Packed {
public:
    explicit Packed(const nb::bytes &bytes)
        : next_(static_cast<const unsigned char *>(bytes.data())), end_(next_ + bytes.size())
    {
    }
    bool isAtEnd() const { return next_ == end_; }
    unsigned char byte()
    {
        if (isAtEnd())
            throw std::invalid_argument("The packed block is cut short.");
        return *next_++;
    }

private:
    const unsigned char *next_, *end_;
};

void requireRoom(std::size_t room, std::size_t length)
{
    if (length > room)
        throw std::invalid_argument("The packed block holds more than it should.");
}

} // namespace

nb::bytes lzfDecompressed(const nb::bytes &packed, std::size_t size)
{
    // A byte of a repetition stands for 264 bytes at the most: no size is believed beyond that.
    if (size / 88 > packed.size())
        throw std::invalid_argument("The packed block cannot hold so much.");
    Packed in(packed);
    std::vector<char> out;
    out.reserve(size);
    while (!in.isAtEnd()) {
        const unsigned control = in.byte();
        if (control < mostLiterals) {
            requireRoom(size - out.size(), control + 1);
            for (unsigned i = 0; i <= control; ++i)
                out.push_back(static_cast<char>(in.byte()));
            continue;
        }
        std::size_t length = control >> 5;
        if (length == longLength)
            length += in.byte();
        length += leastCopied;
        const std::size_t back = ((control & 31U) << 8 | in.byte()) + 1;
        requireRoom(size - out.size(), length);
        if (back > out.size())
            throw std::invalid_argument("The packed block repeats what was not there.");
        for (std::size_t i = 0; i < length; ++i) // may overlap what it writes
            out.push_back(out[out.size() - back]);
    }
    if (out.size() != size)
        throw std::invalid_argument("The packed block holds less than it should.");
    return nb::bytes(out.data(), out.size());
}

} // namespace neuralmesh::python
