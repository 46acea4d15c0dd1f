// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "loop/flow/check.h"
#include "loop/flow/flow.h"

#include <vector>

/// The parts of checkLoop(); each appends what it finds.
namespace sphinx::loop {

/// Time steps, fit policies, bodies that nothing moves.
void checkTimeSteps(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues);
/// Reads before writes.
void checkFields(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues);
/// Reads of what has ceased to be written.
void checkEnded(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues);
/// Accumulated fields.
void checkAccumulation(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues);
/// What must be done in turn, or between two lines: halves of a step, means.
void checkSpans(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues);
/// Loads that a solid gets must be minus what its fluid has felt.
void checkLoads(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues);
/// Neighbor lists.
void checkNeighbors(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues);

}  // namespace sphinx::loop
