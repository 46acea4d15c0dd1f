// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies.h"
#include "dynamics/context.h"
#include "dynamics/part.h"

namespace sphinx::test {

/// Bodies, and what methods and outputs are built from.
template <int Dim>
struct Scene : Bodies<Dim> {
    Relations<Dim> relations{this->world};
    Context<Dim> context{this->world, relations};

    /// "gate.base", or all of a body: "gate".
    Part<Dim> part(const std::string& name) { return Part<Dim>(this->world, {name, {}}); }
    /// Adds it to the body: the particles for which inside(R) holds.
    template <class Inside>
    Part<Dim> part(Body<Dim>& body, const std::string& name, Inside&& inside) {
        this->addPart(body, name, std::forward<Inside>(inside));
        return part(body.name + "." + name);
    }
};

}  // namespace sphinx::test
