// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace sphinx {

struct MemoryLimit {
    double bytes;
    bool of_group;  ///< else of the machine
};

/// What this process may have at most: the memory of the machine or, where that is less, what its
/// group of processes (cgroup, of either version) may have, or one of the groups around that.
/// `root` stands in for the root of the file system.
MemoryLimit memoryLimit(const std::filesystem::path& root = "/");

}  // namespace sphinx
