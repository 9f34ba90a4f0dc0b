// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes that a fuzzer gives, read as a sequence of choices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "neuralmesh/errors.h"

namespace neuralmesh::fuzz {

/// Once the bytes are used up, every choice is the first.
class Choices {
public:
    Choices(const std::uint8_t *data, std::size_t size) : data_(data), left_(size) {}

    bool isEnd() const { return left_ == 0; }

    std::uint8_t byte()
    {
        if (isEnd())
            return 0;
        --left_;
        return *data_++;
    }
    /// Below `count`, which is at least 1.
    int below(int count) { return byte() % count; }
    /// In (0, 1).
    double share() { return (byte() + 1) / 257.0; }

    /// Up to the next line feed.
    std::string line()
    {
        std::string text;
        while (!isEnd())
            if (const auto letter = static_cast<char>(byte()); letter == '\n')
                break;
            else
                text += letter;
        return text;
    }

private:
    const std::uint8_t *data_;
    std::size_t left_;
};

/// What a fuzzer is to find: throws std::logic_error, which nothing catches.
inline void require(bool holds, const std::string &promise)
{
    if (!holds)
        throw std::logic_error(promise);
}

/// Runs a target, which may refuse its input by a sentence.
template <class Run> int refusingOrNot(const Run &run)
{
    try {
        run();
    } catch (const InvalidInput &refusal) {
        require(refusal.what()[0] != '\0', "a sentence");
    } catch (const Cancelled &) { // it took too long
    }
    return 0;
}

} // namespace neuralmesh::fuzz
