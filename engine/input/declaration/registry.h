// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/declaration.h"

#include <map>

namespace sphinx::input {

/// All declarations, filled by explicit functions such as registerDynamics(Registry&).
class Registry {
 public:
    /// A new declaration; its address stays valid as long as the registry. Asserts that the name is
    /// new within its kind.
    template <class P>
    Declared<P>& declare(Kind kind, std::string name) {
        return add(std::make_unique<Declared<P>>(kind, std::move(name)));
    }
    /// The same for a declaration of a class of its own.
    template <class D>
    D& add(std::unique_ptr<D> declared) {
        D& reference = *declared;
        insert(std::move(declared));
        return reference;
    }

    /// nullptr when there is none.
    const Declaration* find(Kind kind, std::string_view name) const;
    std::vector<std::string> names(Kind kind) const;  ///< sorted

 private:
    void insert(std::unique_ptr<Declaration> declaration);

    std::map<std::pair<Kind, std::string>, std::unique_ptr<Declaration>> declarations_;
};

}  // namespace sphinx::input
