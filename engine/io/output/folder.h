// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/file/file.h"

namespace sphinx::io {

/// What to do with a results folder that holds something already.
enum class ExistingResults {
    refuse,   ///< FileError that tells the three ways out
    replace,  ///< --overwrite: everything in it goes, if it is a results folder of ours
    keep,     ///< --resume: the run goes on in it
};

/// Name of the file that is written first into every results folder; a folder without it is never
/// emptied.
inline constexpr const char* resolved_case_name = "case.resolved.yaml";

/// The folder of one run, locked while this object lives: a second run in it is refused.
class OutputFolder {
 public:
    OutputFolder(const Path& path, ExistingResults existing);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    const Path& path() const { return path_; }
    /// Throws FileError where the folder is gone or its path leads to another one by now, in which
    /// another run may write.
    void requireInPlace() const;

 private:
    Path path_;
    int descriptor_ = -1;
};

}  // namespace sphinx::io
