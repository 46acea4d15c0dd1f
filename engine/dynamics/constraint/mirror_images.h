// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/part.h"
#include "dynamics/words.h"

#include <vector>

namespace sphinx::dynamics::constraint {

/// Part of the motion of an image: u_image += weight u_real.
struct ImageLink {
    Index image;
    Index real;  ///< particle that is no image
    double weight;
};

/// Links that make the images of a part (ElasticRole::isImage) follow the rest of their body, so
/// that the displacement is zero on the surface of the part's shape. The motion grows evenly from
/// the surface to a point outside, and to the same size the other way inside. That point is the
/// mirror point of the image in the surface between it and the nearest particle that is no image
/// (the weights of its links sum to -1); where the surface cuts the image's cell, it is three
/// quarters of a spacing away from the surface (the weights sum to the image's signed distance over
/// that). Where a particle stands at the point, it alone is linked, otherwise those around, by
/// moving least squares (exact for linear displacements; Liu, Li & Belytschko 1997,
/// doi:10.1002/(SICI)1097-0207(19970430)40:8<1081). Images whose point lies outside of the body,
/// and those that no strained particle sees, have no link and stay at rest.
template <int Dim>
std::vector<ImageLink> mirrorImages(const Part<Dim>& part, const std::vector<Index>& images,
                                    const ReferenceRelation<Dim>& relation,
                                    const Domain<Dim>& domain);

}  // namespace sphinx::dynamics::constraint
