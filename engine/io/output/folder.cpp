// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/output/folder.h"

#include "core/errors.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

namespace sphinx::io {
namespace {

/// In an order that leaves nothing misleading when it is interrupted: the restarts go first, so
/// that no run goes on from them without its other results, and the mark of a results folder last.
void emptyFolder(const Path& folder) {
    std::error_code error;
    const auto remove = [&](const Path& path) {
        if (!error) std::filesystem::remove_all(path, error);
    };
    remove(folder / "restart");
    std::vector<Path> others;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (entry.path().filename() != resolved_case_name) others.push_back(entry.path());
    for (const Path& path : others) remove(path);
    remove(folder / resolved_case_name);
    if (error) throw FileError("cannot empty " + folder.string() + ": " + error.message());
}

/// A run that was killed right at its start leaves no more than the unfinished mark.
bool isOurs(const Path& folder) {
    const Path mark = folder / resolved_case_name;
    return isThere(mark) || isThere(temporaryName(mark));
}

}  // namespace

OutputFolder::OutputFolder(const Path& path, ExistingResults existing) : path_(path) {
    makeFolder(path);
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0)
        throw FileError("cannot open folder " + path.string() + ": " + std::strerror(errno));
    try {
        // The lock goes with the process, however it ends.
        if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
            throw FileError(errno == EWOULDBLOCK
                                ? "another run is writing to " + path.string()
                                : "cannot lock " + path.string() + ": " + std::strerror(errno));
        std::error_code error;
        const bool empty = std::filesystem::is_empty(path, error);
        if (error) throw FileError("cannot read " + path.string() + ": " + error.message());
        if (empty || existing == ExistingResults::keep) return;
        if (existing == ExistingResults::refuse && !isOurs(path))
            throw FileError(path.string() +
                            " is not empty and holds no results of sphinx; --output DIR writes "
                            "elsewhere");
        if (existing == ExistingResults::refuse)
            throw FileError(path.string() +
                            " holds results already; --resume goes on with them, --overwrite "
                            "replaces them, --output DIR writes elsewhere");
        if (!isOurs(path))
            throw FileError(path.string() + " is not a folder of results (no " +
                            resolved_case_name + " in it), so it is not overwritten");
        emptyFolder(path);
    } catch (...) {
        ::close(descriptor_);
        throw;
    }
}

void OutputFolder::requireInPlace() const {
    struct stat locked {
    }, named{};
    if (::fstat(descriptor_, &locked) == 0 && ::stat(path_.c_str(), &named) == 0 &&
        locked.st_dev == named.st_dev && locked.st_ino == named.st_ino)
        return;
    throw FileError("the folder " + path_.string() +
                    " was removed or renamed while the run wrote to it");
}

OutputFolder::~OutputFolder() { ::close(descriptor_); }

}  // namespace sphinx::io
