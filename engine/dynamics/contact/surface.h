// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/arrangement_watch.h"
#include "dynamics/contact/loads.h"
#include "dynamics/contact_stress.h"
#include "dynamics/words.h"

namespace sphinx::dynamics::contact {

/// The surface of a solid as contact sees it: points above the particles that lie less than a
/// spacing below it. However a lattice lies under a face, there is one of them for each dp^(Dim-1)
/// of it. A particle has a point on each face whose foot it is, the plane of which the point stands
/// for; and near an edge, where faces meet at an angle, the nearest point of the edge, half a
/// spacing and more from any particle. Points go with the deformation gradient of their particle,
/// or with a rigid body.
///
/// Both faces and edges are what meets another surface, only faces are what is met, and they end at
/// their edge: there a second plane goes through the edge, that of the other faces. A particle that
/// has a point of an edge bears the other surface with that alone, if it is rigid, else with both,
/// half each.
template <int Dim>
class Surface {
 public:
    /// A record of doubles, of which eight are read at a time (gatherRecords); in 2D the third
    /// components are 0.
    struct alignas(32) Point {
        double place[3] = {};     ///< at the middle of the step
        double met_area = 0;      ///< V/dp, of the undeformed surface; 0 of the point of an edge
        double normal[3] = {};    ///< outwards
        double ends = 0;          ///< 1 of a face that ends near it, else 0
        double velocity[3] = {};  ///< of the place, before the kick
        double unused = 0;
        // Where `ends`:
        double edge[3] = {};  ///< a place on it
        double more_unused = 0;
        double beyond[3] = {};  ///< normal of the faces that begin there
        double even_more_unused = 0;
    };

    /// Its particles are those less than `depth` deep. `loads`: of the same body. Without `edges` a
    /// particle has one point.
    Surface(const Domain<Dim>& domain, Body<Dim>& body, Loads<Dim>& loads, double depth,
            bool edges);

    /// Finds its particles where nobody has. What follows is about the middle of a step by dt that
    /// has not begun.
    void update(double dt);
    /// Of the particle of any point.
    Vec<Dim> place(std::size_t n) const {
        const Index i = particles_[n];
        return position_[i] + 0.5 * dt_ * velocity_[i];
    }
    /// Of the step in whose middle places are.
    double dt() const { return dt_; }
    const Vec<Dim>& velocity(std::size_t n) const { return velocity_[particles_[n]]; }
    double volume(std::size_t n) const { return volume_[particles_[n]]; }
    /// Takes the state of these points, to be read by [].
    void take(const std::vector<Index>& points);

    Body<Dim>& body() const { return *body_; }
    Loads<Dim>& loads() const { return *loads_; }
    std::size_t size() const { return points_.size(); }
    const Point& operator[](std::size_t n) const { return points_[n]; }
    const double* records() const { return points_.data()->place; }
    /// Of a point of an edge, by how much its particle and those around it are easier to move there
    /// than at the particle: as F has the gradient of two particles, the inverse mass at an arm T
    /// is about (1 + T/dp)^2 times as large.
    double leverage(std::size_t n) const {
        if (!gradient_ || n < first_edge_) return 1;
        const double ratio = 1 + edgeArm(n).norm() / body_->spacing;
        return ratio * ratio;
    }
    /// How far a point is from its particle at most, as far as particles near edges are not
    /// stretched by more than a quarter.
    double length(std::size_t n) const {
        return n < first_edge_ ? heights_[n] : 1.25 * edgeArm(n).norm();
    }
    /// Index in the body of the n-th point.
    Index particle(std::size_t n) const { return particles_[n]; }
    /// What a point bears of the other surface, of the undeformed one.
    double area(std::size_t n) const { return areas_[n]; }
    /// In the reference configuration.
    const Vec<Dim>& initialPlace(std::size_t n) const;
    /// Before the pairs of a step: nothing turns its normals yet.
    void release();
    /// Adds a force at the place of the n-th point, of which willPush() has told, and the
    /// derivative of the energy of contact by its normal, the place held.
    void push(std::size_t n, const Vec<Dim>& force, const Vec<Dim>& by_normal) {
        forces_[n] += force;
        by_normals_[n] += by_normal;
    }
    /// The same at the edge where the face of a point ends, and by the normal beyond.
    void pushEdge(std::size_t n, const Vec<Dim>& force, const Vec<Dim>& by_normal) {
        edge_forces_[ends_[n]] += force;
        by_beyond_[ends_[n]] += by_normal;
    }
    void willPush(const std::vector<Index>& points) {
        pushed_.insert(pushed_.end(), points.begin(), points.end());
    }
    /// After them: what that comes to, on particles, and the stress of an elastic body, or
    /// contact_couple of a rigid one.
    void finish();
    ContactStress<Dim>& stress() { return stress_; }

    /// Counts the times when other particles were found, or they may have moved.
    std::uint64_t version() const { return version_; }

 private:
    void find();
    void findFrame();
    void findSpin();
    /// How a rigid body has turned.
    void findTurn();
    /// What turns, and stretches, an arm of a particle: F, or the rotation of a rigid body.
    Mat<Dim> turnOf(Index i) const {
        return gradient_ ? Mat<Dim>((*gradient_)[i] + 0.5 * dt_ * (*gradient_rate_)[i]) : turn_;
    }
    struct End {
        Vec<Dim> arm, beyond;  // from the particle to the edge, and the normal, as drawn
    };
    /// Adds a point of a face, at a height above a particle along its normal.
    void addFace(Index i, const Vec<Dim>& normal, double height, double area);
    /// dE/dF of a normal by which the energy has a derivative.
    Mat<Dim> stressOf(std::size_t n, const Vec<Dim>& normal, const Vec<Dim>& derivative) const;
    /// From its particle to a point of an edge, as drawn.
    const Vec<Dim>& edgeArm(std::size_t n) const { return edge_arms_[n - first_edge_]; }

    const Domain<Dim>* domain_;
    Body<Dim>* body_;
    double deepest_;
    bool edges_;
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
    std::vector<Index> particles_;  // of points; ascending, then those of points of edges again
    AlignedVector<Point> points_;
    std::vector<double> areas_;
    std::vector<double> heights_;    // above the particle, along the normal; of edges 0
    std::vector<Vec<Dim>> normals_;  // as drawn
    std::size_t first_edge_ = 0;
    std::vector<Vec<Dim>> edge_arms_;  // as drawn
    std::vector<End> face_ends_;
    std::vector<Index> ends_;   // of each point, in those; where its face does not, anything
    std::vector<Index> frame_;  // particles that tell how a rigid body turns
    Mat<Dim> turn_ = Mat<Dim>::Identity();
    AlignedVector<Mat<Dim>> inverse_gradients_;
    Mat<Dim> spin_ = Mat<Dim>::Zero();           // of a rigid body: v = v0 + spin (r - r0)
    bool spin_known_ = false;                    // of body_version_; found where something is near
    std::vector<Vec<Dim>> forces_, by_normals_;  // of points
    std::vector<Vec<Dim>> edge_forces_, by_beyond_;  // of face_ends_
    std::vector<Index> pushed_;
    ContactStress<Dim> stress_;
    std::uint64_t version_ = 0;
    std::uint64_t body_version_ = ~std::uint64_t{0};  // of what is taken, with dt_
    double dt_ = 0;
};

}  // namespace sphinx::dynamics::contact
