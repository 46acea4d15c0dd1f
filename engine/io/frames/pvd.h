// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/file/file.h"
#include "io/file/provenance.h"

#include <cstdint>
#include <vector>

namespace sphinx::io {

/// ParaView's list of the files of a time series.
struct PvdEntry {
    std::int64_t frame = 0;  ///< number of the frame since the start of the run
    double time = 0;
    std::string file;  ///< relative to the list
};

std::string pvdText(const std::vector<PvdEntry>& entries, const Provenance& provenance);

/// Reads a list of this text; a missing file is an empty list. Throws FileError.
std::vector<PvdEntry> readPvd(const Path& path);

}  // namespace sphinx::io
