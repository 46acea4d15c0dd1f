// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/wide.h"
#include "dynamics/contact/pair.h"

#include <array>

namespace sphinx::dynamics::contact {

/// A layer between two surfaces, by its stiffness: energy length^2, pressure length.
struct Compression {
    double energy = 0, pressure = 0, stiffness = 1;
};

/// A point i of one surface has from the other, of which the points j are in reach, the gap
///   g_i = sum_j w_ij g_ij / sum_j w_ij, g_ij = r_ij . n_j + s^2/b beyond an edge, s the way
///   beyond, w_ij = A_j (-n_i . n_j - 1/2) (1 - r_ij^2/R^2)^3 (1 + g_ij/R)^4,
/// over those j whose normals oppose its own to 60 degrees: the distance to the planes of the faces
/// j. For plane surfaces it is exact, wherever their particles lie; of several planes that which a
/// point is the least below has most weight, as of a convex body. Both surfaces have the energy
///   E = sum_i s_i kappa/2 A_i U(-g_i)   over the points of both with g_i < 0
/// where U(g) is that of a layer of thickness d, g^2/2 at first (surface_pair.cpp), and s_i goes
/// from 0 to 1 with the sum of the weights: what comes into reach does so by little. What acts is
/// the derivative by the places of points: that by the gap, pushed back where the weights are, and
/// that by the weights. Normals and places turn with F, or with a rigid body: the derivative by
/// them is a stress (ContactStress), or a couple. So without friction momentum, angular momentum
/// and energy are kept; README.md has what happens without.
///
/// Friction acts along the surface, from its velocity at i relative to the mean of those at the
/// points j, and is pushed back as the weights are:
///   - Coulomb: a spring of the same stiffness along the surface, stretched by the way since they
///     touched, whose force is at most mu times the normal one: what sticks does not creep.
///   - viscous: a layer of that viscosity, a spacing thick.
template <int Dim>
class SurfacePair final : public Pair<Dim> {
 public:
    SurfacePair(const Domain<Dim>& domain, Surface<Dim>& a, Surface<Dim>& b, const PairLaw& law);

    void act(double dt) override;
    /// How far friction has been stretched.
    void transfer(Archive& archive) override;

 private:
    using Vector = VecOf<Dim, Wide>;
    /// How a point meets the other surface.
    struct Touch {
        double weight = 0;                     // sum of w_ij; 0: it does not
        double gap = 0;                        // length
        Vec<Dim> normal = Vec<Dim>::Zero();    // slope of the gap; not quite of length 1
        Vec<Dim> velocity = Vec<Dim>::Zero();  // relative to the other surface
        Vec<Dim> turn = Vec<Dim>::Zero();      // slope of the gap, by the normal of i
        Vec<Dim> by_place = Vec<Dim>::Zero();  // slopes of the weight
        Vec<Dim> by_normal = Vec<Dim>::Zero();
        Compression layer;
    };
    /// What the points of the other surface that it meets have to know of it.
    struct alignas(32) Share {
        double normal = 0;  // force over weight; 0: it meets nothing
        double gap = 0;     // mean of View::gap
        double fade = 0;    // derivative of the energy by the weight, turned round
        double unused = 0;
        double friction[3] = {};
        double more_unused = 0;
    };
    /// Points of one surface that meet those of the other.
    struct Side {
        Surface<Dim>* from;
        Surface<Dim>* to;
        const typename Search<Dim>::Lists* lists;
        std::vector<Touch> touches;   // of all points
        AlignedVector<Share> shares;  // likewise
        std::vector<Vec<Dim>> stretch;
        std::vector<Index> near;  // of the lists, those within reach, in the same places
        std::vector<std::uint32_t> near_count;
    };
    /// Eight points, or one of them for all.
    struct Points {
        Vector place, normal;
        Wide area, ends;
        Vector edge, beyond;
    };
    /// How points i see points j of the other surface.
    struct View {
        Wide weight;    // 0: out of reach, or their normals do not oppose
        Vector slope;   // of the weight, by the place of i
        Wide rise;      // and by the gap
        Wide gap;       // between i and the plane of j, which bends away beyond an edge
        Wide bend;      // slope of the gap, by the way beyond
        Vector normal;  // and by the place of i
        Vector apart;   // from j to i
        Wide bare;      // of the weight what does not depend on normals
    };
    Points one(const Surface<Dim>& surface, std::size_t n) const;
    Points eight(const Surface<Dim>& surface, const Index* points) const;
    Vector apart(const Vector& a, const Vector& b) const;
    /// Nothing beyond the first `count` lanes.
    View view(const Points& i, const Points& j, std::size_t count) const;
    /// Takes those within reach out of the lists of a point.
    void findNear(Side& side, Index n) const;
    void meet(Side& side);
    void push(Side& side, double damping_time, double dt);
    /// What points of `side` get and what those of the other surface push back.
    void collect(Side& side, const Side& back);
    double dampingTime() const;

    double spacing_;                             // the larger one
    std::vector<Side> sides_;                    // two, or one of a surface with itself
    std::array<std::vector<double>, 2> loaded_;  // stretch of a restart, until the points are known
};

}  // namespace sphinx::dynamics::contact
