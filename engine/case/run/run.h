// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"
#include "case/run/options.h"

namespace sphinx::run {

/// Runs a case; returns the exit code: 0, or 128 + the signal that stopped it after a restart was
/// written. Throws CaseError, PhysicsError, FileError.
int runCase(const model::Case& model, const RunOptions& options);

}  // namespace sphinx::run
