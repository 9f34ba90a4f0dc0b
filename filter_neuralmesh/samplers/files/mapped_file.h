// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace neuralmesh {

/// Bytes that someone else owns, as many as `size`.
struct Bytes {
    const unsigned char *data = nullptr;
    std::size_t size = 0;
};

/// A file mapped into memory for reading, by POSIX calls, which no other file makes: its pages are
/// the system's, which takes them back when it needs them, and count as no memory of the process.
class MappedFile {
public:
    /// Throws InvalidInput with a sentence, without the file's name, where the file is missing, no
    /// ordinary file, empty, or cannot be read.
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
    /// batch of reads makes unlikely and cannot rule out.
    bool hasChanged() const;

private:
    int descriptor_ = -1;
    Bytes bytes_;
    std::int64_t modified_ = 0; ///< time of the last change, in nanoseconds
};

} // namespace neuralmesh
