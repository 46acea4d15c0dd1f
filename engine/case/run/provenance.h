// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/file/provenance.h"

#include <string>

namespace sphinx::run {

std::string programVersion();  ///< "0.1.0"
std::string programCommit();   ///< of the sources, with "+changes" when they differ; or "unknown"
/// Vector instruction set that the executable was compiled for: results are the same bits for one
/// binary on one instruction set.
std::string instructionSet();
/// Where results of this run come from, for every result file.
io::Provenance makeProvenance(int threads);

}  // namespace sphinx::run
