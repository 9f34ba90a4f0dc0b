// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/files/npy_header.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <vector>

#include "neuralmesh/errors.h"

namespace neuralmesh {
namespace {

constexpr char magic[] = {'\x93', 'N', 'U', 'M', 'P', 'Y'};
/// NumPy itself refuses longer headers.
constexpr std::size_t longestHeader = 10000;

[[noreturn]] void refuseHeader()
{
    throw InvalidInput("its NPY header cannot be understood.");
}

/// The header: a dictionary in Python's syntax with three entries, whose values are a string,
/// True or False, and a tuple of integers. Anything else is refused.
class HeaderText {
public:
    explicit HeaderText(std::string text) : text_(std::move(text)) { parse(); }

    std::string element; ///< as in "<f4"
    bool isColumnMajor = false;
    std::vector<std::uint64_t> shape;

private:
    void parse()
    {
        expect('{');
        int entries = 0;
        for (; peek() != '}'; ++entries) {
            parseEntry();
            if (peek() != '}')
                expect(',');
        }
        expect('}');
        if (entries != 3 || !seen_["descr"] || !seen_["fortran_order"] || !seen_["shape"])
            refuseHeader();
    }

    void parseEntry()
    {
        const std::string key = string();
        seen_[key] = true;
        expect(':');
        if (key == "descr")
            element = peek() == '[' ? refuseStructure() : string();
        else if (key == "fortran_order")
            isColumnMajor = boolean();
        else if (key == "shape")
            shape = tuple();
        else
            refuseHeader();
    }

    [[noreturn]] static std::string refuseStructure()
    {
        throw InvalidInput("its array has named fields; an array of N by 3 numbers is read. Save "
                           "the coordinates alone.");
    }

    char peek()
    {
        while (position_ < text_.size() && (text_[position_] == ' ' || text_[position_] == '\n'))
            ++position_;
        if (position_ == text_.size())
            refuseHeader();
        return text_[position_];
    }

    void expect(char wanted)
    {
        if (peek() != wanted)
            refuseHeader();
        ++position_;
    }

    std::string string()
    {
        const char quote = peek();
        const std::size_t end = text_.find(quote, position_ + 1);
        if ((quote != '\'' && quote != '"') || end == std::string::npos)
            refuseHeader();
        std::string content = text_.substr(position_ + 1, end - position_ - 1);
        position_ = end + 1;
        return content;
    }

    bool boolean()
    {
        const bool value = peek() == 'T';
        const std::string word = value ? "True" : "False";
        if (text_.compare(position_, word.size(), word) != 0)
            refuseHeader();
        position_ += word.size();
        return value;
    }

    std::vector<std::uint64_t> tuple()
    {
        std::vector<std::uint64_t> numbers;
        expect('(');
        while (peek() != ')') {
            numbers.push_back(integer());
            if (peek() != ')')
                expect(',');
        }
        expect(')');
        return numbers;
    }

    std::uint64_t integer()
    {
        peek();
        std::uint64_t value = 0;
        const auto [stop, error] =
            std::from_chars(text_.data() + position_, text_.data() + text_.size(), value);
        if (error == std::errc::result_out_of_range)
            throw InvalidInput("its NPY header promises more numbers than any file holds.");
        if (error != std::errc())
            refuseHeader();
        position_ = static_cast<std::size_t>(stop - text_.data());
        return value;
    }

    std::string text_;
    std::size_t position_ = 0;
    std::map<std::string, bool> seen_;
};

std::string shapeText(const std::vector<std::uint64_t> &shape)
{
    std::string text = "(";
    for (const std::uint64_t size : shape)
        text += (text.size() > 1 ? ", " : "") + std::to_string(size);
    return text + (shape.size() == 1 ? ",)" : ")");
}

/// The place of the text and its length, by the version of the format.
Bytes headerOf(Bytes file)
{
    constexpr std::size_t versionAt = sizeof magic;
    constexpr std::size_t lengthAt = versionAt + 2;
    if (file.size < lengthAt + 4)
        throw InvalidInput("its NPY header is truncated.");
    const unsigned version = file.data[versionAt];
    if (version < 1 || version > 3)
        throw InvalidInput("it is of version " + std::to_string(version) +
                           " of the NPY format; versions 1 to 3 are read.");
    const std::size_t length = version == 1
                                   ? loadNumber<std::uint16_t>(file.data + lengthAt, false)
                                   : loadNumber<std::uint32_t>(file.data + lengthAt, false);
    const std::size_t textAt = lengthAt + (version == 1 ? 2 : 4);
    if (length > file.size - textAt)
        throw InvalidInput("its NPY header of " + std::to_string(length) +
                           " bytes is truncated: the file ends after " + std::to_string(file.size) +
                           ".");
    if (length > longestHeader)
        throw InvalidInput("its NPY header is " + std::to_string(length) +
                           " bytes long; NumPy writes up to " + std::to_string(longestHeader) +
                           ".");
    return {file.data + textAt, length};
}

NumberType numberType(const std::string &element)
{
    const bool hasOrder = element.size() == 3 && (element[0] == '<' || element[0] == '>');
    if (hasOrder && element.compare(1, 2, "f4") == 0)
        return NumberType::float32;
    if (hasOrder && element.compare(1, 2, "f8") == 0)
        return NumberType::float64;
    throw InvalidInput("its numbers are of type " + quoted(element) +
                       "; float32 and float64 are read. Convert the array with astype.");
}

} // namespace

bool isNpy(Bytes file)
{
    return file.size >= sizeof magic && std::memcmp(file.data, magic, sizeof magic) == 0;
}

PointLayout readNpyHeader(Bytes file)
{
    const Bytes header = headerOf(file);
    const HeaderText text(std::string(header.data, header.data + header.size));
    const NumberType type = numberType(text.element);
    if (text.shape.size() != 2 || text.shape[1] != 3)
        throw InvalidInput("its array has the shape " + quoted(shapeText(text.shape)) +
                           "; (N, 3) is read, a point a row.");
    if (text.isColumnMajor)
        throw InvalidInput("its array is in Fortran order, a coordinate after the other. Save it "
                           "in C order: numpy.save(file, numpy.ascontiguousarray(points))");
    PointLayout layout;
    layout.firstRecord = static_cast<std::uint64_t>(header.data + header.size - file.data);
    layout.recordSize = 3 * sizeOf(type);
    layout.count = text.shape[0];
    layout.bigEndian = text.element[0] == '>';
    for (std::size_t axis = 0; axis < 3; ++axis)
        layout.coordinates[axis] = {axis * sizeOf(type), type, 1, 0};
    return layout;
}

} // namespace neuralmesh
