// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "bodies/body.h"

#include "bodies/shares.h"

#include <algorithm>

namespace sphinx::bodies {

template <int Dim>
void Body<Dim>::follow(const particles::Remap& remap) {
    if (parts.empty()) return;
    const auto& start = particles.vector(fields::initial_position);
    for (BodyPart<Dim>& part : parts) {
        AlignedVector<Index> now;
        for (const Index i : part.particles)
            if (const Index place = remap.to(i); place != particles::Remap::none)
                now.push_back(place);
        std::sort(now.begin(), now.end());
        for (std::size_t i = remap.carried(); part.shape && i < remap.after(); ++i)
            if (part.shape->contains(start[i])) now.push_back(static_cast<Index>(i));
        part.particles = std::move(now);
    }
    if (isElastic()) findShares(*this);
}

template void Body<2>::follow(const particles::Remap&);
template void Body<3>::follow(const particles::Remap&);

}  // namespace sphinx::bodies
