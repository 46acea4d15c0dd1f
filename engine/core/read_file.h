// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

namespace sphinx {

/// Whole content of a file of at most `limit` bytes, which may be a pipe. Throws FileError.
std::string readFile(const std::filesystem::path& path,
                     std::uint64_t limit = std::numeric_limits<std::uint64_t>::max());

}  // namespace sphinx
