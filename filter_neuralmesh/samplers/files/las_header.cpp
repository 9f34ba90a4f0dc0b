// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/files/las_header.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "neuralmesh/errors.h"

namespace neuralmesh {
namespace {

/// Where the fields are in the header ("Public Header Block").
namespace at {
constexpr std::size_t versionMajor = 24;
constexpr std::size_t versionMinor = 25;
constexpr std::size_t headerSize = 94;
constexpr std::size_t pointOffset = 96;
constexpr std::size_t recordCount = 100; ///< of variable length records, before the points
constexpr std::size_t pointFormat = 104;
constexpr std::size_t pointSize = 105;
constexpr std::size_t pointCount32 = 107;
constexpr std::size_t scales = 131;
constexpr std::size_t shifts = 155;
constexpr std::size_t bounds = 179; ///< greatest and least x, then y, then z
constexpr std::size_t pointCount64 = 247;
} // namespace at

/// Least size of the header by minor version, and of a point by point format.
constexpr std::size_t leastHeader[] = {227, 227, 227, 235, 375};
constexpr std::size_t leastPoint[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

/// Of a variable length record: its own header, in which a name and the length of the rest are.
constexpr std::size_t recordHeader = 54;
constexpr std::size_t recordName = 2;
constexpr std::size_t recordLength = 20;
constexpr char compressorName[] = "laszip encoded";

const char *const compressed =
    "its points are compressed (LAZ), so that none can be read in place. Decompress it to LAS "
    "first, for instance with PDAL: pdal translate in.laz out.las";

class HeaderParser {
public:
    explicit HeaderParser(Bytes file) : file_(file) {}

    PointLayout parse() const
    {
        if (file_.size < leastHeader[0])
            throw InvalidInput("its LAS header is truncated: the file ends after " +
                               std::to_string(file_.size) + " bytes.");
        const unsigned minor = minorVersion();
        const std::uint64_t firstRecord = load<std::uint32_t>(at::pointOffset);
        requireHeaderSize(minor, firstRecord);
        requireUncompressed(firstRecord);
        PointLayout layout;
        layout.firstRecord = firstRecord;
        layout.recordSize = pointSize();
        layout.count = pointCount(minor);
        for (std::size_t axis = 0; axis < 3; ++axis)
            layout.coordinates[axis] = coordinate(axis);
        layout.claimedBounds = claimedBounds();
        return layout;
    }

private:
    template <class T> T load(std::size_t position) const
    {
        return loadNumber<T>(file_.data + position, false);
    }

    unsigned minorVersion() const
    {
        const unsigned major = file_.data[at::versionMajor];
        const unsigned minor = file_.data[at::versionMinor];
        if (major != 1 || minor > 4)
            throw InvalidInput("it is of LAS version " + std::to_string(major) + "." +
                               std::to_string(minor) + "; versions up to 1.4 are read.");
        return minor;
    }

    void requireHeaderSize(unsigned minor, std::uint64_t firstRecord) const
    {
        const std::size_t size = load<std::uint16_t>(at::headerSize);
        if (size < leastHeader[minor])
            throw InvalidInput("its LAS header says that it is " + std::to_string(size) +
                               " bytes long, but version 1." + std::to_string(minor) + " needs " +
                               std::to_string(leastHeader[minor]) + ".");
        if (size > file_.size)
            throw InvalidInput("its LAS header of " + std::to_string(size) +
                               " bytes is truncated: the file ends after " +
                               std::to_string(file_.size) + ".");
        if (firstRecord < size)
            throw InvalidInput("its points start at byte " + std::to_string(firstRecord) +
                               ", inside the header of " + std::to_string(size) + " bytes.");
    }

    /// By the bits that compressors set in the point format, and by the record that they add.
    void requireUncompressed(std::uint64_t firstRecord) const
    {
        if ((file_.data[at::pointFormat] & 0xc0U) != 0)
            throw InvalidInput(compressed);
        const std::uint64_t end = std::min<std::uint64_t>(firstRecord, file_.size);
        std::uint64_t position = load<std::uint16_t>(at::headerSize);
        // Each round takes a step of 54 bytes at least, so that a huge count does no harm.
        for (std::uint32_t left = load<std::uint32_t>(at::recordCount);
             left > 0 && position + recordHeader <= end; --left) {
            const unsigned char *const record = file_.data + position;
            if (std::memcmp(record + recordName, compressorName, sizeof compressorName) == 0)
                throw InvalidInput(compressed);
            position += recordHeader + loadNumber<std::uint16_t>(record + recordLength, false);
        }
    }

    std::size_t pointSize() const
    {
        const unsigned format = file_.data[at::pointFormat];
        const std::size_t size = load<std::uint16_t>(at::pointSize);
        if (format >= std::size(leastPoint))
            throw InvalidInput("it is of LAS point format " + std::to_string(format) +
                               "; formats 0 to 10 are read.");
        if (size < leastPoint[format])
            throw InvalidInput("its points are " + std::to_string(size) +
                               " bytes long, but LAS point format " + std::to_string(format) +
                               " needs " + std::to_string(leastPoint[format]) + ".");
        return size;
    }

    std::uint64_t pointCount(unsigned minor) const
    {
        const std::uint64_t count = minor >= 4 ? load<std::uint64_t>(at::pointCount64) : 0;
        return count > 0 ? count : load<std::uint32_t>(at::pointCount32);
    }

    CoordinateField coordinate(std::size_t axis) const
    {
        const auto scale = load<double>(at::scales + 8 * axis);
        const auto shift = load<double>(at::shifts + 8 * axis);
        const std::string name(1, "xyz"[axis]);
        if (!(std::isfinite(scale) && scale > 0))
            throw InvalidInput("the scale of its coordinate " + name +
                               " is not a positive finite number.");
        if (!std::isfinite(shift) ||
            !std::isfinite(scale * std::numeric_limits<std::int32_t>::max() + std::abs(shift)))
            throw InvalidInput("the offset of its coordinate " + name +
                               " is not finite, or too large.");
        return {4 * axis, NumberType::int32, scale, shift};
    }

    std::optional<vcg::Box3d> claimedBounds() const
    {
        vcg::Box3d box;
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t position = at::bounds + 16 * static_cast<std::size_t>(axis);
            box.max[axis] = load<double>(position);
            box.min[axis] = load<double>(position + 8);
            if (!std::isfinite(box.max[axis]) || !std::isfinite(box.min[axis]) ||
                box.min[axis] > box.max[axis])
                return std::nullopt;
        }
        return box;
    }

    Bytes file_;
};

} // namespace

bool isLas(Bytes file)
{
    return file.size >= 4 && std::memcmp(file.data, "LASF", 4) == 0;
}

PointLayout readLasHeader(Bytes file)
{
    return HeaderParser(file).parse();
}

} // namespace neuralmesh
