// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/memory_limit.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace sphinx {
namespace {

using Path = std::filesystem::path;

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// In the file `name` of a group or of one around it. Where there is no such file, or only the word
/// "max" in it, that group has no limit. In a container the path may be that of the host, of which
/// only the innermost group is there to see, as the outermost.
double leastLimit(const Path& hierarchy, const Path& group, const char* name) {
    double least = no_limit;
    const auto lookAt = [&](const Path& folder) {
        double limit = 0;
        if (std::ifstream(folder / name) >> limit) least = std::min(least, limit);
    };
    Path folder = hierarchy;
    lookAt(folder);
    for (const Path& part : group.lexically_normal().relative_path()) lookAt(folder /= part);
    return least;
}

double groupLimit(const Path& root) {
    const Path mounted = root / "sys/fs/cgroup";
    double least = no_limit;
    std::ifstream groups(root / "proc/self/cgroup");
    // "4:memory:/path", with more controllers after a comma; of version 2 "0::/path".
    for (std::string line; std::getline(groups, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = first == line.npos ? line.npos : line.find(':', first + 1);
        if (second == line.npos) continue;
        const std::string controllers = ',' + line.substr(first + 1, second - first - 1) + ',';
        const Path group = line.substr(second + 1);
        if (controllers == ",,")
            least = std::min(least, leastLimit(mounted, group, "memory.max"));
        else if (controllers.find(",memory,") != controllers.npos)
            least = std::min(least, leastLimit(mounted / "memory", group, "memory.limit_in_bytes"));
    }
    return least;
}

}  // namespace

MemoryLimit memoryLimit(const Path& root) {
    const double machine =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    const double group = groupLimit(root);
    return {std::min(machine, group), group < machine};
}

}  // namespace sphinx
