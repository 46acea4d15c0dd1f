// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/read_file.h"

#include "core/errors.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

namespace sphinx {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
    throw FileError("cannot read " + path.string() + ": " + reason);
}

}  // namespace

std::string readFile(const std::filesystem::path& path, std::uint64_t limit) {
    std::error_code not_there;
    if (std::filesystem::is_directory(path, not_there)) fail(path, "it is a folder");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) fail(path, std::strerror(errno));
    std::error_code no_size;  // of a pipe
    const std::uintmax_t size = std::filesystem::file_size(path, no_size);
    if (!no_size && size > limit)
        fail(path, std::to_string(size) + " bytes are more than the " + std::to_string(limit) +
                       " expected at most");
    std::ostringstream text;
    text << stream.rdbuf();
    if (text.bad()) fail(path, std::strerror(errno));
    return std::move(text).str();
}

}  // namespace sphinx
