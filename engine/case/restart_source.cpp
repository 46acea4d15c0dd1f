// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/restart_source.h"

#include "case/physics_text.h"
#include "core/errors.h"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>

namespace sphinx::model {

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
        fmt::format("error: the case is not the one that {} was written by; only title, outputs "
                    "and loop.end_time may change:\n{}",
                    file.string(), difference(theirs.case_text, ours.case_text, 20)));
}

void requireOutside(const io::Path& file, const io::Path& folder) {
    const io::Path inner = std::filesystem::weakly_canonical(file);
    const io::Path outer = std::filesystem::weakly_canonical(folder);
    if (std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end())
        throw FileError(
            fmt::format("--overwrite would remove {}; write to another folder or copy "
                        "the restart elsewhere first",
                        file.string()));
}

}  // namespace sphinx::model
