// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"

#include <string>

namespace sphinx::run {

/// What there is to know before a run.
struct CheckReport {
    std::string warnings;  ///< like Case::warnings, which they include
    std::string text;      ///< bodies with particle counts, memory, the loop as a tree, the outputs
                           ///< with their frames and disk space
};

/// Everything but stepping: makes the particles and checks the loop. Throws CaseError.
CheckReport checkCase(const model::Case& model);

}  // namespace sphinx::run
