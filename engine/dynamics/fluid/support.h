// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "dynamics/context.h"
#include "dynamics/group.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace sphinx::dynamics::fluid {

/// How much of its neighborhood a particle of a fluid has: S_i/S0, S_i = W(0) + sum_j W_ij over the
/// fluid, the solids and the other fluids that it sees, where a neighbor of another spacing counts
/// with V_j0/V_i0, and S0 the sum over the full lattice of the body. A particle has support if S_i
/// is nearer to S0 than that of the outermost row of a flat surface. Made in a method's
/// constructor.
template <int Dim>
class Support {
 public:
    Support(Context<Dim>& context, const Body<Dim>& body) : Support(context, body, true) {}
    /// S_i/S0.
    [[gnu::always_inline]] Wide share(const Group& group) const {
        Wide sum = own_ + load(self_->kernelSums(), group);
        for (const Term& term : terms_)
            sum += term.weight * load(term.relation->list.kernel_sum.data(), group);
        return sum / lattice_sum_;
    }
    /// Of what share() gives.
    LaneMask isLacking(Wide share) const { return share < least_share_; }
    [[gnu::always_inline]] LaneMask seesSolid(const Group& group) const {
        LaneMask sees = {};
        for (const Term& term : terms_)
            if (!term.fluid) sees |= load(term.relation->list.kernel_sum.data(), group) > 0;
        return sees;
    }
    /// No neighbor at all.
    [[gnu::always_inline]] LaneMask isAlone(const Group& group) const {
        LaneMask sees = load(self_->kernelSums(), group) > 0;
        for (const Term& term : terms_)
            sees |= load(term.relation->list.kernel_sum.data(), group) > 0;
        return ~sees;
    }

    /// With the present lists, before isCutOff(): particles that lack support tell their neighbors,
    /// also those of other fluids.
    void findSurface(std::size_t particles);
    /// Whether the particle or one of its neighbors lacks support: a surface cuts off a part of its
    /// own neighborhood.
    [[gnu::always_inline]] LaneMask isCutOff(const Group& group) const {
        const Index* slots = self_->slotsOf() + group.first;
        const auto at = [&](int k) -> std::int64_t {
            return -static_cast<std::int64_t>(lacks_[slots[k]] | told_[slots[k]]);
        };
        return LaneMask{at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
    }

 private:
    /// What the neighbors in one other body add to S_i, each of them.
    struct Term {
        const Relation<Dim>* relation;
        double weight;
        std::unique_ptr<Support> fluid;  ///< of another fluid; null: a solid
    };

    Support(Context<Dim>& context, const Body<Dim>& body, bool looks_at_others)
        : own_(body.kernel.value(0)),
          lattice_sum_(body.kernel.latticeSum()),
          least_share_(0.5 + 0.5 * body.kernel.surfaceSum() / lattice_sum_),
          self_(&context.relations.ownPairs(body)) {
        for (const Body<Dim>* other : body.sees)
            if (other != &body)
                terms_.push_back({&context.relations.flow(body, *other, {.kernel_sum = true}),
                                  std::pow(other->spacing / body.spacing, Dim),
                                  std::unique_ptr<Support>(looks_at_others && other->isFluid()
                                                               ? new Support(context, *other, false)
                                                               : nullptr)});
    }
    void hearFrom(const Term& fluid);

    double own_;          // W(0)
    double lattice_sum_;  // S0
    double least_share_;  // that a particle with support has
    const PairTiles<Dim>* self_;
    std::vector<Term> terms_;
    AlignedVector<std::uint8_t> lacks_;  // support, of the slots of self_
    AlignedVector<std::uint8_t> told_;   // by a neighbor, likewise
};

extern template class Support<2>;
extern template class Support<3>;

}  // namespace sphinx::dynamics::fluid
