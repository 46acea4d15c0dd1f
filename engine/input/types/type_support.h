// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the files that define types share.

#include "input/declaration/schema.h"
#include "input/expressions/units.h"
#include "input/types/type.h"

namespace sphinx::input {

/// Place of what a value was read from; none for a default.
inline Place placeOf(const Node* source) { return source ? source->place : Place{}; }

/// What element k of a list was read from.
inline const Node* itemOf(const Node* source, std::size_t k) {
    return source && source->isList() && k < source->items.size() ? &source->items[k] : source;
}

/// ", length/time", or nothing for a plain number.
inline std::string unitSuffix(Dimension unit) {
    return unit == unit::none ? "" : ", " + dimensionText(unit);
}

/// A number may also be written as an expression or a quantity.
inline Node numberSchema() {
    Node schema = Node::map();
    schema.set("type", Node::list({Node::string("number"), Node::string("string")}));
    return schema;
}

}  // namespace sphinx::input
