// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies.h"
#include "dynamics/context.h"
#include "dynamics/part.h"
#include "method.h"

namespace sphinx::test {

/// Bodies, and what methods and outputs are built from.
template <int Dim>
struct Scene : Bodies<Dim> {
    neighbors::Relations<Dim> relations{this->world};
    dynamics::Context<Dim> context{this->world, relations};

    /// As a case writes it: "type: force.gravity, body: block, acceleration: [0, -10]".
    MadeMethod<Dim> method(const std::string& yaml) { return {context, yaml}; }
    auto timeStep(const std::string& yaml) { return makeTimeStep<Dim>(context, yaml); }
    /// "gate.base", or all of a body: "gate".
    dynamics::Part<Dim> part(const std::string& name) {
        return dynamics::Part<Dim>(this->world, {name, {}});
    }
    /// Adds it to the body: the particles for which inside(R) holds.
    template <class Inside>
    dynamics::Part<Dim> part(bodies::Body<Dim>& body, const std::string& name, Inside&& inside) {
        this->addPart(body, name, std::forward<Inside>(inside));
        return part(body.name + "." + name);
    }
};

}  // namespace sphinx::test
