// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sphinx::io {

/// Where results come from: version, commit, compiler, flags, processor, threads, date. Names are
/// lower_snake_case words; every result file carries them.
struct Provenance {
    std::vector<std::pair<std::string, std::string>> entries;
};

}  // namespace sphinx::io
