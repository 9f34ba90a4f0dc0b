// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/free_memory.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>

#include "neuralmesh/too_little_memory.h"

#if defined(__linux__)
#include <sys/resource.h>
#endif

namespace neuralmesh {
namespace {

/// Of a network and what is done with it, by vertex, at the least: what cannot fit is refused, what
/// may is tried. On a sphere, 5,000 and 10,000 vertices took 2,700 bytes each.
constexpr std::uint64_t bytesPerVertex = 2000;

/// Where the system does not say.
std::uint64_t unknown()
{
    return std::numeric_limits<std::uint64_t>::max();
}

std::string gigabytes(std::uint64_t bytes)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.1f GB", static_cast<double>(bytes) / 1e9);
    return text;
}

#if defined(__linux__)

/// Of a file of the kernel's that has a line "NAME:   NUMBER kB"; unknown without.
std::uint64_t bytesNamed(const char *path, const std::string &name)
{
    std::ifstream file(path);
    std::uint64_t kilobytes = 0;
    for (std::string word; file >> word;)
        if (word == name + ":" && file >> kilobytes)
            return 1024 * kilobytes;
    return unknown();
}

/// What a limit on the address space (ulimit -v) leaves.
std::uint64_t leftOfLimit()
{
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return unknown();
    const std::uint64_t used = bytesNamed("/proc/self/status", "VmSize");
    return used > limit.rlim_cur ? 0 : limit.rlim_cur - used;
}

#endif

} // namespace

std::uint64_t freeMemory()
{
#if defined(__linux__)
    const std::uint64_t available = bytesNamed("/proc/meminfo", "MemAvailable");
    const std::uint64_t swap = bytesNamed("/proc/meminfo", "SwapFree");
    const bool isKnown = available != unknown() && swap != unknown();
    return std::min(isKnown ? available + swap : unknown(), leftOfLimit());
#else
    return unknown();
#endif
}

void requireMemory(int vertices, std::uint64_t free)
{
    const auto count = static_cast<std::uint64_t>(vertices);
    if (count * bytesPerVertex > free)
        throw TooLittleMemory(count, count * bytesPerVertex, free);
}

TooLittleMemory::TooLittleMemory(std::uint64_t vertices, std::uint64_t bytesNeeded,
                                 std::uint64_t bytesFree)
    : InvalidInput(std::to_string(vertices) + " vertices need about " + gigabytes(bytesNeeded) +
                   " of memory, of which " + gigabytes(bytesFree) + " are free."),
      bytesNeeded_(bytesNeeded), bytesFree_(bytesFree)
{
}

std::string TooLittleMemory::sentence(const ParameterNames &names) const
{
    return names(Parameter::targetVertexCount) + ": " + what();
}

} // namespace neuralmesh
