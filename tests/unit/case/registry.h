// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/language/register.h"

namespace sphinx::test {

/// Everything that a case can name.
inline const input::Registry& registry() {
    static const input::Registry& all = []() -> input::Registry& {
        auto* made = new input::Registry;
        language::registerAll(*made);
        return *made;
    }();
    return all;
}

}  // namespace sphinx::test
