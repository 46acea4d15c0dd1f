// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace sphinx {

/// What a file may be besides a regular one.
enum class FileKinds { regular, pipe_too };

/// Whole content of a file of at most `limit` bytes. Throws FileError.
std::string readFile(const std::filesystem::path& path, std::uint64_t limit = 1ULL << 30,
                     FileKinds kinds = FileKinds::regular);

}  // namespace sphinx
