// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "bodies/shares.h"

#include <algorithm>

namespace sphinx::bodies {

template <int Dim>
double outside(Body<Dim>& body, const BodyPart<Dim>& part, std::size_t i) {
    const auto& start = body.particles.vector(fields::initial_position);
    const double share = 0.5 + part.shape->signedDistance(start[i]) / body.spacing;
    constexpr double rounding = 1e-6;  // of the places of a lattice
    return share < rounding ? 0 : share > 1 - rounding ? 1 : share;
}

template <int Dim>
void findShares(Body<Dim>& body) {
    std::vector<double>& shares = body.elastic().shares;
    shares.clear();
    for (const BodyPart<Dim>* part : body.elastic().clamps) {
        shares.resize(body.size(), 1);
        for (std::size_t i = 0; i < body.size(); ++i)
            shares[i] = std::min(shares[i], outside(body, *part, i));
    }
}

template double outside(Body<2>&, const BodyPart<2>&, std::size_t);
template double outside(Body<3>&, const BodyPart<3>&, std::size_t);
template void findShares(Body<2>&);
template void findShares(Body<3>&);

}  // namespace sphinx::bodies
