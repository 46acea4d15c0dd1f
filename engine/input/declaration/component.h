// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/declaration.h"

namespace sphinx::input {

/// A named entry of a case that chose its `type` from the registry, with its parameters.
struct Component {
    std::string name;                          ///< its key in the block
    Place place;                               ///< of that key
    const Declaration* declaration = nullptr;  ///< never null once read
    std::shared_ptr<const void> parameters;    ///< of declaration->parametersType()
    std::vector<std::pair<std::string, Place>> parameter_places;  ///< of those given

    template <class P>
    const P& as() const {
        assert(declaration->parametersType() == typeid(P));
        return *static_cast<const P*>(parameters.get());
    }
    /// The parameters if they are of that type, or nullptr.
    template <class P>
    const P* find() const {
        return declaration->parametersType() == typeid(P) ? &as<P>() : nullptr;
    }
    /// Names that a parameter refers to, whatever its type.
    std::vector<Name> references(const Parameter& parameter) const {
        std::vector<Name> names;
        parameter.type->names(parameter.in(parameters.get()), names);
        return names;
    }
    /// None where there is no such parameter.
    std::vector<Name> references(std::string_view parameter) const {
        const Parameter* found = declaration->parameter(parameter);
        return found ? references(*found) : std::vector<Name>{};
    }
    /// The value of a parameter that is declared with that type, of a declaration whose parameters
    /// are not known here; null where there is no such parameter.
    template <class T>
    const T* value(std::string_view parameter) const {
        const Parameter* found = declaration->parameter(parameter);
        return found ? static_cast<const T*>(found->in(parameters.get())) : nullptr;
    }
    /// Where the parameter was given, or the place of the entry when it is a default.
    Place placeOf(std::string_view parameter) const {
        for (const auto& [name, given] : parameter_places)
            if (name == parameter) return given;
        return place;
    }
};

}  // namespace sphinx::input
