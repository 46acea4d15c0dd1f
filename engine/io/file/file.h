// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace sphinx::io {

using Path = std::filesystem::path;

/// An open file. Every failure is a FileError that names the file and the system's reason, like
/// "cannot write out/x.vtu: No space left on device". Nothing is buffered: what write() has
/// taken survives the death of the process. A file that someone removes meanwhile takes no more.
class File {
 public:
    static File create(const Path& path);      ///< new or emptied, for writing
    static File openAppend(const Path& path);  ///< at its end, created when missing
    static File openUpdate(const Path& path);  ///< an existing file, for reading and writing
    static File openRead(const Path& path);

    File(File&& other) noexcept;
    File& operator=(File&& other) noexcept;
    ~File();

    const Path& path() const { return path_; }
    void write(std::string_view bytes);
    void writeAt(std::uint64_t offset, std::string_view bytes);
    /// Reads up to `size` bytes; fewer only at the end of the file.
    std::size_t read(char* to, std::size_t size);
    void seek(std::uint64_t offset);
    std::uint64_t size() const;
    void truncate(std::uint64_t size);
    /// Returns when the disk has everything.
    void sync();
    /// Unlike the destructor it reports a failure.
    void close();

 private:
    File(const Path& path, int flags, const char* purpose);
    void requireName() const;

    Path path_;
    int descriptor_ = -1;
};

/// A file that appears complete or not at all: written as PATH.tmp and renamed by commit() or
/// publish(). Without them the temporary is removed and what was at PATH stays.
class AtomicFile {
 public:
    explicit AtomicFile(const Path& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view bytes) { file_.write(bytes); }
    void writeAt(std::uint64_t offset, std::string_view bytes) { file_.writeAt(offset, bytes); }
    /// The disk has it when this returns.
    void commit();
    /// It outlives the process; a machine that dies may take it along.
    void publish();

 private:
    Path path_;
    Path temporary_;  // kept: the destructor must not run out of memory
    File file_;
    bool committed_ = false;
};

/// Published files that the disk may not have yet.
class UnsyncedFiles {
 public:
    void add(const Path& path) { paths_.insert(path); }
    /// The disk has all that are still there, and their names, when this returns.
    void sync();

 private:
    std::set<Path> paths_;
};

/// The name under which a file is written before it is complete.
Path temporaryName(const Path& path);

/// Gives a file its final name, durably.
void renameFile(const Path& from, const Path& to);
void writeFileAtomically(const Path& path, std::string_view content);
/// Like AtomicFile::publish().
void publishFile(const Path& path, std::string_view content);
/// Makes renames and removals inside the folder durable.
void syncFolder(const Path& folder);
void makeFolder(const Path& folder);
/// Not those above it: a results folder that is gone does not come back.
void makeSubfolder(const Path& folder);
/// Whether something has that name; a FileError where that cannot be told.
bool isThere(const Path& path);
bool isFolder(const Path& path);  ///< likewise
/// Keeps a results file that cannot be continued as NAME.before_STEP.EXTENSION, with a warning.
void setAside(const Path& path, std::int64_t step);
/// A file that is not there is as good as removed.
void removeFile(const Path& path);

}  // namespace sphinx::io
