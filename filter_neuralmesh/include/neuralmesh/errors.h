// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace neuralmesh {

/// The input or a parameter cannot be used. The text is a sentence for the user, in plain text.
class InvalidInput : public std::runtime_error {
public:
    explicit InvalidInput(const std::string &sentence) : std::runtime_error(sentence) {}
};

/// The progress callback asked to stop.
class Cancelled : public std::runtime_error {
public:
    Cancelled() : std::runtime_error("Cancelled: the document is as it was.") {}
};

} // namespace neuralmesh
