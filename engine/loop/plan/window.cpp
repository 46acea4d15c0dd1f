// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/plan/window.h"

#include <fmt/format.h>

namespace sphinx::loop {

std::string describe(const Window& window, const std::string& unit) {
    std::string text;
    if (window.from) text = fmt::format("from {:g}{}", *window.from, unit);
    if (window.until)
        text += fmt::format("{}until {:g}{}", text.empty() ? "" : " ", *window.until, unit);
    return text;
}

}  // namespace sphinx::loop
