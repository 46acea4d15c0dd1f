// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"
#include "bodies/domain.h"
#include "core/place_text.h"
#include "core/precision.h"
#include "input/expressions/units.h"

#include <experimental/propagate_const>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sphinx::bodies {

/// All bodies of a case and the space they live in.
template <int Dim>
struct World {
    input::UnitSystem units;  ///< of messages
    Domain<Dim> domain;
    Precision precision = Precision::single;  ///< of the terms of a fluid's own pairs
    /// Of a const world the bodies are const, too.
    using OwnedBody = std::experimental::propagate_const<std::unique_ptr<Body<Dim>>>;
    std::vector<OwnedBody> bodies;
    /// Those that the case names, for what acts in a part of space.
    std::map<std::string, geometry::ShapePointer<Dim>, std::less<>> shapes;

    /// "0.1 m", "(1, 2) m", for messages.
    std::string quantityText(double value, Dimension dimension) const {
        return fmt::format("{:g}{}", value, units.suffix(dimension));
    }
    std::string placeText(const Vec<Dim>& p) const {
        return sphinx::placeText<Dim>(p) + units.suffix(unit::length);
    }

    /// Null when there is none of that name.
    const Body<Dim>* find(std::string_view name) const {
        for (const auto& body : bodies)
            if (body->name == name) return body.get();
        return nullptr;
    }
    Body<Dim>* find(std::string_view name) {
        return const_cast<Body<Dim>*>(std::as_const(*this).find(name));
    }
};

}  // namespace sphinx::bodies
