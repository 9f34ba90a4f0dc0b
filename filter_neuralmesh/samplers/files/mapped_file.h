// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace neuralmesh {

/// Bytes that someone else owns, as many as `size`.
struct Bytes {
    const unsigned char *data = nullptr;
    std::size_t size = 0;
};

/// A file mapped into memory for reading, by calls of the system, which no other file makes:
/// mapped_file_posix.cpp or mapped_file_windows.cpp. Its pages are the system's, which takes them
/// back when it needs them, and count as no memory of the process.
class MappedFile {
public:
    /// path: as the system has it; on Windows in UTF-8. Throws InvalidInput with a sentence,
    /// without the file's name, where the file is missing, no ordinary file, empty, or cannot be
    /// read.
    explicit MappedFile(const std::string &path);
    ~MappedFile();
    MappedFile(const MappedFile &) = delete;
    MappedFile &operator=(const MappedFile &) = delete;

    Bytes bytes() const { return bytes_; }

    /// Tell the system what comes: one pass from the front, or reads here and there, for which it
    /// should not read ahead.
    void expectPass() const;
    void expectRandomReads() const;

    /// Whether the file is no longer as long as when it was opened, or has been written to. Reading
    /// behind the end of a file that shrinks ends the process (SIGBUS), which asking before each
    /// batch of reads makes unlikely and cannot rule out; Windows lets nobody cut such a file.
    bool hasChanged() const;

private:
    struct OpenFile; ///< what the system calls it, and when it was last written to

    std::unique_ptr<OpenFile> file_;
    Bytes bytes_;
};

} // namespace neuralmesh
