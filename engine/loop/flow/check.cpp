// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow/check.h"

#include "loop/flow/checks.h"

namespace sphinx::loop {

std::vector<Issue> checkLoop(const LoopFacts& facts) {
    const Flow flow(facts);
    std::vector<Issue> issues;
    checkTimeSteps(facts, flow, issues);
    checkFields(facts, flow, issues);
    checkEnded(facts, flow, issues);
    checkAccumulation(facts, flow, issues);
    checkSpans(facts, flow, issues);
    checkLoads(facts, flow, issues);
    checkNeighbors(facts, flow, issues);
    return issues;
}

}  // namespace sphinx::loop
