// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/part.h"
#include "neighbors/relations.h"

#include <vector>

namespace sphinx::constraint {

/// Part of the motion of an image: u_image += weight u_real.
struct ImageLink {
    Index image;  ///< particle of the part
    Index real;   ///< particle of the rest of the body
    double weight;
};

/// Links that make the particles of a part the mirror images of the rest of their body, so that the
/// displacement is zero on the surface of the part's shape: the weights of each image sum to -1. An
/// image's mirror point is that in the surface between it and the nearest particle that is no
/// image; where a particle stands there, it alone is linked, otherwise those around, by moving
/// least squares (exact for linear displacements; Liu, Li & Belytschko 1997,
/// doi:10.1002/(SICI)1097-0207(19970430)40:8<1081). Images whose point lies outside of the body,
/// and those that no other particle sees, have no link and stay at rest.
template <int Dim>
std::vector<ImageLink> mirrorImages(const Part<Dim>& part, const ReferenceRelation<Dim>& relation,
                                    const Domain<Dim>& domain);

}  // namespace sphinx::constraint
