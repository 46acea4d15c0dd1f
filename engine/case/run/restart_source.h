// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/restart/restart.h"

#include <string>
#include <vector>

namespace sphinx::run {

/// The restart that a run goes on from.
struct RestartSource {
    io::Path file;
    std::vector<std::string> warnings;  ///< newer ones that are damaged, and why
};

/// The newest restart of a results folder that is not damaged. Throws FileError when there is none.
RestartSource newestRestart(const io::Path& results);

/// Throws CaseError, with the difference, unless `theirs` was written by a run of the same physics.
void requireSamePhysics(const io::Path& file, const io::RestartHeader& theirs,
                        const io::RestartHeader& ours);

/// Throws FileError when the folder, about to be emptied, holds one of the files.
void requireOutside(const std::vector<io::Path>& files, const io::Path& folder);

}  // namespace sphinx::run
