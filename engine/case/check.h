// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model.h"

#include <string>

namespace sphinx::model {

/// Everything but stepping: makes the particles and checks the loop. Returns what there is to know
/// before a run: warnings, bodies with particle counts, memory, the loop as a tree, the outputs
/// with their frames and disk space. Throws CaseError.
std::string checkCase(const Case& model);

}  // namespace sphinx::model
