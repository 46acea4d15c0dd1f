// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "measure/observe_weights.h"

namespace sphinx::measure {

/// Weights of points that follow the material: those of the first update, of the same particles
/// ever after. A point moves by the mean displacement of its particles. Where a particle was
/// removed, the others take its part; the coverage tells what is left of the first one.
template <int Dim>
class MaterialWeights final : public ObserveWeights<Dim> {
 public:
    MaterialWeights(const bodies::Body<Dim>& observer, neighbors::Relations<Dim>& relations,
                    const bodies::Domain<Dim>& domain);

    void update() override;
    void transfer(Archive& archive) override;

 private:
    struct Anchor {
        std::uint32_t body = 0;
        std::int64_t id = 0;
        Index particle = 0;  // where the id was found last
        double weight = 0;   // its part of the first coverage
    };
    struct Point {
        Vec<Dim> offset = Vec<Dim>::Zero();  // from the mean of its particles
        std::vector<Anchor> anchors;
    };

    struct Arrays;

    void attach();
    void locate();
    Vec<Dim> meanPosition(const std::vector<ParticleWeight>& weights) const;

    using ObserveWeights<Dim>::observer_;
    using ObserveWeights<Dim>::weights_;
    using ObserveWeights<Dim>::coverage_;
    using ObserveWeights<Dim>::position_;
    const bodies::Domain<Dim>* domain_;
    std::vector<Point> attached_;  // empty before the first update
};

extern template class MaterialWeights<2>;
extern template class MaterialWeights<3>;

}  // namespace sphinx::measure
