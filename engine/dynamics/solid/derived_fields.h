// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/words.h"

namespace sphinx::dynamics::solid {

/// Computes a derived field (FieldKind::derived), which the body has, of all particles:
/// displacement u = r - R; Green-Lagrange strain E = (F^T F - I)/2; first Piola-Kirchhoff stress
/// P = F S; Cauchy stress F S F^T / det F and its von Mises stress, in 2D of plane strain (with
/// sigma_33); strain energy per reference volume. Stresses are those of the elastic law, without
/// damping.
template <int Dim>
void derive(Body<Dim>& body, const sphinx::particles::FieldInfo& field);

}  // namespace sphinx::dynamics::solid
