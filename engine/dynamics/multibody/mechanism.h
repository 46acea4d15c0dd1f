// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rigid bodies with joints, as numbers: what Simbody computes, without Simbody and without the
// words of a case. mechanism.cpp is compiled as C++17, which Simbody 3.7 wants: this header has
// nothing newer.

#include "dynamics/multibody/catenary.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace sphinx::dynamics::multibody {

/// Always in three dimensions: a case in two is a slice of unit depth at z = 0.
using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;
/// Force and moment, or velocity and angular velocity.
using Screw = Eigen::Matrix<double, 6, 1>;
using ScrewMatrix = Eigen::Matrix<double, 6, 6>;
using FunctionOfTime = std::function<double(double)>;

/// The drawing is the place of all bodies when all coordinates of joints are zero.
struct RigidBody {
    std::string name;
    double mass = 0;                  ///< mass
    Vector center = Vector::Zero();   ///< of mass, in the drawing; length
    Matrix inertia = Matrix::Zero();  ///< about the centre, axes of the drawing; mass length^2
};

enum class JointKind {
    weld,
    pin,        ///< turns about z
    slider,     ///< moves along x
    planar,     ///< turns about z, then moves along x and y
    universal,  ///< turns about x, then about the moved y
    ball,
    cylinder,  ///< turns about z and moves along it
    gimbal,    ///< turns about x, the moved y, the moved z
    screw,     ///< turns about z and moves along it by a lead
    free,
};

constexpr int ground = -1;

/// One coordinate of a joint, angles in radian.
struct Coordinate {
    double value = 0;  ///< at the start
    double rate = 0;   ///< at the start
    struct Spring {
        double stiffness, rest;
    };
    std::optional<Spring> spring;
    double damping = 0;  ///< force or moment per rate
    struct Limits {
        double lower, upper, stiffness, dissipation;
    };
    std::optional<Limits> limits;
    FunctionOfTime motor;   ///< force or moment; empty: none
    FunctionOfTime motion;  ///< prescribed value; empty: free
};

struct Joint {
    std::string name;
    JointKind kind = JointKind::free;
    int parent = ground;
    int child = 0;
    Vector at_parent = Vector::Zero();  ///< point of the parent in the drawing
    Vector at_child = Vector::Zero();   ///< point of the child that is there when coordinates are 0
    Matrix frame = Matrix::Identity();  ///< its axes x, y, z as columns, in the drawing
    double lead = 0;                    ///< screw: way per radian
    std::vector<Coordinate> coordinates;
    /// Of ball and free, in place of springs on coordinates: springs and dampers on the angles
    /// about x, the moved y and the moved z of the frame, and on the shift along its axes.
    struct Bushing {
        std::array<double, 6> stiffness{}, damping{};
    };
    std::optional<Bushing> bushing;
    /// Of ball and free, in place of coordinates: a turn, and how it goes on.
    Vector turn = Vector::Zero();  ///< angle times axis
    Vector shift = Vector::Zero();
    Vector angular_velocity = Vector::Zero();
    Vector velocity = Vector::Zero();
};

/// A point of a body, in the drawing.
struct BodyPoint {
    int body = ground;
    Vector at = Vector::Zero();
};

struct PointSpring {
    BodyPoint from, to;
    double stiffness = 0;
    double rest_length = 0;
    double damping = 0;  ///< force per rate of the length
    bool tension_only = false;
};

/// Force and moment on a body, axes of the drawing, which stay.
struct GivenForce {
    BodyPoint at;
    std::vector<FunctionOfTime> force;   ///< empty or three
    std::vector<FunctionOfTime> moment;  ///< empty or three
};

/// A line that hangs between two points, from an anchor to another.
struct HangingLine {
    BodyPoint from, to;
    CatenaryLine line;
};

using ForceElement = std::variant<PointSpring, GivenForce, HangingLine>;
/// In the order of ForceElement.
enum class ForceKind { spring, given, line };

struct Rod {
    BodyPoint from, to;
    double length = 0;
};
struct CoincidentPoints {
    BodyPoint from, to;
};
struct PointOnLine {
    BodyPoint line;  ///< a point of the line
    Vector along = Vector::UnitX();
    BodyPoint point;
};
/// sum factor_i q_i = offset
struct CoordinateCoupler {
    struct Term {
        int joint, coordinate;
        double factor;
    };
    std::vector<Term> terms;
    double offset = 0;
};

/// With equal steps, and nothing kept of earlier ones.
enum class Integrator {
    runge_kutta_4,  ///< the classical method of fourth order
    midpoint,       ///< of second order, at half the cost
};

struct MechanismDescription {
    std::vector<RigidBody> bodies;
    std::vector<Joint> joints;  ///< one for each body, as a tree
    Vector gravity = Vector::Zero();
    std::vector<ForceElement> forces;
    std::vector<Rod> rods;
    std::vector<CoincidentPoints> coincident_points;
    std::vector<PointOnLine> points_on_lines;
    std::vector<CoordinateCoupler> couplers;
    Integrator integrator = Integrator::runge_kutta_4;
    double largest_step = 0;  ///< of the integrator; 0: the step that is asked for
    double accuracy = 1e-10;  ///< of constraints, at the end of each step
};

/// What acts on a body from its particles in a step.
struct BodyLoad {
    // Forces and moments about the centre of mass.
    Screw pressure = Screw::Zero();  ///< of fluids
    Screw viscous = Screw::Zero();   ///< of fluids
    Screw material = Screw::Zero();  ///< of elastic material, and of what pushes that
    Screw contact = Screw::Zero();   ///< of other surfaces
    /// Z and b of an answer b - Z (v, omega) to the body's motion within the step: force and moment
    /// about the centre of mass.
    ScrewMatrix impedance = ScrewMatrix::Zero();
    Screw answered = Screw::Zero();

    Screw force() const { return pressure + viscous + material + contact; }
};

/// Means over a step, forces and moments about the centre of mass.
struct Received {
    Screw total = Screw::Zero();
    Screw pressure = Screw::Zero();  ///< with the answer of the fluid
    Screw viscous = Screw::Zero();
    Screw material = Screw::Zero();
    Screw contact = Screw::Zero();
};

struct BodyMotion {
    Matrix rotation = Matrix::Identity();  ///< from the drawing
    Vector center = Vector::Zero();        ///< of mass
    Screw velocity = Screw::Zero();        ///< of the centre, and angular
    Screw acceleration = Screw::Zero();
    /// Sum of the velocity over the last step, as the integrator sums it: so an answer Z loses no
    /// momentum.
    Screw passed = Screw::Zero();
};

/// Of the parent on the child at the joint, also by springs, dampers, stops, motors and given
/// motions of the joint: force and moment about the joint, axes of the drawing.
struct JointReaction {
    Vector at = Vector::Zero();
    Vector force = Vector::Zero();
    Vector moment = Vector::Zero();
};

struct MechanismEnergy {
    double kinetic = 0;
    double gravity = 0;
    double springs = 0;  ///< of springs, ropes, lines and stops
};

/// It cannot be assembled, or its equations have no solution.
class MechanismError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// The equations of motion by Simbody (Sherman, Seth & Delp 2011,
/// doi:10.1016/j.piutam.2011.04.023), stepped by a Runge-Kutta method with equal steps, each of
/// which ends with a projection onto the constraints. It keeps nothing of earlier steps: what
/// state() gives is all that the motion depends on.
class Mechanism {
 public:
    /// Assembled where its joints start; or in a state that state() has given, which constraints
    /// may have led far from there. Throws MechanismError.
    Mechanism(MechanismDescription description, double time, const std::vector<double>& state = {});
    ~Mechanism();

    const MechanismDescription& description() const;

    /// Coordinates, then rates.
    std::vector<double> state() const;

    /// From `time` on by dt; a load for each body. Throws MechanismError.
    void step(double time, double dt, const std::vector<BodyLoad>& loads);
    /// What a body got of its particles in the last step.
    Received received(int body) const;
    /// Work of the particles on each body since the start; energy. State besides state().
    const std::vector<double>& work() const;
    void setWork(const std::vector<double>& work);
    /// At the end of the last step, or at the start.
    BodyMotion motion(int body) const;
    /// Of a coordinate of a joint that has such.
    struct Kinematics {
        double value, rate;
    };
    Kinematics coordinate(int joint, int coordinate) const;
    JointReaction reaction(int joint) const;
    /// Of an entry of `forces`, by its kind. Spring: length, its rate, tension. Given: force and
    /// moment, three each. Line: tension at `to` and at `from`, level part, length on the ground.
    std::vector<double> force(int number) const;
    MechanismEnergy energy() const;
    /// Largest error of the constraints, of positions.
    double constraintError() const;

 private:
    struct Simbody;
    std::unique_ptr<Simbody> simbody_;
};

/// How many coordinates a joint of that kind has; 0 of ball and free, which have others.
int coordinateCount(JointKind kind);

}  // namespace sphinx::dynamics::multibody
