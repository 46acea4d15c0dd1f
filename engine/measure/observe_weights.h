// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/archive.h"
#include "neighbors/relations.h"

#include <cstdint>
#include <vector>

namespace sphinx::measure {

/// A particle's part in the value at a point.
struct ParticleWeight {
    std::uint32_t body = 0;  ///< place in ObserveWeights::bodies()
    Index particle = 0;
    double weight = 0;  ///< the weights of a point add up to 1
};

/// The value of a field at the points of an observer, as weights of particles:
///   f(x) = sum_j V_j W(x - x_j) f_j / coverage,   coverage = sum_j V_j W(x - x_j)
/// over the particles of all bodies that the observer sees, each with the kernel of its body
/// (Shepard's interpolation: exact for a constant; the coverage is 1 inside of a body, about 1/2 on
/// its surface). A point that sees no particle has no weights.
template <int Dim>
class ObserveWeights {
 public:
    /// Throws CaseError when a seen body has no volumes.
    ObserveWeights(const bodies::Body<Dim>& observer, neighbors::Relations<Dim>& relations);
    virtual ~ObserveWeights() = default;

    /// Brings everything below up to the present state.
    virtual void update();

    std::size_t points() const { return observer_->size(); }
    const std::vector<bodies::Body<Dim>*>& bodies() const { return observer_->sees; }
    const std::vector<ParticleWeight>& of(std::size_t point) const { return weights_[point]; }
    double coverage(std::size_t point) const { return coverage_[point]; }
    const Vec<Dim>& position(std::size_t point) const { return position_[point]; }

    virtual void transfer(Archive&) {}

 protected:
    const bodies::Body<Dim>* observer_;
    std::vector<std::vector<ParticleWeight>> weights_;
    std::vector<double> coverage_;
    std::vector<Vec<Dim>> position_;

 private:
    neighbors::Relations<Dim>* relations_;
    std::vector<neighbors::Relation<Dim>*> seen_;
    std::vector<const particles::Field<double>*> volume_;
};

extern template class ObserveWeights<2>;
extern template class ObserveWeights<3>;

}  // namespace sphinx::measure
