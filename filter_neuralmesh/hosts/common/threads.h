// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>

namespace neuralmesh {

/// How many threads a host asks the core for. Where its user leaves it open, by 0, as many as
/// OMP_NUM_THREADS allows, by which other filters are held to their share of a machine; else 0, one
/// for each core. What is no whole number above 0 is passed over.
inline int threadsAllowed(int asked)
{
    if (asked != 0)
        return asked;
    const char *text = std::getenv("OMP_NUM_THREADS");
    if (text == nullptr)
        return 0;
    char *end = nullptr;
    const long most = std::strtol(text, &end, 10);
    // A list is one number for each level of nested loops: the first is the outermost.
    return end != text && (*end == '\0' || *end == ',') && most > 0 && most < 1 << 20
               ? static_cast<int>(most)
               : 0;
}

} // namespace neuralmesh
