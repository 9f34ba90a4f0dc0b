// SPDX-License-Identifier: GPL-3.0-or-later
// By calls of Windows.
#include "samplers/files/mapped_file.h"

#include <system_error>

#ifndef NOMINMAX // MinGW defines it
#define NOMINMAX
#endif
#include <windows.h>

#include "neuralmesh/errors.h"
#include "samplers/files/wide_name.h"

namespace neuralmesh {
namespace {

/// In the words of the C library where it has some, which are the same on every system.
[[noreturn]] void refuse(const char *what)
{
    const std::error_code code(static_cast<int>(GetLastError()), std::system_category());
    throw InvalidInput(std::string("the file cannot be ") + what + ": " +
                       code.default_error_condition().message() + ".");
}

} // namespace

struct MappedFile::OpenFile {
    /// So that folders open, too, and are refused as such; others may write to the file, or
    /// remove it.
    explicit OpenFile(const std::wstring &name)
        : handle(CreateFileW(name.c_str(), GENERIC_READ,
                             FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                             OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr))
    {
        if (handle == INVALID_HANDLE_VALUE)
            refuse("opened");
    }
    ~OpenFile() { CloseHandle(handle); }
    OpenFile(const OpenFile &) = delete;
    OpenFile &operator=(const OpenFile &) = delete;

    BY_HANDLE_FILE_INFORMATION status() const
    {
        BY_HANDLE_FILE_INFORMATION found = {};
        if (GetFileInformationByHandle(handle, &found) == 0)
            refuse("looked at");
        return found;
    }

    HANDLE handle;
    FILETIME modified = {};
};

namespace {

std::size_t sizeOf(const BY_HANDLE_FILE_INFORMATION &status)
{
    return static_cast<std::size_t>(status.nFileSizeHigh) << 32 | status.nFileSizeLow;
}

} // namespace

MappedFile::MappedFile(const std::string &path) : file_(std::make_unique<OpenFile>(wideName(path)))
{
    const bool isOnDisk = GetFileType(file_->handle) == FILE_TYPE_DISK;
    const BY_HANDLE_FILE_INFORMATION status =
        isOnDisk ? file_->status() : BY_HANDLE_FILE_INFORMATION();
    if (!isOnDisk || (status.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0)
        throw InvalidInput("it is no ordinary file but a folder, a pipe or a device.");
    if (sizeOf(status) == 0)
        throw InvalidInput("the file is empty.");
    const HANDLE mapping = CreateFileMappingW(file_->handle, nullptr, PAGE_READONLY, 0, 0, nullptr);
    if (mapping == nullptr)
        refuse("mapped into memory");
    const void *const start = MapViewOfFile(mapping, FILE_MAP_READ, 0, 0, 0);
    CloseHandle(mapping); // the view keeps it
    if (start == nullptr)
        refuse("mapped into memory");
    bytes_ = {static_cast<const unsigned char *>(start), sizeOf(status)};
    file_->modified = status.ftLastWriteTime;
}

MappedFile::~MappedFile()
{
    UnmapViewOfFile(bytes_.data);
}

// Windows takes no such hints for a mapping.
void MappedFile::expectPass() const
{
}
void MappedFile::expectRandomReads() const
{
}

bool MappedFile::hasChanged() const
{
    const BY_HANDLE_FILE_INFORMATION status = file_->status();
    return sizeOf(status) != bytes_.size ||
           CompareFileTime(&status.ftLastWriteTime, &file_->modified) != 0;
}

} // namespace neuralmesh
