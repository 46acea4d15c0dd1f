// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "loop/flow/facts.h"

#include <map>
#include <set>
#include <string>

namespace sphinx::loop {

/// What a restart must hold, by body: the fields whose value at the end of an outermost step is
/// read later, by a line of the loop or by an output, before it is written anew. Position, id, and
/// velocity where a body has one, always belong to it.
std::map<std::string, std::set<std::string>> liveFields(const LoopFacts& facts);

}  // namespace sphinx::loop
