// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"

#include <string>

namespace sphinx::run {

/// The resolved case as YAML that runs the same: every value with its origin as a comment
/// (default, case.yaml:31, --set).
std::string showCase(const model::Case& model);

}  // namespace sphinx::run
