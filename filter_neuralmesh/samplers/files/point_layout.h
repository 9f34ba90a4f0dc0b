// SPDX-License-Identifier: GPL-3.0-or-later
// Where the points are in a file and how their coordinates are written: what every header of a
// point file comes down to.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

#include <vcg/space/box3.h>

#include "core/portability.h"
#include "samplers/files/mapped_file.h"

namespace neuralmesh {

enum class NumberType { int32, float32, float64 };

inline std::size_t sizeOf(NumberType type)
{
    return type == NumberType::float64 ? 8 : 4;
}

/// One coordinate of a record; its value is number * scale + shift.
struct CoordinateField {
    std::size_t offset = 0; ///< in the record
    NumberType type = NumberType::float32;
    double scale = 1;
    double shift = 0;
};

/// Records of equal length, one a point.
struct PointLayout {
    std::uint64_t firstRecord = 0; ///< in the file
    std::size_t recordSize = 0;
    std::uint64_t count = 0;
    bool bigEndian = false;
    std::array<CoordinateField, 3> coordinates;
    /// As the header says, which may be wrong; none where the format has none.
    std::optional<vcg::Box3d> claimedBounds;
};

/// Throws InvalidInput where the layout has no points, or where the file, of so many bytes, does
/// not hold all its records, or where a record does not hold its coordinates. A layout that passes
/// is safe to read, whatever its header said.
void requireRoom(const PointLayout &layout, std::uint64_t fileSize);

/// An integer or floating-point number at any address, in either byte order.
template <class T> T loadNumber(const unsigned char *at, bool bigEndian)
{
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, at, sizeof(T));
    if (bigEndian != hostIsBigEndian)
        for (std::size_t i = 0; i < sizeof(T) / 2; ++i) {
            const unsigned char byte = bytes[i];
            bytes[i] = bytes[sizeof(T) - 1 - i];
            bytes[sizeof(T) - 1 - i] = byte;
        }
    T number;
    std::memcpy(&number, bytes, sizeof(T));
    return number;
}

/// The records of a layout for which requireRoom() passed, in world coordinates.
class PointRecords {
public:
    PointRecords(Bytes file, const PointLayout &layout)
        : first_(file.data + layout.firstRecord), layout_(layout)
    {
    }

    const PointLayout &layout() const { return layout_; }
    std::uint64_t count() const { return layout_.count; }
    /// From now on, these are the first so many, of no more than there are.
    void keepFirst(std::uint64_t count) { layout_.count = count; }
    const unsigned char *record(std::uint64_t index) const
    {
        return first_ + index * layout_.recordSize;
    }

    /// Coordinates may be NaN or infinite.
    vcg::Point3d point(std::uint64_t index) const
    {
        const unsigned char *const at = record(index);
        return {number(at, layout_.coordinates[0]), number(at, layout_.coordinates[1]),
                number(at, layout_.coordinates[2])};
    }

private:
    double number(const unsigned char *record, const CoordinateField &field) const
    {
        const unsigned char *const at = record + field.offset;
        double value = 0;
        switch (field.type) {
        case NumberType::int32: value = loadNumber<std::int32_t>(at, layout_.bigEndian); break;
        case NumberType::float32: value = loadNumber<float>(at, layout_.bigEndian); break;
        case NumberType::float64: value = loadNumber<double>(at, layout_.bigEndian); break;
        }
        return value * field.scale + field.shift;
    }

    const unsigned char *first_;
    PointLayout layout_;
};

/// Text of a file as part of a sentence: in quotes, printable, of bounded length.
std::string quoted(const std::string &text);

} // namespace neuralmesh
