// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/fluid_step.h"
#include "dynamics/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace sphinx::dynamics::fluid {
namespace {

/// Acoustic step of a weakly compressible fluid (fluid_step.h). Fluids that see each other are
/// stepped by one method (`bodies`), so that each sum finds all of them at the same instant: both
/// halves go phase by phase, each for all fluids in turn.
struct PressureRelaxationParameters {
    std::optional<input::Name> body;
    std::vector<input::Name> bodies;
    Riemann riemann = Riemann::low_dissipation;
};

std::vector<input::Name> bodiesOf(const PressureRelaxationParameters& p) {
    return p.body ? std::vector{*p.body} : p.bodies;
}

/// The steps of all fluids that see each other.
template <int Dim>
class PressureRelaxation final : public Method {
 public:
    PressureRelaxation(Context<Dim>& context, const PressureRelaxationParameters& p) {
        for (const input::Name& body : bodiesOf(p))
            steps_.push_back(
                std::make_unique<FluidStep<Dim>>(context, bodyOf(context, body), p.riemann));
        for (const auto& step : steps_)
            for (const auto& other : steps_)
                if (step != other) step->meet(*other);
    }

    void firstHalf(const Clock& clock) {
        for (const auto& step : steps_) step->predict(clock);
        for (const auto& step : steps_) step->kick(clock);
    }
    void secondHalf(const Clock& clock) {
        for (const auto& step : steps_) step->answerSolids(clock);
        for (const auto& step : steps_) step->compress(clock);
    }
    std::size_t workSize() const override {
        std::size_t n = 0;
        for (const auto& step : steps_) n += step->workSize();
        return n;
    }
    void rest() override {
        for (const auto& step : steps_) step->rest();
    }
    void transfer(Archive& archive) override {
        if (steps_.size() == 1) return steps_.front()->transfer(archive);
        for (const auto& step : steps_) {
            Section section(archive, step->fluid().name);
            step->transfer(archive);
        }
    }

 private:
    std::vector<std::unique_ptr<FluidStep<Dim>>> steps_;
};

/// What both sums need of the solids that the fluid sees.
input::Action& readSolids(input::Action& action) {
    return action.reads("neighbors.solid", {"volume"})
        .reads("neighbors.rigid", {"normal"})
        .reads("neighbors.driven", {"velocity", "acceleration"})
        .reads("neighbors.responding", {"average_velocity"});
}

/// Fluids that see each other are stepped together. Stresses at an interface are those of constant
/// viscosities (LiquidFriction).
void checkTogether(const input::Component& method, WrittenCase& written) {
    const std::vector<input::Name> own = bodiesOf(method.as<PressureRelaxationParameters>());
    const auto steps = [&](std::string_view body) {
        return std::ranges::any_of(own, [&](const auto& name) { return name.text == body; });
    };
    for (const input::Name& name : own)
        for (const WrittenCase::Sight& sight : written.topology) {
            if (sight.body.text != name.text || sight.seen.text == name.text ||
                !written.isFluid(sight.seen.text))
                continue;
            if (!steps(sight.seen.text))
                written.diagnostics.error(
                    name.place,
                    fmt::format("{0} sees {1}, but {2} does not step {1}: one method steps both, "
                                "'bodies: [{0}, {1}]'",
                                name.text, sight.seen.text, method.name));
            const std::string& material = written.materials.at(name.text)->declaration->name();
            if (material != "weakly_compressible_fluid")
                written.diagnostics.error(
                    name.place, fmt::format("{} sees {} and is a {}: fluids that see each other "
                                            "are of weakly_compressible_fluid",
                                            name.text, sight.seen.text, material));
        }
}

/// Beyond this ratio of densities nothing was measured.
constexpr double largest_ratio = 10;

/// Sums over both liquids are whole where both have the same lattice and kernel.
template <int Dim>
void checkLiquids(const input::Component& method, BuiltCase<Dim>& built) {
    const std::vector<input::Name> own = bodiesOf(method.as<PressureRelaxationParameters>());
    for (std::size_t k = 1; k < own.size(); ++k)
        for (std::size_t m = 0; m < k; ++m) {
            const Body<Dim>& one = *built.world.find(own[m].text);
            const Body<Dim>& other = *built.world.find(own[k].text);
            if (!built.sees(one.name, other.name)) continue;
            if (one.spacing != other.spacing || one.kernel.type() != other.kernel.type() ||
                one.kernel.smoothingLength() != other.kernel.smoothingLength())
                built.diagnostics.error(
                    own[k].place,
                    fmt::format("{} and {} see each other, so they have one spacing, one kernel "
                                "and one smoothing length",
                                one.name, other.name));
            const double a = one.fluid().material->density();
            const double b = other.fluid().material->density();
            const double ratio = std::max(a, b) / std::min(a, b);
            if (ratio > largest_ratio * (1 + 1e-9))
                built.diagnostics.warning(
                    built.materials.at(a < b ? one.name : other.name)->placeOf("density"),
                    fmt::format("the densities of {} and {} differ by a factor of {:.3g}: what "
                                "acts between liquids was tried up to {}",
                                one.name, other.name, ratio, largest_ratio));
        }
}

}  // namespace

void declarePressureRelaxation(input::Registry& registry) {
    using P = PressureRelaxationParameters;
    auto& d = declareMethod<PressureRelaxation, P>(registry, "fluid.pressure_relaxation");
    d.summary("Acoustic step of a weakly compressible fluid in two halves around the momentum sum");
    d.formula(
        "guide (51), (56)-(58) as drift-kick-drift; m_i dv_i/dt = -2 sum_j p*_ij e_ij W' V_i V_j, "
        "drho_i/dt = 2 rho_i sum_j (v_i - v*_ij) . e_ij W' V_j; between fluids p* = s_j p_i + s_i "
        "p_j "
        "+ jump, v* = s_i v_i + s_j v_j, s_i = rho_i/(rho_i + rho_j)");
    d.cite("guide", "(51), (56)-(58)").cite("Zhang, Hu & Adams 2017");
    d.cite("Rezavand, Zhang & Hu 2020", "(jump between two fluids)");
    d.optional("body", &P::body, input::bodyReference({"fluid"}), "fluid that is stepped");
    d.optional("bodies", &P::bodies, input::list(input::bodyReference({"fluid"})),
               "in place of body: fluids that see each other, which are stepped together");
    d.check("body", [](const P& p) -> std::string {
        if (p.body && !p.bodies.empty()) return "either body or bodies, not both";
        return p.body || !p.bodies.empty() ? "" : "body or bodies says which fluid is stepped";
    });
    d.check("bodies", [](const P& p) -> std::string {
        for (std::size_t k = 1; k < p.bodies.size(); ++k)
            for (std::size_t m = 0; m < k; ++m)
                if (p.bodies[k].text == p.bodies[m].text)
                    return p.bodies[k].text + " is listed twice";
        return "";
    });
    d.optional("riemann", &P::riemann,
               input::choice<Riemann>({
                   {"none", Riemann::none, "averages: no dissipation"},
                   {"dissipative", Riemann::dissipative, "linearised Riemann problem"},
                   {"low_dissipation", Riemann::low_dissipation, "the same with the limiter"},
               }),
               "how pressure and velocity between two particles are found");
    d.trait("sums_over_itself");
    d.rule([](const input::Component& method, WrittenCase& written) {
        warnUnbounded(method, written, "fluid.acoustic_time_step");
        checkTogether(method, written);
    });
    d.worldRule([](const auto& method, auto& built) { checkLiquids(method, built); });
    auto& first = d.action(
        "first_half", "density, pressure and position to the half step; velocity by a whole step",
        [](auto& method, const Clock& clock) { method.firstHalf(clock); });
    auto& second = d.action("second_half",
                            "rate of change of the density; density and position to the full step",
                            [](auto& method, const Clock& clock) { method.secondHalf(clock); });
    for (const char* owner : {"body", "bodies"}) {
        first.reads(owner, {"velocity", "mass", "density", "density_rate", "slack", "position",
                            "external_acceleration", "neighbors"});
        second.reads(owner, {"velocity", "pressure", "volume", "density", "position",
                             "external_acceleration", "mass", "neighbors"});
    }
    readSolids(first);
    readSolids(second).mayRead("neighbors.responding", {"slip"});
    for (const char* owner : {"body", "bodies"}) {
        first.writes(owner, {"density", "pressure", "volume", "position", "velocity"})
            .opens(owner, "step");
        second.writes(owner, {"density_rate", "density", "position", "velocity"})
            .closes(owner, "step");
    }
}

}  // namespace sphinx::dynamics::fluid
