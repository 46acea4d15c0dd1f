// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/arrangement_watch.h"
#include "dynamics/contact/loads.h"
#include "dynamics/contact_stress.h"
#include "dynamics/words.h"

namespace sphinx::dynamics::contact {

/// The surface of a solid as contact sees it: the particles that lie less than a spacing below it.
/// However a lattice lies under a surface, there is one of them for each dp^(Dim-1) of it. Each
/// stands for the plane at its depth above it, along its normal; at an edge, where faces of several
/// normals meet, for a ball of that radius, and for the tip of the edge where that meets a plane.
template <int Dim>
class Surface {
 public:
    /// A record of doubles, of which eight are read at a time (gatherRecords); in 2D the third
    /// components are 0.
    struct alignas(32) Point {
        double place[3] = {};     ///< of the particle, at the middle of the step
        double depth = 0;         ///< length
        double normal[3] = {};    ///< outwards
        double area = 0;          ///< V/dp: of the undeformed surface
        double velocity[3] = {};  ///< of the surface above it, before the kick; at an edge its own
        double edge = 0;          ///< 1 or 0
        double slip[3] = {};      ///< the same, at an edge of its tip
        double tip = 0;           ///< how far an edge reaches along the normal; else 0
    };

    /// Its particles are those less than `depth` deep. `loads`: of the same body.
    Surface(const Domain<Dim>& domain, Body<Dim>& body, Loads<Dim>& loads, double depth);

    /// Finds its particles where nobody has. What follows is about the middle of a step by dt that
    /// has not begun.
    void update(double dt);
    /// Of any point.
    Vec<Dim> place(std::size_t n) const {
        const Index i = particles_[n];
        return position_[i] + 0.5 * dt_ * velocity_[i];
    }
    const Vec<Dim>& velocity(std::size_t n) const { return velocity_[particles_[n]]; }
    double volume(std::size_t n) const { return volume_[particles_[n]]; }
    /// Takes the state of these points, to be read by [].
    void take(const std::vector<Index>& points);

    Body<Dim>& body() const { return *body_; }
    Loads<Dim>& loads() const { return *loads_; }
    std::size_t size() const { return points_.size(); }
    const Point& operator[](std::size_t n) const { return points_[n]; }
    const double* records() const { return points_.data()->place; }
    /// Index in the body of the n-th point.
    Index particle(std::size_t n) const { return particles_[n]; }
    /// How far above a point friction acts that it feels itself: at the surface, or the tip of an
    /// edge.
    double slipArm(std::size_t n) const {
        return points_[n].edge > 0 ? points_[n].tip : points_[n].depth;
    }
    /// And that which is pushed back: on the ball of an edge there is no such place.
    double backArm(std::size_t n) const { return points_[n].edge > 0 ? 0 : points_[n].depth; }
    /// In the reference configuration.
    const Vec<Dim>& initialPlace(std::size_t n) const;
    /// Before the pairs of a step: nothing turns its normals yet.
    void release();
    /// Adds to the derivative of the energy of contact by the normal of the n-th point, of which
    /// willTurn() has told.
    void turn(std::size_t n, const Vec<Dim>& derivative) { turns_[n] += derivative; }
    void willTurn(const std::vector<Index>& points) {
        turned_.insert(turned_.end(), points.begin(), points.end());
    }
    /// After them: what that comes to, the stress of an elastic body, or contact_turn of a rigid
    /// one.
    void finish();
    ContactStress<Dim>& stress() { return stress_; }

    /// Counts the times when other particles were found, or they may have moved.
    std::uint64_t version() const { return version_; }

 private:
    void find();
    void findSpin();
    /// From a point of the reference configuration to the surface.
    double wayOut(const Vec<Dim>& from, const Vec<Dim>& along) const;

    const Domain<Dim>* domain_;
    Body<Dim>* body_;
    double deepest_;
    Loads<Dim>* loads_;
    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& initial_position_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& normal_;
    Field<Vec<Dim>>& initial_normal_;
    Field<double>& depth_;
    Field<double>& volume_;
    const Field<Mat<Dim>>* gradient_ = nullptr;  // of an elastic body
    const Field<Mat<Dim>>* gradient_rate_ = nullptr;
    ArrangementWatch arrangement_;
    std::vector<Index> particles_;  // ascending
    AlignedVector<Point> points_;
    AlignedVector<Mat<Dim>> inverse_gradients_;
    Mat<Dim> spin_ = Mat<Dim>::Zero();  // of a rigid body: v = v0 + spin (r - r0)
    bool spin_known_ = false;           // of body_version_; found where something is near
    std::vector<Vec<Dim>> turns_;
    std::vector<Index> turned_;
    ContactStress<Dim> stress_;
    std::uint64_t version_ = 0;
    std::uint64_t body_version_ = ~std::uint64_t{0};  // of what is taken, with dt_
    double dt_ = 0;
};

}  // namespace sphinx::dynamics::contact
