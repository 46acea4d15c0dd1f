// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "loop/flow/facts.h"

#include <map>
#include <set>
#include <string>

namespace sphinx::run {

/// Fields that a restart holds, by body: those that the loop reads before it writes them anew, and
/// those that only outputs read and that no line writes in every outermost step (initial values,
/// results of start lines and of lines under `every`). Without id and position, which always
/// belong to it.
std::map<std::string, std::set<std::string>> restartFields(const loop::LoopFacts& facts);

}  // namespace sphinx::run
