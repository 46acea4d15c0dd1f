// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/new_particles.h"
#include "case/model/model.h"

#include <string>
#include <vector>

namespace sphinx::build {

/// Gives new particles of a body the velocity and the pressure that the case has at their places.
template <int Dim>
void giveInitialValues(const model::Body& source, double time,
                       std::vector<bodies::NewParticle<Dim>>& particles);

/// Names of the fields that have a value before the first step, besides id and position: of those
/// that its particles have by themselves or that methods ask for.
std::vector<std::string> initialFields(const model::Case& model, const model::Body& body);

}  // namespace sphinx::build
