// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/output_folder.h"

#include "core/errors.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace sphinx::io {
namespace {

void emptyFolder(const Path& folder) {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        std::filesystem::remove_all(entry.path(), error);
        if (error) break;
    }
    if (error) throw FileError("cannot empty " + folder.string() + ": " + error.message());
}

}  // namespace

OutputFolder::OutputFolder(const Path& path, ExistingResults existing) : path_(path) {
    makeFolder(path);
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0)
        throw FileError("cannot open folder " + path.string() + ": " + std::strerror(errno));
    try {
        // The lock goes with the process, however it ends.
        if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
            throw FileError("another run is writing to " + path.string());
        std::error_code error;
        const bool empty = std::filesystem::is_empty(path, error);
        if (error) throw FileError("cannot read " + path.string() + ": " + error.message());
        if (empty || existing == ExistingResults::keep) return;
        if (existing == ExistingResults::refuse)
            throw FileError(path.string() +
                            " holds results already; --resume goes on with them, --overwrite "
                            "replaces them, --output DIR writes elsewhere");
        if (!std::filesystem::exists(path / resolved_case_name))
            throw FileError(path.string() + " is not a folder of results (no " +
                            resolved_case_name + " in it), so it is not overwritten");
        emptyFolder(path);
    } catch (...) {
        ::close(descriptor_);
        throw;
    }
}

OutputFolder::~OutputFolder() { ::close(descriptor_); }

}  // namespace sphinx::io
