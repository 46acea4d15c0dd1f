// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/domain.h"
#include "bodies/role.h"
#include "core/precision.h"
#include "dynamics/multibody/parameters.h"
#include "geometry/shape.h"
#include "input/declaration/component.h"
#include "input/declaration/registry.h"
#include "input/expressions/units.h"
#include "kernels/kernel.h"
#include "loop/plan/fit.h"
#include "loop/plan/window.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sphinx::model {

using input::Component;
using input::Coordinates;
using input::Every;
using input::FieldExpression;
using input::Name;
using input::Place;

struct Resolution {
    double spacing = 0;                         ///< reference spacing dp, length
    std::optional<double> smoothing_ratio;      ///< h / dp; without: that of smoothing.h
    std::optional<kernels::KernelType> kernel;  ///< without: that of smoothing.h
    Precision precision = Precision::single;    ///< of the terms of a fluid's own pairs
};

struct Domain {
    std::optional<Coordinates> lower, upper;  ///< without: the bounds of all shapes
    std::vector<int> periodic;                ///< axes, 0 is x
    bodies::LostParticles lost = bodies::LostParticles::stop;
    Place place;  ///< without source: there was no such block
};

/// One entry of `geometry`; the pointer of the case's dimension is set.
struct Shape {
    std::string name;
    Place place;
    geometry::ShapePointer<2> shape2;
    geometry::ShapePointer<3> shape3;

    template <int Dim>
    const geometry::ShapePointer<Dim>& as() const {
        if constexpr (Dim == 2)
            return shape2;
        else
            return shape3;
    }
};

struct BodyResolution {
    int level = 0;                          ///< spacing is the reference spacing / 2^level
    std::optional<double> spacing;          ///< instead of the level, length
    std::optional<double> smoothing_ratio;  ///< without: that of the case
    std::optional<Coordinates> origin;      ///< a point that lattice lines (cell faces) meet
};

/// Initial values; what is missing stays zero.
struct Initial {
    std::optional<std::vector<FieldExpression>> velocity;
    std::optional<FieldExpression> pressure;  ///< fluids: density and mass follow from it
    Place place;
};

struct Part {
    std::string name;
    Place place;
    Name shape;  ///< the particles inside of it
};

enum class Follows { space, material, solid };

/// What the points of an observer move with.
struct Followed {
    Follows what = Follows::space;
    Name solid;  ///< a rigid body, or a part of one; empty: none
};

/// Particles given one by one instead of a lattice.
struct DirectParticles {
    std::vector<Coordinates> points;
    std::vector<double> volumes;  ///< one per point
};

/// How the particles of a body stand in its shape.
enum class Arrangement {
    lattice,
    jittered,
    relaxed,  ///< fitted to the surface
};

struct Body {
    std::string name;
    Place place;
    bodies::Role role = bodies::Role::observer;
    Name shape;     ///< empty for observers and bodies of direct particles
    Name material;  ///< empty for observers
    BodyResolution resolution;
    Arrangement arrangement = Arrangement::lattice;
    Initial initial;
    std::vector<Part> parts;
    std::optional<DirectParticles> particles;  ///< without: they are made in the shape
    std::vector<Coordinates> points;           ///< observers: where they look
    Followed follows;                          ///< observers

    double spacing(const Resolution& reference) const;
    double smoothingRatio(const Resolution& reference) const;
    kernels::KernelType kernel(const Resolution& reference) const;
};

/// What a body is to one that sees it.
enum class SeenAs {
    flow,     ///< its particles act on a fluid, or those of an elastic body on each other
    bonded,   ///< both are one piece of material
    contact,  ///< neither goes through the other's surface
};

/// One body that another sees.
struct Seen {
    Name body;  ///< the body itself for `self`
    SeenAs as = SeenAs::flow;
};

struct Sight {
    Name body;
    std::vector<Seen> sees;
};

using loop::Fit;

/// "pressure_relaxation.first_half" as method and action; the latter may be empty.
std::pair<std::string, std::string> splitAction(const std::string& text);

struct Layer;

/// A line of the loop: a method's action, or a nested layer.
struct Step {
    Name run;  ///< METHOD or METHOD.ACTION
    std::optional<Every> every;
    std::optional<double> from, until;  ///< it acts in substeps that begin in this time
    std::shared_ptr<Layer> layer;       ///< set: a nested layer, the rest is empty

    std::string method() const { return splitAction(run.text).first; }
    loop::Window window() const { return {from, until}; }
};

/// `dt` of a layer: the smallest estimate counts.
struct TimeStep {
    std::vector<Name> methods;
    std::optional<double> number;  ///< a fixed step, time; counts with the estimates
};

struct Layer {
    Name name;
    TimeStep dt;
    Fit fit = Fit::split;  ///< how an inner layer covers its parent's step
    std::vector<Step> steps;
};

/// The outermost layer, and what precedes it.
struct Loop : Layer {
    double start_time = 0;
    double end_time = 0;
    std::vector<Step> start;  ///< once, before the first step
};

struct Output : Component {
    Every every;
};

/// A whole case as plain data: no particles. Entries stand in the order of the file.
struct Case {
    const input::Registry* registry = nullptr;  ///< by which it was read; it lives longer
    std::string path;
    std::string title;
    int dimension = 2;
    input::UnitSystem units;
    Resolution resolution;
    Domain domain;
    std::vector<Shape> shapes;
    std::vector<Component> materials;
    std::vector<Body> bodies;
    std::vector<Sight> topology;
    std::optional<dynamics::multibody::MultibodyParameters> multibody;
    std::vector<Component> dynamics;
    Loop loop;
    std::vector<Output> outputs;

    int version = 1;        ///< of the language in which it is written
    int state_version = 1;  ///< of the language, since which the case means the same state
    input::Node resolved;   ///< every value with its origin: what `show` prints
    std::string warnings;   ///< ready to print; empty when there are none
    std::vector<std::string> sources;  ///< the case file and those that it includes
    /// Of the files that values name, by absolute path: their name and what tells their content.
    std::map<std::string, std::string> files;

    const Shape* findShape(std::string_view name) const;
    const Body* findBody(std::string_view name) const;
    const Component* findMaterial(std::string_view name) const;
    const Component* findMethod(std::string_view name) const;
    /// Whether a line of the loop, or the time step of a layer, names the method: no other acts.
    bool calls(std::string_view method) const;
    /// bodies::Body::responds() of it.
    bool responds(const Body& body) const;
    /// What the body sees; empty when topology does not name it.
    const std::vector<Seen>& seenBy(std::string_view body) const;
};

}  // namespace sphinx::model
