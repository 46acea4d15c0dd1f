// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "core/output.h"
#include "core/progress.h"
#include "dynamics/context.h"
#include "dynamics/dynamics.h"
#include "input/declaration/component.h"
#include "input/expressions/units.h"
#include "io/file/file.h"
#include "io/file/provenance.h"
#include "io/hdf5/results_file.h"
#include "neighbors/relations.h"

#include <functional>
#include <memory>
#include <vector>

namespace sphinx::io {

/// An observer whose points move: with the material, or with a solid or a part of it.
template <int Dim>
struct Follower {
    const bodies::Body<Dim>* observer;
    const bodies::Body<Dim>* solid = nullptr;  ///< null: the material that the observer sees
    const bodies::BodyPart<Dim>* part = nullptr;
};

/// What outputs are built from, once bodies and methods exist. Everything that it refers to lives
/// as long as the outputs.
template <int Dim>
struct OutputContext {
    bodies::World<Dim>& world;
    neighbors::Relations<Dim>& relations;
    Path folder;  ///< of the results; it exists when outputs write
    input::UnitSystem units;
    Provenance provenance;
    std::shared_ptr<ResultsFile> results;          ///< results.h5
    std::function<Progress()> progress;            ///< called at writes only
    std::vector<const dynamics::Method*> methods;  ///< those that the loop calls
    /// Theirs, between fluids and solids.
    std::vector<const dynamics::fluid::SolidLoad<Dim>*> loads;
    std::vector<Follower<Dim>> followers;

    /// nullptr where the points of the observer stay where they are.
    const Follower<Dim>* follower(const bodies::Body<Dim>& observer) const {
        for (const Follower<Dim>& one : followers)
            if (one.observer == &observer) return &one;
        return nullptr;
    }
};

/// What Declaration::builder of Kind::output holds. The component is the entry of the case. Throws
/// CaseError with places when the entry asks for what the bodies do not have.
struct OutputFactory {
    std::function<std::unique_ptr<Output>(const input::Component&, const OutputContext<2>&)> in2d;
    std::function<std::unique_ptr<Output>(const input::Component&, const OutputContext<3>&)> in3d;

    template <int Dim>
    std::unique_ptr<Output> make(const input::Component& component,
                                 const OutputContext<Dim>& context) const {
        if constexpr (Dim == 2)
            return in2d(component, context);
        else
            return in3d(component, context);
    }
};

/// make: []<int Dim>(const P&, const input::Component&, const OutputContext<Dim>&)
///           -> std::unique_ptr<Output>.
template <class P, class Make>
OutputFactory outputFactory(Make make) {
    return {[make](const input::Component& component,
                   const OutputContext<2>& context) -> std::unique_ptr<Output> {
                return make.template operator()<2>(component.as<P>(), component, context);
            },
            [make](const input::Component& component,
                   const OutputContext<3>& context) -> std::unique_ptr<Output> {
                return make.template operator()<3>(component.as<P>(), component, context);
            }};
}

/// Throws the message as a CaseError at its place.
[[noreturn]] void failAt(const input::Place& place, const std::string& message);

/// The field of the body that the case names; failAt() when it has none.
template <int Dim>
const particles::FieldBase& fieldOf(const bodies::Body<Dim>& body, const input::Name& field);

}  // namespace sphinx::io
