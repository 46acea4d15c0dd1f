// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/constraint/mirror_images.h"
#include "dynamics/declare.h"
#include "dynamics/known_load.h"

namespace sphinx::dynamics::constraint {

struct ClampParameters {
    input::Name part;
};

/// Holds an elastic body along the surface of a part: u = 0 there. Particles of whose cells the
/// part covers more than a quarter are images: they mirror the motion of the others, u_g = sum_k
/// c_gk u_k, without mass of their own, and hand the forces that they feel on to them, f_k += sum_g
/// c_gk f_g. Each particle is strained as far as its cell lies outside of the part
/// (ElasticRole::shares), so that the surface is met wherever it runs through the lattice. The
/// motion is that of this energy, without loss. constraint.fix, where the particles of the part
/// stand still and share stress and strain with the others, holds the body 0.6 to 0.8 spacings
/// behind that surface instead: the first of them stands half a spacing behind it and shares the
/// strain. Between the halves of the step; at the start, it gives the images their velocity.
template <int Dim>
class Clamp final : public Method, public Support<Dim> {
 public:
    Clamp(Context<Dim>& context, Part<Dim> part);
    void announce() override { part_.mirror(); }
    void prepare() override { findImages(); }
    void run(const Clock& clock);
    std::size_t workSize() const override { return part_.size(); }

    void transfer(Archive& archive) override { this->transferLoad(archive); }

 private:
    /// Where the particles have other places than those found.
    void findImages();

    Relations<Dim>* relations_;
    Part<Dim> part_;
    ReferenceRelation<Dim>* relation_;
    std::vector<Index> images_;
    std::vector<ImageLink> links_;
    std::uint64_t arrangement_ = ~std::uint64_t{0};  // of the particles that these name

    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& acceleration_;
    Field<Vec<Dim>>& external_;
    Field<Vec<Dim>>& pressure_force_;
    Field<Vec<Dim>>& viscous_force_;
    Field<double>& mass_;
};

/// Registers constraint.clamp.
void declareClamp(input::Registry& registry);

}  // namespace sphinx::dynamics::constraint
