// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/files/mapped_file.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "neuralmesh/errors.h"

namespace neuralmesh {
namespace {

/// Closes a descriptor on the way out, unless it is released.
class OpenFile {
public:
    explicit OpenFile(const char *path) : descriptor_(open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK))
    {
        if (descriptor_ < 0)
            throw InvalidInput(std::string("the file cannot be opened: ") + std::strerror(errno) +
                               ".");
    }
    ~OpenFile()
    {
        if (descriptor_ >= 0)
            close(descriptor_);
    }
    OpenFile(const OpenFile &) = delete;
    OpenFile &operator=(const OpenFile &) = delete;

    int descriptor() const { return descriptor_; }
    int release() { return std::exchange(descriptor_, -1); }

private:
    int descriptor_;
};

struct stat statusOf(int descriptor)
{
    struct stat status = {};
    if (fstat(descriptor, &status) != 0)
        throw InvalidInput(std::string("the file cannot be looked at: ") + std::strerror(errno) +
                           ".");
    return status;
}

std::int64_t modificationTime(const struct stat &status)
{
    return static_cast<std::int64_t>(status.st_mtim.tv_sec) * 1000000000 + status.st_mtim.tv_nsec;
}

} // namespace

MappedFile::MappedFile(const std::string &path)
{
    // Not blocking: a pipe without a writer would never open.
    OpenFile file(path.c_str());
    const struct stat status = statusOf(file.descriptor());
    if (!S_ISREG(status.st_mode))
        throw InvalidInput("it is no ordinary file but a folder, a pipe or a device.");
    if (status.st_size == 0)
        throw InvalidInput("the file is empty.");
    const auto size = static_cast<std::size_t>(status.st_size);
    void *const start = mmap(nullptr, size, PROT_READ, MAP_SHARED, file.descriptor(), 0);
    if (start == MAP_FAILED)
        throw InvalidInput(std::string("the file cannot be mapped into memory: ") +
                           std::strerror(errno) + ".");
    bytes_ = {static_cast<const unsigned char *>(start), size};
    modified_ = modificationTime(status);
    descriptor_ = file.release();
}

MappedFile::~MappedFile()
{
    munmap(const_cast<unsigned char *>(bytes_.data), bytes_.size);
    close(descriptor_);
}

void MappedFile::expectPass() const
{
    madvise(const_cast<unsigned char *>(bytes_.data), bytes_.size, MADV_SEQUENTIAL);
}

void MappedFile::expectRandomReads() const
{
    madvise(const_cast<unsigned char *>(bytes_.data), bytes_.size, MADV_RANDOM);
}

bool MappedFile::hasChanged() const
{
    const struct stat status = statusOf(descriptor_);
    return static_cast<std::size_t>(status.st_size) != bytes_.size ||
           modificationTime(status) != modified_;
}

} // namespace neuralmesh
