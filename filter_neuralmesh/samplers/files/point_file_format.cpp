// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/files/point_file_format.h"

#include "neuralmesh/sampler_errors.h"
#include "samplers/files/las_header.h"
#include "samplers/files/npy_header.h"
#include "samplers/files/ply_header.h"

namespace neuralmesh {
namespace {

bool startsWith(Bytes file, const std::string &magic)
{
    return file.size >= magic.size() && std::memcmp(file.data, magic.data(), magic.size()) == 0;
}

[[noreturn]] void refuseFormat(Bytes file)
{
    if (startsWith(file, "ASTM-E57"))
        throw NeedsConversion(NeedsConversion::Format::e57);
    if (startsWith(file, "PK\x03\x04"))
        throw InvalidInput("it is a ZIP archive (NPZ is one too), so that no point can be read in "
                           "place. Unpack it first.");
    if (startsWith(file, "\x1f\x8b"))
        throw InvalidInput("it is compressed by gzip, so that no point can be read in place. "
                           "Unpack it first.");
    throw InvalidInput("it is of another format than those read in place: binary PLY, LAS and NPY. "
                       "Its first bytes are those of none.");
}

PointLayout readHeader(Bytes file)
{
    if (isPly(file))
        return readPlyHeader(file);
    if (isLas(file))
        return readLasHeader(file);
    if (isNpy(file))
        return readNpyHeader(file);
    refuseFormat(file);
}

} // namespace

PointLayout readPointLayout(Bytes file)
{
    PointLayout layout = readHeader(file);
    requireRoom(layout, file.size);
    return layout;
}

} // namespace neuralmesh
