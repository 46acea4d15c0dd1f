// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"
#include "bodies/domain.h"

namespace sphinx::bodies {

/// How a body that does not deform stands: what was at R is at to + turn (R - from).
template <int Dim>
struct Pose {
    Mat<Dim> turn = Mat<Dim>::Identity();
    Vec<Dim> from = Vec<Dim>::Zero();
    Vec<Dim> to = Vec<Dim>::Zero();
    /// By how much the particles are elsewhere, at most; length.
    double misfit = 0;

    Vec<Dim> operator()(const Vec<Dim>& start) const { return to + turn * (start - from); }
};

/// That of a body, or of a part of it, by where its particles began and where they are: the
/// rotation and translation of least squares (Kabsch's). Nothing that has not moved is turned by
/// round-off. In 3D particles in one line do not tell how they have turned about it; NaN then.
/// Across periodic sides the particles of a body that turns are nearer to each other than half a
/// period.
template <int Dim>
Pose<Dim> poseOf(const Body<Dim>& body, const BodyPart<Dim>* part, const Domain<Dim>& domain);

}  // namespace sphinx::bodies
