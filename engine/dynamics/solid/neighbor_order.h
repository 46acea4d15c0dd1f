// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clock.h"
#include "dynamics/arrangement_watch.h"
#include "dynamics/words.h"

#include <string>
#include <vector>

namespace sphinx::dynamics::solid {

/// Watches whether the nearest neighbors within an elastic body keep their order. Of their distance
/// r_ij the deformation gradients foretell F_ij R_ij, F_ij = (F_i + F_j)/2, and do not see the
/// rest. Where the rest is longer than the distance itself, r_ij . F_ij R_ij <= 0, the particles
/// have changed places in the deformed body, and what F and the stress say of it is wrong, also
/// where det F is still positive. (A motion that F does see, however large, changes no places.)
template <int Dim>
class NeighborOrder {
 public:
    NeighborOrder(const World<Dim>& world, Relations<Dim>& relations, Body<Dim>& body);

    /// Throws PhysicsError that names the particles, their place and the time. Looks at the pairs
    /// only when a particle has moved far enough since for two of them to change places.
    void check(const Clock& clock);

 private:
    struct Pair {
        Index i, j;
        Vec<Dim> distance;  // R_ij
    };
    struct Found {
        std::size_t first;  // pair that has changed places; their number: none has
        double least;       // of the pairs' r_ij along F_ij R_ij
    };
    /// Where particles have other places than they name; says whether they had.
    bool findPairs();
    Found look() const;
    /// Of the particle that is farthest from where it was when the pairs were looked at.
    double moved() const;
    [[noreturn]] void fail(const Pair& pair, const Clock& clock) const;

    const World<Dim>* world_;
    Body<Dim>* body_;
    ReferenceRelation<Dim>* relation_;
    Relations<Dim>* relations_;
    ArrangementWatch watch_;
    std::vector<Pair> pairs_;
    AlignedVector<Vec<Dim>> places_;  // when the pairs were looked at
    double allowed_ = 0;              // way from there before they have to be again
};

extern template class NeighborOrder<2>;
extern template class NeighborOrder<3>;

}  // namespace sphinx::dynamics::solid
