// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/files/point_layout.h"

#include "neuralmesh/errors.h"

namespace neuralmesh {
namespace {

constexpr std::size_t longestQuote = 40;

} // namespace

void requireRoom(const PointLayout &layout, std::uint64_t fileSize)
{
    if (layout.count == 0)
        throw InvalidInput("it holds no points.");
    for (const CoordinateField &field : layout.coordinates)
        if (layout.recordSize < sizeOf(field.type) ||
            field.offset > layout.recordSize - sizeOf(field.type))
            throw InvalidInput("its records of " + std::to_string(layout.recordSize) +
                               " bytes are too short for three coordinates.");
    // Divided, since the product may be beyond 64 bits.
    const std::uint64_t room =
        layout.firstRecord < fileSize ? (fileSize - layout.firstRecord) / layout.recordSize : 0;
    if (layout.count > room)
        throw InvalidInput("its header promises " + std::to_string(layout.count) + " points of " +
                           std::to_string(layout.recordSize) + " bytes each, but the file, of " +
                           std::to_string(fileSize) + " bytes, has room for only " +
                           std::to_string(room) + ": it is truncated, or its header is wrong.");
}

std::string quoted(const std::string &text)
{
    std::string printable;
    for (const char c : text.substr(0, longestQuote))
        printable += c >= ' ' && c <= '~' ? c : '?';
    return "'" + printable + (text.size() > longestQuote ? "...'" : "'");
}

} // namespace neuralmesh
