// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/words.h"
#include "input/declaration/component.h"
#include "input/tree/diagnostics.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sphinx::dynamics::multibody {
struct MultibodyParameters;
}

namespace sphinx::dynamics {

/// What the rules of methods see of a case as it is written. They report to `diagnostics`, at the
/// place of a parameter.
struct WrittenCase {
    using Components = std::vector<const input::Component*>;
    /// A line of `topology`; what sees itself is `seen` by its own name.
    struct Sight {
        input::Name body;
        input::Name seen;
        bool bonded = false;
        bool contact = false;
    };

    /// A layer of the loop.
    struct Layer {
        std::string name;
        Components dt;       ///< the methods that estimate its step
        bool fixed = false;  ///< a number bounds it as well
        Components called;   ///< by its own lines
    };

    double start_time = 0;  ///< case units
    double end_time = 0;
    /// The block `multibody`, or null.
    const multibody::MultibodyParameters* multibody = nullptr;
    std::vector<std::string> carried;  ///< rigid bodies of which that has particles
    std::vector<std::string> moved;    ///< parts of bodies, or whole ones, that are carried
    Components methods;                ///< in the order of the case
    Components called;                 ///< those of them that the loop calls: no others act
    std::vector<Layer> layers;
    std::vector<Sight> topology;
    std::map<std::string, const input::Component*, std::less<>> materials;  ///< by body
    std::map<std::string, input::Place, std::less<>> places;                ///< of bodies
    input::Diagnostics& diagnostics;

    /// Whether the body has one, with that trait.
    bool hasMaterial(std::string_view body, std::string_view trait) const;
    bool calls(const input::Component& method) const {
        return std::ranges::find(called, &method) != called.end();
    }
    bool isFluid(std::string_view body) const { return hasMaterial(body, "fluid"); }
    bool isElastic(std::string_view body) const { return hasMaterial(body, "elastic"); }
    /// Whether the body is elastic, or rigid and carried by a body of the mechanism.
    bool responds(std::string_view body) const;
    bool sees(std::string_view body, std::string_view other) const {
        return std::ranges::any_of(topology, [&](const Sight& s) {
            return !s.contact && s.body.text == body && s.seen.text == other;
        });
    }
    /// In either direction.
    bool bonded(std::string_view one, std::string_view other) const {
        return std::ranges::any_of(topology, [&](const Sight& s) {
            return s.bonded && ((s.body.text == one && s.seen.text == other) ||
                                (s.body.text == other && s.seen.text == one));
        });
    }
};

/// The same with the world at the start of a run, its particles included.
template <int Dim>
struct BuiltCase : WrittenCase {
    const World<Dim>& world;
};

/// For a rule about a method that is stable only below some step: warns of the first layer that
/// calls it while no method of the type `estimate` for the same `body` bounds the step there.
void warnUnbounded(const input::Component& method, const WrittenCase&, std::string_view estimate);

/// A rule about each method of a declaration.
using Rule = void (*)(const input::Component& method, WrittenCase&);

/// The same with the particles, in both dimensions.
struct WorldRule {
    void (*in2d)(const input::Component& method, BuiltCase<2>&);
    void (*in3d)(const input::Component& method, BuiltCase<3>&);

    void check(const input::Component& method, BuiltCase<2>& built) const { in2d(method, built); }
    void check(const input::Component& method, BuiltCase<3>& built) const { in3d(method, built); }
};

/// A rule about the whole case, whether or not it has a method of the declaration.
struct CaseRule {
    void (*in2d)(BuiltCase<2>&);
    void (*in3d)(BuiltCase<3>&);

    void check(BuiltCase<2>& built) const { in2d(built); }
    void check(BuiltCase<3>& built) const { in3d(built); }
};

}  // namespace sphinx::dynamics
