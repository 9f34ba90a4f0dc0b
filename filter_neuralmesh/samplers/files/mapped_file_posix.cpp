// SPDX-License-Identifier: GPL-3.0-or-later
// By POSIX calls.
#include "samplers/files/mapped_file.h"

#include <cerrno>
#include <cstdint>
#include <cstring>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "neuralmesh/errors.h"

namespace neuralmesh {
namespace {

[[noreturn]] void refuse(const char *what)
{
    throw InvalidInput(std::string("the file cannot be ") + what + ": " + std::strerror(errno) +
                       ".");
}

struct stat statusOf(int descriptor)
{
    struct stat status = {};
    if (fstat(descriptor, &status) != 0)
        refuse("looked at");
    return status;
}

std::int64_t modificationTime(const struct stat &status)
{
    return static_cast<std::int64_t>(status.st_mtim.tv_sec) * 1000000000 + status.st_mtim.tv_nsec;
}

} // namespace

struct MappedFile::OpenFile {
    /// Not blocking: a pipe without a writer would never open.
    explicit OpenFile(const char *path) : descriptor(open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK))
    {
        if (descriptor < 0)
            refuse("opened");
    }
    ~OpenFile() { close(descriptor); }
    OpenFile(const OpenFile &) = delete;
    OpenFile &operator=(const OpenFile &) = delete;

    int descriptor;
    std::int64_t modified = 0; ///< in nanoseconds
};

MappedFile::MappedFile(const std::string &path) : file_(std::make_unique<OpenFile>(path.c_str()))
{
    const struct stat status = statusOf(file_->descriptor);
    if (!S_ISREG(status.st_mode))
        throw InvalidInput("it is no ordinary file but a folder, a pipe or a device.");
    if (status.st_size == 0)
        throw InvalidInput("the file is empty.");
    const auto size = static_cast<std::size_t>(status.st_size);
    void *const start = mmap(nullptr, size, PROT_READ, MAP_SHARED, file_->descriptor, 0);
    if (start == MAP_FAILED)
        refuse("mapped into memory");
    bytes_ = {static_cast<const unsigned char *>(start), size};
    file_->modified = modificationTime(status);
}

MappedFile::~MappedFile()
{
    munmap(const_cast<unsigned char *>(bytes_.data), bytes_.size);
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
    const struct stat status = statusOf(file_->descriptor);
    return static_cast<std::size_t>(status.st_size) != bytes_.size ||
           modificationTime(status) != file_->modified;
}

} // namespace neuralmesh
