// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/multibody/description.h"

#include "dynamics/multibody/components.h"
#include "dynamics/multibody/mass_properties.h"

#include <fmt/format.h>
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace sphinx::dynamics::multibody {
namespace {

using input::Component;
using input::Coordinates;

class Describer {
 public:
    Describer(int dimension, const MultibodyParameters& p, input::Diagnostics& diagnostics)
        : dimension_(dimension), p_(p), diagnostics_(diagnostics), assembly_(p) {}

    template <int Dim>
    void bodies(const World<Dim>& world);
    void joints();
    void components();
    MechanismDescription take() { return std::move(assembly_.mechanism); }

 private:
    void report(const input::Place& place, std::string message) {
        diagnostics_.error(place, std::move(message));
    }
    bool giveInertia(const input::Name& name, const BodyParameters& p, RigidBody& body);
    bool jointFits(const Component& component, JointKind kind);
    Matrix frame(const Component& component, const JointParameters& p, JointKind kind);
    std::vector<Coordinate> coordinates(const std::string& name, const JointParameters& p,
                                        JointKind kind) const;
    Joint joint(const Component& component);
    void checkTree();
    /// Reports a list that is given and has another length.
    void checkCount(const Component& component, const char* name, std::size_t given,
                    std::size_t wanted, const char* what = "numbers");

    int dimension_;
    const MultibodyParameters& p_;
    input::Diagnostics& diagnostics_;
    Assembly assembly_;
};

/// How many coordinates of a joint are angles: they come first.
std::size_t turningCount(JointKind kind) {
    switch (kind) {
        case JointKind::pin:
        case JointKind::screw:
        case JointKind::planar:
        case JointKind::cylinder: return 1;
        case JointKind::universal: return 2;
        case JointKind::gimbal: return 3;
        default: return 0;
    }
}

bool isPhysical(const Matrix& inertia) {
    const Eigen::Vector3d I = Eigen::SelfAdjointEigenSolver<Matrix>(inertia).eigenvalues();
    return I[0] > 0 && I[0] + I[1] >= I[2] * (1 - 1e-9);
}

bool Describer::giveInertia(const input::Name& name, const BodyParameters& p, RigidBody& body) {
    const std::vector<double>& I = p.inertia;
    if (dimension_ == 2) {
        if (I.size() != 1) {
            report(name.place, fmt::format("the inertia of {} has {} numbers, but is one in 2D, "
                                           "about z through its centre of mass",
                                           name.text, I.size()));
            return false;
        }
        body.inertia = Eigen::Vector3d(0.5, 0.5, 1).asDiagonal() * I[0];
    } else if (I.size() == 3 || I.size() == 6) {
        body.inertia = Eigen::Vector3d(I[0], I[1], I[2]).asDiagonal();
        if (I.size() == 6) {
            body.inertia(0, 1) = body.inertia(1, 0) = I[3];
            body.inertia(0, 2) = body.inertia(2, 0) = I[4];
            body.inertia(1, 2) = body.inertia(2, 1) = I[5];
        }
    } else {
        report(name.place, fmt::format("the inertia of {} has {} numbers, but must have three (xx, "
                                       "yy, zz) or six (and xy, xz, yz)",
                                       name.text, I.size()));
        return false;
    }
    return true;
}

template <int Dim>
void Describer::bodies(const World<Dim>& world) {
    for (const auto& [name, p] : p_.bodies) {
        RigidBody body;
        body.name = name.text;
        const MassProperties own = massProperties(world, p.particles);
        body.mass = p.mass.value_or(own.mass);
        body.center = p.center ? vectorOf(*p.center) : own.center;
        if (!p.particles.empty() && own.particles == 0) {
            report(p.particles.front().place,
                   fmt::format("{} has no particles", p.particles.front().text));
        } else if (!(body.mass > 0)) {
            report(name.place,
                   p.mass ? fmt::format("the mass of {} must be above 0", name.text)
                   : p.particles.empty()
                       ? fmt::format("{} has no particles: give its mass", name.text)
                       : fmt::format("{} has no mass: give one, or a density to its material",
                                     name.text));
        } else if (p.inertia.empty() && own.mass > 0) {
            body.inertia = own.inertia * (body.mass / own.mass);
        } else if (p.inertia.empty()) {
            report(name.place,
                   fmt::format("{} has no particles with a mass: give its inertia", name.text));
        } else if (giveInertia(name, p, body) && !isPhysical(body.inertia)) {
            report(name.place,
                   fmt::format("no body has the inertia of {}: principal moments are above 0, and "
                               "none is larger than the sum of the others",
                               name.text));
        }
        assembly_.mechanism.bodies.push_back(std::move(body));
    }
}

bool Describer::jointFits(const Component& component, JointKind kind) {
    static constexpr std::array plane{JointKind::weld, JointKind::pin, JointKind::slider,
                                      JointKind::planar};
    if (dimension_ == 3 || std::ranges::find(plane, kind) != plane.end()) return true;
    report(component.place, fmt::format("{} is a {} joint, but in 2D joints are weld, pin, slider "
                                        "or planar",
                                        component.name, component.declaration->name()));
    return false;
}

/// Any axes across the third.
Matrix axesAbout(const Vector& z) {
    Matrix frame;
    const Vector seed = std::abs(z.x()) < 0.9 ? Vector::UnitX() : Vector::UnitY();
    frame.col(2) = z;
    frame.col(0) = (seed - seed.dot(z) * z).normalized();
    frame.col(1) = z.cross(Vector(frame.col(0)));
    return frame;
}

Matrix Describer::frame(const Component& component, const JointParameters& p, JointKind kind) {
    const bool about_z = kind == JointKind::pin || kind == JointKind::cylinder ||
                         kind == JointKind::screw || kind == JointKind::planar;
    if (dimension_ == 2 && about_z) {
        if (p.axis)
            report(component.placeOf("axis"), "in 2D joints turn about z: 'axis' is for 3D");
        return Matrix::Identity();
    }
    const auto direction = [&](const char* name,
                               const std::optional<Coordinates>& given) -> std::optional<Vector> {
        if (!given) return {};
        const Vector a = vectorOf(*given);
        if (a.norm() > 0) return Vector(a.normalized());
        report(component.placeOf(name),
               fmt::format("the {} of {} has no direction", name, component.name));
        return {};
    };
    const auto axis = direction("axis", p.axis);
    if (about_z) {
        if (!p.axis)
            report(component.place,
                   fmt::format("{} in 3D needs the direction of its 'axis'", component.name));
        return axis ? axesAbout(*axis) : Matrix::Identity();
    }
    if (kind == JointKind::slider && axis) {
        const Matrix about = axesAbout(*axis);
        Matrix frame;
        frame << about.col(2), about.col(0), about.col(1);
        if (dimension_ == 2) frame << *axis, Vector::UnitZ().cross(*axis), Vector::UnitZ();
        return frame;
    }
    if (kind == JointKind::universal) {
        const Vector x = axis.value_or(Vector::UnitX());
        const Vector y = direction("second_axis", p.second_axis).value_or(Vector::UnitY());
        if (std::abs(x.dot(y)) > 1e-9) {
            report(component.place,
                   fmt::format("the axes of {} are not at right angles", component.name));
            return Matrix::Identity();
        }
        Matrix frame;
        frame << x, y, x.cross(y);
        return frame;
    }
    return Matrix::Identity();
}

std::vector<Coordinate> Describer::coordinates(const std::string& name, const JointParameters& p,
                                               JointKind kind) const {
    std::vector<Coordinate> all(static_cast<std::size_t>(coordinateCount(kind)));
    const auto start = [&](std::size_t k, double value, double rate) {
        all[k].value = value;
        all[k].rate = rate;
    };
    switch (kind) {
        case JointKind::pin:
        case JointKind::screw: start(0, p.angle, p.rate); break;
        case JointKind::slider: start(0, p.displacement, p.speed); break;
        case JointKind::cylinder:
            start(0, p.angle, p.rate);
            start(1, p.displacement, p.speed);
            break;
        case JointKind::planar:
            start(0, p.angle, p.rate);
            for (std::size_t k = 0; k < 2; ++k)
                start(1 + k, p.shift ? p.shift->values[k] : 0,
                      p.velocity ? p.velocity->values[k] : 0);
            break;
        default:
            for (std::size_t k = 0; k < all.size(); ++k)
                start(k, k < p.angles.size() ? p.angles[k] : 0,
                      k < p.rates.size() ? p.rates[k] : 0);
    }
    const auto act = [&](std::size_t k, const auto& given) {
        Coordinate& c = all[k];
        if (given.spring) c.spring = {given.spring->stiffness, given.spring->rest};
        c.damping = given.damping;
        if (given.limits)
            c.limits = {given.limits->lower, given.limits->upper, given.limits->stiffness,
                        given.limits->dissipation};
        if (given.motor) c.motor = functionOfTime(*given.motor, "a motor of " + name);
        if (given.motion) c.motion = functionOfTime(*given.motion, "a motion of " + name);
    };
    if (all.size() == 1) act(0, p);
    // Angles are before ways.
    const std::size_t angles = turningCount(kind);
    for (std::size_t k = 0; k < std::min(angles, p.turning.size()); ++k) act(k, p.turning[k]);
    for (std::size_t k = 0;
         k < std::min(all.size() - std::min(all.size(), angles), p.sliding.size()); ++k)
        act(angles + k, p.sliding[k]);
    return all;
}

std::optional<Joint::Bushing> bushing(const JointParameters& p) {
    if (p.turning_bushings.empty() && p.sliding_bushings.empty()) return {};
    Joint::Bushing all;
    for (std::size_t k = 0; k < 3; ++k) {
        if (k < p.turning_bushings.size()) {
            all.stiffness[k] = p.turning_bushings[k].stiffness;
            all.damping[k] = p.turning_bushings[k].damping;
        }
        if (k < p.sliding_bushings.size()) {
            all.stiffness[3 + k] = p.sliding_bushings[k].stiffness;
            all.damping[3 + k] = p.sliding_bushings[k].damping;
        }
    }
    return all;
}

void Describer::checkCount(const Component& component, const char* name, std::size_t given,
                           std::size_t wanted, const char* what) {
    if (given == 0 || given == wanted) return;
    report(component.placeOf(name), fmt::format("{} of {} has {} {}, but must have {}", name,
                                                component.name, given, what, wanted));
}

Vector threeOf(const std::vector<double>& values) {
    return values.size() == 3 ? Vector(values[0], values[1], values[2]) : Vector(Vector::Zero());
}

Joint Describer::joint(const Component& component) {
    const auto& p = component.as<JointParameters>();
    const JointKind kind = component.declaration->builder<JointKind>();
    Joint joint;
    joint.name = component.name;
    joint.kind = kind;
    joint.parent = assembly_.body(p.parent);
    joint.child = assembly_.body(p.child);
    const RigidBody& child = assembly_.mechanism.bodies[static_cast<std::size_t>(joint.child)];
    joint.at_parent = p.at ? vectorOf(*p.at) : child.center;
    joint.at_child = p.child_at ? vectorOf(*p.child_at) : joint.at_parent;
    joint.frame = frame(component, p, kind);
    joint.lead = p.lead;
    joint.coordinates = coordinates(component.name, p, kind);
    const std::size_t angles = joint.coordinates.size();
    if (kind == JointKind::universal || kind == JointKind::gimbal) {
        checkCount(component, "angles", p.angles.size(), angles);
        checkCount(component, "rates", p.rates.size(), angles);
    }
    checkCount(component, "turn", p.turn.size(), 3);
    checkCount(component, "angular_velocity", p.angular_velocity.size(), 3);
    const std::size_t turning = turningCount(kind);
    checkCount(component, "turning", p.turning.size(), turning, "entries");
    checkCount(component, "sliding", p.sliding.size(), angles - std::min(angles, turning),
               "entries");
    checkCount(component, "turning", p.turning_bushings.size(), 3, "entries");
    checkCount(component, "sliding", p.sliding_bushings.size(), 3, "entries");
    joint.bushing = bushing(p);
    joint.turn = threeOf(p.turn);
    joint.angular_velocity = threeOf(p.angular_velocity);
    if (p.shift) joint.shift = vectorOf(*p.shift);
    if (p.velocity) joint.velocity = vectorOf(*p.velocity);
    return joint;
}

void Describer::checkTree() {
    const auto parentOf = [&](int body) {
        for (const Joint& joint : assembly_.mechanism.joints)
            if (joint.child == body) return joint.parent;
        return ground;
    };
    for (const Component& component : p_.joints) {
        const int start = assembly_.body(component.as<JointParameters>().child);
        int body = parentOf(start);
        for (std::size_t k = 0; k < p_.bodies.size() && body != ground && body != start; ++k)
            body = parentOf(body);
        if (body != start) continue;
        report(component.place,
               fmt::format("the parents of {} lead back to it: joints are a tree that begins at "
                           "ground; close a loop by a constraint",
                           component.as<JointParameters>().child.text));
        return;
    }
}

void Describer::joints() {
    MechanismDescription& mechanism = assembly_.mechanism;
    if (p_.gravity) mechanism.gravity = vectorOf(*p_.gravity);
    std::vector<const Component*> carrier(p_.bodies.size(), nullptr);
    for (const Component& component : p_.joints) {
        if (!jointFits(component, component.declaration->builder<JointKind>())) continue;
        const input::Name& child = component.as<JointParameters>().child;
        const Component*& first = carrier[static_cast<std::size_t>(assembly_.body(child))];
        if (first) {
            report(component.place, fmt::format("{} is already child of {}: a body has one joint "
                                                "that carries it; close a loop by a constraint",
                                                child.text, first->name));
            continue;
        }
        first = &component;
        mechanism.joints.push_back(joint(component));
    }
    checkTree();
    for (std::size_t b = 0; b < carrier.size(); ++b) {
        if (carrier[b]) continue;
        Joint joint;
        joint.kind = dimension_ == 2 ? JointKind::planar : JointKind::free;
        joint.child = static_cast<int>(b);
        joint.at_parent = joint.at_child = mechanism.bodies[b].center;
        joint.coordinates.resize(static_cast<std::size_t>(coordinateCount(joint.kind)));
        mechanism.joints.push_back(std::move(joint));
    }
}

void Describer::components() {
    for (const Component& component : p_.forces) {
        const auto& builder = component.declaration->builder<ForceBuilder>();
        builder.add(component, assembly_);
        if (builder.kind == ForceKind::line && assembly_.mechanism.gravity.norm() == 0)
            report(component.place, fmt::format("{} hangs by its weight: it needs the direction of "
                                                "multibody.gravity",
                                                component.name));
    }
    for (const Component& component : p_.constraints)
        component.declaration->builder<AddComponent>()(component, assembly_);
}

}  // namespace

template <int Dim>
MechanismDescription describe(const MultibodyParameters& parameters, const World<Dim>& world,
                              input::Diagnostics& diagnostics) {
    Describer describer(Dim, parameters, diagnostics);
    describer.bodies(world);
    if (diagnostics.hasErrors()) return {};
    describer.joints();
    if (diagnostics.hasErrors()) return {};
    describer.components();
    MechanismDescription mechanism = describer.take();
    mechanism.integrator = parameters.integrator;
    mechanism.accuracy = parameters.accuracy.value_or(mechanism.accuracy);
    mechanism.largest_step = parameters.step.value_or(0);
    return mechanism;
}

template MechanismDescription describe(const MultibodyParameters&, const World<2>&,
                                       input::Diagnostics&);
template MechanismDescription describe(const MultibodyParameters&, const World<3>&,
                                       input::Diagnostics&);

}  // namespace sphinx::dynamics::multibody
