// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "loop/flow/facts.h"

#include <string>
#include <vector>

namespace sphinx::loop {

enum class Severity { warning, error };

struct Issue {
    Severity severity = Severity::error;
    int id = 0;  ///< of the line or the layer that it is about
    std::string message;
};

/// Everything that is wrong with a loop as far as its declarations tell: layers without a time
/// step, fields read before anything wrote them or after the window of what writes them, halves of
/// a step out of turn, particles reordered between them, stale neighbor lists, accumulated fields
/// that spoil each other, neighbor lists that a resumed run could not have. In the order of the
/// checks, then of the loop.
std::vector<Issue> checkLoop(const LoopFacts& facts);

}  // namespace sphinx::loop
