// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What happens to a case between the reading of its values and the model.

#include "case/language/blocks.h"
#include "input/declaration/reader.h"

namespace sphinx::language {

/// Checks every reference: the named thing exists and is of the wanted kind; and that bodies are of
/// a material for their kind. One mistake is told once, however many references follow it.
void checkNames(const CaseBlock& block, const input::Node& root, input::Reader& reader);

/// Checks what several values say together; all names are right by now.
void checkSense(const CaseBlock& block, const input::UnitSystem& units,
                input::Diagnostics& diagnostics);

/// Warns of definitions in the main file that nothing uses.
void warnUnused(const CaseBlock& block, const input::Reader& reader);

/// The model of a block without errors; shapes are made here, which may report more.
model::Case makeModel(const CaseBlock& block, const input::UnitSystem& units,
                      input::Diagnostics& diagnostics);

/// nullptr when there is none.
const input::Component* findComponent(const std::vector<input::Component>& components,
                                      std::string_view name);
/// What a body of that kind and material is to others.
bodies::Role roleOf(BodyKind kind, const input::Component* material);
/// Words that a reference may ask of a body: its kind, its material's type and traits.
std::vector<std::string> bodyTraits(bodies::Role role, const input::Component* material);

}  // namespace sphinx::language
