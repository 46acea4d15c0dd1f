// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"

#include <string>
#include <vector>

namespace sphinx::model {

/// Sets velocity, density, mass, volume and pressure of all particles of a real body. The mass of a
/// fluid follows from its initial pressure through the equation of state.
template <int Dim>
void setInitialValues(const Body& source, const std::vector<double>& volumes, double time,
                      sphinx::Body<Dim>& body);

/// Names of the fields that have a value before the first step.
std::vector<std::string> initialFields(const Case& model, const Body& body);

}  // namespace sphinx::model
