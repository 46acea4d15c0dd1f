// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/run/restart_source.h"

#include "case/run/physics_text.h"
#include "core/errors.h"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>

namespace sphinx::run {
namespace {

/// Absolute and without links, as far as the path exists.
io::Path resolved(const io::Path& path) {
    std::error_code error;
    const io::Path result = std::filesystem::weakly_canonical(path.empty() ? "." : path, error);
    if (error)
        throw FileError(fmt::format("cannot look at {}: {}", path.string(), error.message()));
    return result;
}

bool isBelow(const io::Path& outer, const io::Path& inner) {
    return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first ==
           outer.end();
}

}  // namespace

RestartSource newestRestart(const io::Path& results) {
    const io::Path folder = results / "restart";
    const io::RestartSearch search = io::findNewestValid(folder);
    RestartSource source{search.found, {}};
    for (const auto& [path, why] : search.skipped)
        source.warnings.push_back(fmt::format("skipped {}: {}", path.string(), why));
    if (!source.file.empty()) return source;
    std::string message = fmt::format(
        "no valid restart in {}; to begin anew leave out --resume, and add --overwrite if there "
        "are results",
        folder.string());
    for (const std::string& line : source.warnings) message += "\n" + line;
    throw FileError(message);
}

void requireSamePhysics(const io::Path& file, const io::RestartHeader& theirs,
                        const io::RestartHeader& ours) {
    if (theirs.digest == ours.digest && theirs.dimension == ours.dimension) return;
    throw CaseError(
        fmt::format("error: the case is not the one that {} was written by; only title, "
                    "observers, outputs, loop.end_time and domain.lost_particles may change:\n{}",
                    file.string(), difference(theirs.case_text, ours.case_text, 20)));
}

void requireOutside(const std::vector<io::Path>& files, const io::Path& folder) {
    const io::Path outer = resolved(folder);
    for (const io::Path& file : files) {
        // A link that lies in the folder would go, and so would what a link elsewhere leads to.
        const io::Path link = resolved(file.parent_path()) / file.filename();
        if (isBelow(outer, link) || isBelow(outer, resolved(file)))
            throw FileError(
                fmt::format("--overwrite would remove {}, which the run reads; write to another "
                            "folder or copy it elsewhere first",
                            file.string()));
    }
}

}  // namespace sphinx::run
