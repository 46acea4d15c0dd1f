// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/solid/hourglass_rule.h"

#include <fmt/format.h>

#include <optional>

namespace sphinx::dynamics::solid {
namespace {

struct Control {
    std::string body;
    bool on;
};

std::optional<Control> controlOf(const input::Component& method) {
    if (const auto* p = method.find<StressRelaxationParameters>())
        return Control{p->body.text, p->hourglass_control};
    if (const auto* p = method.find<StressUpdateParameters>())
        return Control{p->body.text, p->hourglass_control};
    return {};
}

}  // namespace

void checkHourglassControl(const input::Component& method, WrittenCase& written) {
    if (!written.calls(method)) return;
    const Control own = *controlOf(method);
    for (const input::Component* first : written.called) {
        const std::optional<Control> other = controlOf(*first);
        if (!other || other->body != own.body) continue;
        if (other->on != own.on)
            written.diagnostics.error(
                method.placeOf("hourglass_control"),
                fmt::format("hourglass_control is {} here but {} in {}: a body has one", own.on,
                            other->on, first->name));
        return;
    }
}

}  // namespace sphinx::dynamics::solid
