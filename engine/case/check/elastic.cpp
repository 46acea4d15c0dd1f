// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check/elastic.h"

#include "dynamics/solid/stress_relaxation.h"
#include "dynamics/solid/stress_update.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>
#include <map>
#include <string>

namespace sphinx::model {
namespace {

void checkHourglassControl(const Case& model, input::Diagnostics& diagnostics) {
    struct First {
        bool control;
        std::string method;
    };
    std::map<std::string, First> firsts;  // by body
    const auto compare = [&](const Component& method, const auto& p) {
        const First& first =
            firsts.try_emplace(p.body.text, p.hourglass_control, method.name).first->second;
        if (first.control == p.hourglass_control) return;
        diagnostics.error(method.placeOf("hourglass_control"),
                          fmt::format("hourglass_control is {} here but {} in {}: a body has one",
                                      p.hourglass_control, first.control, first.method));
    };
    for (const Component& method : model.dynamics) {
        if (!model.calls(method.name)) continue;
        if (method.declaration->name() == "solid.stress_relaxation")
            compare(method, method.as<solid::StressRelaxationParameters>());
        if (method.declaration->name() == "solid.stress_update")
            compare(method, method.as<solid::StressUpdateParameters>());
    }
}

}  // namespace

template <int Dim>
void checkElastic(const Case& model, const World<Dim>& world, input::Diagnostics& diagnostics) {
    checkHourglassControl(model, diagnostics);
    for (const Body& source : model.bodies) {
        if (source.role != Role::elastic) continue;
        sphinx::Body<Dim>& body = *world.find(source.name);
        for (int axis = 0; axis < Dim; ++axis) {
            if (!world.domain.periodic[axis]) continue;
            double low = std::numeric_limits<double>::infinity();
            double high = -low;
            for (const sphinx::Body<Dim>* piece : body.piece())
                for (std::size_t i = 0; i < piece->size(); ++i) {
                    low = std::min(low, piece->particles.position()[i][axis]);
                    high = std::max(high, piece->particles.position()[i][axis]);
                }
            const double gap =
                world.domain.bounds.upper[axis] - world.domain.bounds.lower[axis] - (high - low);
            const double reach = body.kernel.cutoff();
            if (!(gap < reach)) continue;
            diagnostics.error(
                source.place,
                fmt::format(
                    "{} is elastic and reaches across the periodic side in {}: its particles "
                    "must leave a gap of {} or more, here it is {}",
                    body.name, "xyz"[axis], world.quantityText(reach, unit::length),
                    world.quantityText(std::max(gap, 0.0), unit::length)));
            break;
        }
    }
}

template void checkElastic(const Case&, const World<2>&, input::Diagnostics&);
template void checkElastic(const Case&, const World<3>&, input::Diagnostics&);

}  // namespace sphinx::model
