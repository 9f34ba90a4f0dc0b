// SPDX-License-Identifier: GPL-3.0-or-later
// Valid point files of each format, written byte by byte, that the tests read or break.
#pragma once

#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "samplers/files/mapped_file.h"
#include "tests/points_for_tests.h"

namespace neuralmesh::test {

inline Bytes bytesOf(const std::string &content)
{
    return {reinterpret_cast<const unsigned char *>(content.data()), content.size()};
}

template <class T> void append(std::string &content, T number, bool bigEndian = false)
{
    char bytes[sizeof(T)];
    std::memcpy(bytes, &number, sizeof(T));
    const std::string text(bytes, sizeof(T));
    content += bigEndian ? std::string(text.rbegin(), text.rend()) : text;
}

template <class T> void put(std::string &content, std::size_t position, T number)
{
    std::memcpy(&content[position], &number, sizeof(T));
}

/// x, y, z of type T.
template <class T> std::string plyOf(const WorldPoints &points, bool bigEndian = false)
{
    const std::string type = sizeof(T) == 4 ? "float" : "double";
    std::string content = "ply\nformat binary_";
    content += bigEndian ? "big" : "little";
    content += "_endian 1.0\nelement vertex " + std::to_string(points.size()) + "\n";
    for (const char *const axis : {"x", "y", "z"})
        content += "property " + type + " " + axis + "\n";
    content += "end_header\n";
    for (const vcg::Point3d &p : points)
        for (int axis = 0; axis < 3; ++axis)
            append(content, static_cast<T>(p[axis]), bigEndian);
    return content;
}

template <class T> std::string npyOf(const WorldPoints &points, bool bigEndian = false)
{
    const std::string type = (bigEndian ? ">f" : "<f") + std::to_string(sizeof(T));
    std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" +
                         std::to_string(points.size()) + ", 3), }";
    header += std::string(127 - 10 - header.size(), ' ') + '\n';
    std::string content = "\x93NUMPY";
    content += '\x01';
    content += '\0';
    append(content, static_cast<std::uint16_t>(header.size()));
    content += header;
    for (const vcg::Point3d &p : points)
        for (int axis = 0; axis < 3; ++axis)
            append(content, static_cast<T>(p[axis]), bigEndian);
    return content;
}

/// LAS 1.2 or 1.4, point format 0 or 6, coordinates in thousandths, bounds as given.
inline std::string lasOf(const WorldPoints &points, int minor, const vcg::Point3d &shift,
                         const vcg::Box3d &bounds)
{
    const std::size_t headerSize = minor == 4 ? 375 : 227;
    const std::size_t pointSize = minor == 4 ? 30 : 20;
    std::string content(headerSize, '\0');
    std::memcpy(&content[0], "LASF", 4);
    content[24] = 1;
    content[25] = static_cast<char>(minor);
    put(content, 94, static_cast<std::uint16_t>(headerSize));
    put(content, 96, static_cast<std::uint32_t>(headerSize));
    content[104] = minor == 4 ? 6 : 0;
    put(content, 105, static_cast<std::uint16_t>(pointSize));
    if (minor == 4)
        put(content, 247, static_cast<std::uint64_t>(points.size()));
    else
        put(content, 107, static_cast<std::uint32_t>(points.size()));
    for (int axis = 0; axis < 3; ++axis) {
        const auto place = static_cast<std::size_t>(axis);
        put(content, 131 + 8 * place, 0.001);
        put(content, 155 + 8 * place, shift[axis]);
        put(content, 179 + 16 * place, bounds.max[axis]);
        put(content, 187 + 16 * place, bounds.min[axis]);
    }
    for (const vcg::Point3d &p : points) {
        std::string record(pointSize, '\0');
        for (int axis = 0; axis < 3; ++axis)
            put(record, 4 * static_cast<std::size_t>(axis),
                static_cast<std::int32_t>(std::lround((p[axis] - shift[axis]) / 0.001)));
        content += record;
    }
    return content;
}

/// A file of its own in the system's folder for such, removed at the end.
class TemporaryFile {
public:
    /// name: the beginning of its name, in UTF-8.
    explicit TemporaryFile(const std::string &content, const std::string &name = "neuralmesh")
    {
        std::random_device device;
        const std::string own = std::to_string(device()) + std::to_string(device());
        path_ = std::filesystem::temp_directory_path() / std::filesystem::u8path(name + "." + own);
        write(content);
    }
    ~TemporaryFile()
    {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile &) = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    /// Whether it was written: Windows refuses to cut a file that is mapped.
    bool write(const std::string &content) const
    {
        std::ofstream stream(path_, std::ios::binary);
        stream << content;
        return stream.good();
    }
    /// Write over what there is, without cutting the file first.
    void overwrite(const std::string &content) const
    {
        std::fstream(path_, std::ios::binary | std::ios::in | std::ios::out) << content;
    }
    std::string path() const { return path_.u8string(); }

private:
    std::filesystem::path path_;
};

} // namespace neuralmesh::test
