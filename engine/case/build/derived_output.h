// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "core/output.h"
#include "input/declaration/component.h"

#include <memory>

namespace sphinx::build {

/// Fields of elastic bodies that exist for outputs only (solid/derived_fields.h).
template <int Dim>
class DerivedFields {
 public:
    /// Those that the entry of an output names; makes them in all elastic bodies.
    DerivedFields(const input::Component& output, bodies::World<Dim>& world);

    bool empty() const { return fields_.empty(); }
    /// Computes them from the present state.
    void refresh() const;

 private:
    std::vector<bodies::Body<Dim>*> bodies_;
    std::vector<const particles::FieldInfo*> fields_;
};

/// The output, looking at derived fields that are computed before it looks.
template <int Dim>
std::unique_ptr<Output> withDerivedFields(std::unique_ptr<Output> output,
                                          DerivedFields<Dim> fields);

}  // namespace sphinx::build
