// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"

#include <string>

namespace sphinx::run {

/// The part of a resolved case that the physics depends on, as YAML: without title, observers,
/// outputs and end time, which a resumed run may change, and with what files hold instead of where
/// they lie.
std::string physicsText(const model::Case& model);

/// Lines that only one of two texts has, at most `limit`: "- old" and "+ new".
std::string difference(const std::string& before, const std::string& after, std::size_t limit);

}  // namespace sphinx::run
