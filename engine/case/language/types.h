// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The types of values that only the blocks of a case have.

#include "case/language/blocks.h"

#include <functional>

namespace sphinx::language {

/// {time: T} | {steps: N, layer: NAME} | {wall_time: 30 min}, as the block `every` declares it.
void declareEvery(input::Registry& registry);
input::Type<input::Every> every(const input::Registry& registry);

/// Entries of a block whose `type` is chosen from the registry.
input::Type<std::vector<input::Component>> components(input::Kind kind);
/// The same with the keys that all outputs share.
input::Type<std::vector<NamedOutput>> outputs(const input::Declaration& common);
input::Type<std::vector<NamedBody>> namedBodies(const input::Declaration& body);

/// Declares the block `multibody`.
void declareMultibody(input::Registry& registry);

input::Type<model::Seen> seen();
/// space | material | {body: NAME}.
input::Type<model::Followed> followed();
input::Type<model::TimeStep> timeStep();
/// A line of the loop; uses the blocks `layer` and `run`.
input::Type<model::Step> step(const input::Registry& registry);

/// The name of a kernel of the registry.
input::Type<kernels::KernelType> kernel(const input::Registry& registry);
/// The variables of the case: defines them in the reader's scope.
input::Type<input::Node> variables();

/// `type`, with something to do once a value has been read.
std::shared_ptr<const input::TypeBase> withEffect(
    std::shared_ptr<const input::TypeBase> type,
    std::function<void(input::Reader&, const void* value)> effect);

}  // namespace sphinx::language
