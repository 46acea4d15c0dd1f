// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/declaration/registry.h"

namespace sphinx::input {

void Registry::insert(std::unique_ptr<Declaration> declaration) {
    std::pair key(declaration->kind(), declaration->name());
    [[maybe_unused]] const bool inserted =
        declarations_.emplace(std::move(key), std::move(declaration)).second;
    assert(inserted && "declared twice");
}

const Declaration* Registry::find(Kind kind, std::string_view name) const {
    const auto found = declarations_.find(std::pair(kind, std::string(name)));
    return found == declarations_.end() ? nullptr : found->second.get();
}

std::vector<std::string> Registry::names(Kind kind) const {
    std::vector<std::string> names;
    for (const auto& [key, declaration] : declarations_)
        if (key.first == kind) names.push_back(key.second);
    return names;
}

}  // namespace sphinx::input
