// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/read_file.h"

#include "core/errors.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

namespace sphinx {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
    throw FileError("cannot read " + path.string() + ": " + reason);
}

}  // namespace

std::string readFile(const std::filesystem::path& path, std::uint64_t limit, FileKinds kinds) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (error) fail(path, error.message());
    if (!fs::exists(status)) fail(path, std::strerror(ENOENT));
    if (fs::is_directory(status)) fail(path, "it is a folder");
    // Of a device there is no end, and for what a pipe has to say nobody knows how long to wait.
    const bool pipe = fs::is_fifo(status) && kinds == FileKinds::pipe_too;
    if (!fs::is_regular_file(status) && !pipe) fail(path, "it is no regular file");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) fail(path, std::strerror(errno));
    std::string text;
    char part[1 << 16];
    while (stream.read(part, sizeof part) || stream.gcount() > 0) {
        text.append(part, static_cast<std::size_t>(stream.gcount()));
        if (text.size() > limit)
            fail(path, "it has more than the " + std::to_string(limit) + " bytes expected at most");
    }
    if (stream.bad()) fail(path, std::strerror(errno));
    return text;
}

}  // namespace sphinx
