// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/file/file.h"

#include "core/errors.h"
#include "core/log.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace sphinx::io {
namespace {

[[noreturn]] void fail(const char* purpose, const Path& path, int code) {
    throw FileError(std::string("cannot ") + purpose + " " + path.string() + ": " +
                    std::strerror(code));
}

void giveName(const Path& from, const Path& to) {
    if (::rename(from.c_str(), to.c_str()) != 0) fail("write", to, errno);
}

constexpr mode_t file_mode = 0666;  // the user's umask takes away

}  // namespace

File::File(const Path& path, int flags, const char* purpose) : path_(path) {
    do {
        descriptor_ = ::open(path.c_str(), flags | O_CLOEXEC, file_mode);
    } while (descriptor_ < 0 && errno == EINTR);
    if (descriptor_ < 0) fail(purpose, path_, errno);
    struct stat status {};
    if (::fstat(descriptor_, &status) == 0 && S_ISDIR(status.st_mode)) {
        ::close(descriptor_);
        descriptor_ = -1;
        fail(purpose, path_, EISDIR);
    }
}

File File::create(const Path& path) { return File(path, O_WRONLY | O_CREAT | O_TRUNC, "write"); }
File File::openAppend(const Path& path) {
    return File(path, O_WRONLY | O_CREAT | O_APPEND, "write");
}
File File::openUpdate(const Path& path) { return File(path, O_RDWR, "write"); }
File File::openRead(const Path& path) { return File(path, O_RDONLY, "read"); }

File::File(File&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

File& File::operator=(File&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

File::~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void File::requireName() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink == 0)
        throw FileError("cannot go on with " + path_.string() +
                        ": it was removed or replaced while it was being written");
}

void File::write(std::string_view bytes) {
    requireName();
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail("write", path_, errno);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void File::writeAt(std::uint64_t offset, std::string_view bytes) {
    requireName();
    while (!bytes.empty()) {
        const ssize_t written =
            ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail("write", path_, errno);
        bytes.remove_prefix(static_cast<std::size_t>(written));
        offset += static_cast<std::uint64_t>(written);
    }
}

std::size_t File::read(char* to, std::size_t size) {
    std::size_t done = 0;
    while (done < size) {
        const ssize_t count = ::read(descriptor_, to + done, size - done);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail("read", path_, errno);
        if (count == 0) break;
        done += static_cast<std::size_t>(count);
    }
    return done;
}

void File::seek(std::uint64_t offset) {
    if (::lseek(descriptor_, static_cast<off_t>(offset), SEEK_SET) < 0) fail("read", path_, errno);
}

std::uint64_t File::size() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail("read", path_, errno);
    return static_cast<std::uint64_t>(status.st_size);
}

void File::truncate(std::uint64_t size) {
    if (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0) fail("write", path_, errno);
}

void File::sync() {
    // EINVAL: a device or pipe, which has nothing to sync.
    if (::fsync(descriptor_) != 0 && errno != EINVAL) fail("write", path_, errno);
}

void File::close() {
    if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) fail("write", path_, errno);
}

Path temporaryName(const Path& path) { return path.string() + ".tmp"; }

AtomicFile::AtomicFile(const Path& path)
    : path_(path), temporary_(temporaryName(path)), file_(File::create(temporary_)) {}

AtomicFile::~AtomicFile() {
    if (!committed_) ::unlink(temporary_.c_str());
}

void AtomicFile::commit() {
    file_.sync();
    publish();
    syncFolder(path_.parent_path());
}

void AtomicFile::publish() {
    file_.close();
    giveName(temporary_, path_);
    committed_ = true;
}

void UnsyncedFiles::sync() {
    std::set<Path> folders;
    for (const Path& path : paths_) {
        if (!isThere(path)) continue;
        File::openRead(path).sync();
        folders.insert(path.parent_path());
    }
    for (const Path& folder : folders) syncFolder(folder);
    paths_.clear();
}

void renameFile(const Path& from, const Path& to) {
    giveName(from, to);
    syncFolder(to.parent_path());
}

void writeFileAtomically(const Path& path, std::string_view content) {
    AtomicFile file(path);
    file.write(content);
    file.commit();
}

void publishFile(const Path& path, std::string_view content) {
    AtomicFile file(path);
    file.write(content);
    file.publish();
}

void syncFolder(const Path& folder) {
    const Path path = folder.empty() ? Path(".") : folder;
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) fail("write to", path, errno);
    const int result = ::fsync(descriptor);
    const int code = errno;
    ::close(descriptor);
    // EINVAL: some file systems cannot sync a folder; then there is nothing better to do.
    if (result != 0 && code != EINVAL) fail("write to", path, code);
}

void makeFolder(const Path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) fail("create folder", folder, error.value());
    if (!isFolder(folder)) fail("create folder", folder, ENOTDIR);
}

void makeSubfolder(const Path& folder) {
    std::error_code error;
    std::filesystem::create_directory(folder, error);
    if (error) fail("create folder", folder, error.value());
}

bool isThere(const Path& path) {
    std::error_code error;
    const bool result = std::filesystem::exists(path, error);
    if (error) fail("look at", path, error.value());
    return result;
}

bool isFolder(const Path& path) {
    std::error_code gone_meanwhile;
    return isThere(path) && std::filesystem::is_directory(path, gone_meanwhile);
}

void setAside(const Path& path, std::int64_t step) {
    Path kept = path;
    kept.replace_extension(".before_" + std::to_string(step) + path.extension().string());
    if (::rename(path.c_str(), kept.c_str()) != 0) fail("write", kept, errno);
    log::warning(path.string() +
                 " holds other quantities than the case now asks for; it is kept as " +
                 kept.filename().string() + " and a new one begun");
}

void removeFile(const Path& path) {
    if (::unlink(path.c_str()) != 0 && errno != ENOENT) fail("remove", path, errno);
}

}  // namespace sphinx::io
