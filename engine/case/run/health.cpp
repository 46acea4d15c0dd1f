// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/run/health.h"

#include "bodies/voids.h"
#include "core/errors.h"
#include "core/log.h"
#include "core/parallel.h"
#include "core/sum_all.h"
#include "dynamics/group.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace sphinx::run {
namespace {

/// Above this part of the sound speed the density changes by more than a percent.
constexpr double speed_limit = 0.1;
constexpr double density_limit = 0.03;
/// Often enough to find the place again, seldom enough to cost nothing.
constexpr std::int64_t steps_between_places = 16;

void collectWriters(const loop::Line& line,
                    std::map<std::pair<std::string, std::string>, std::string>& writers) {
    for (const dynamics::FieldAccess& access : line.accesses)
        if (input::changes(access.mode)) writers[{access.body, access.field}] = line.label;
}

void collectWriters(const loop::Layer& layer,
                    std::map<std::pair<std::string, std::string>, std::string>& writers) {
    for (const loop::Step& step : layer.steps)
        std::visit([&](const auto& value) { collectWriters(value, writers); }, step.value);
}

struct Extremes {
    double speed2 = 0;
    double density = 0;  // largest deviation from rho0
    bool finite = true;
};

template <int Dim>
bool moves(const bodies::Body<Dim>& body) {
    return body.isFluid() || body.isElastic();
}

template <int Dim>
Extremes extremes(const bodies::Body<Dim>& body) {
    const auto& velocity = body.particles.vector(fields::velocity);
    const auto& density = body.particles.scalar(fields::density);
    const bodies::Voids<Dim> voids(body);  // nothing is wrong with them
    const double rho0 = body.material()->density();
    return reduceAll(
        body.size(), Extremes{},
        [&](std::size_t begin, std::size_t end) {
            double speed2 = 0;
            double deviation = 0;
            double sum = 0;  // not finite as soon as one term is not
            for (std::size_t i = begin; i < end; ++i) {
                const double s = velocity[i].squaredNorm();
                const double d = std::abs(density[i] - rho0);
                sum += s + d;
                speed2 = s > speed2 ? s : speed2;
                deviation = d > deviation && !voids.at(i, density[i]) ? d : deviation;
            }
            return Extremes{speed2, deviation, std::isfinite(sum)};
        },
        [](const Extremes& a, const Extremes& b) {
            return Extremes{std::max(a.speed2, b.speed2), std::max(a.density, b.density),
                            a.finite && b.finite};
        });
}

/// Of an elastic body whether velocities and densities are numbers is all there is to know.
template <int Dim>
bool isFinite(const bodies::Body<Dim>& body) {
    const auto& velocity = body.particles.vector(fields::velocity);
    const auto& density = body.particles.scalar(fields::density);
    const std::size_t n = body.size();
    return reduceAll(
        dynamics::groupCount(n), true,
        [&](std::size_t begin, std::size_t end) {
            Wide sum = 0;  // not finite as soon as one term is not
            for (std::size_t number = begin; number < end; ++number) {
                const dynamics::Group group = dynamics::groupOf(number, n);
                sum += load(velocity, group).squaredNorm() + abs(load(density, group));
            }
            return std::isfinite(sumLanes(sum.at));
        },
        [](bool a, bool b) { return a && b; }, dynamics::group_block);
}

/// The largest speed about the mean velocity: what moves as a whole compresses nothing.
template <int Dim>
double speedAboutMean(const bodies::Body<Dim>& body) {
    const auto& velocity = body.particles.vector(fields::velocity);
    const auto& mass = body.particles.scalar(fields::mass);
    const double whole = sumAll(body.size(), [&](std::size_t i) { return mass[i]; });
    const Vec<Dim> momentum =
        sumAll(body.size(), [&](std::size_t i) -> Vec<Dim> { return mass[i] * velocity[i]; });
    const Vec<Dim> mean = momentum / whole;
    return std::sqrt(maxAll(body.size(), 0.0,
                            [&](std::size_t i) { return (velocity[i] - mean).squaredNorm(); }));
}

}  // namespace

template <int Dim>
Health<Dim>::Health(bodies::World<Dim>& world, neighbors::Relations<Dim>& relations,
                    const loop::LoopFacts& facts)
    : world_(world) {
    for (auto& body : world.bodies)
        if (body->isElastic() && body->particles.find(fields::deformation_gradient.name))
            orders_.emplace_back(world, relations, *body);
    collectWriters(facts.plan.outermost, last_writer_);
    remember();
}

template <int Dim>
void Health<Dim>::remember() {
    for (const auto& body : world_.bodies) {
        if (!moves(*body)) continue;
        const auto& id = body->particles.id();
        const auto& position = body->particles.position();
        Last& last = last_[body->name];
        last.ids.assign(id.data(), id.data() + body->size());
        last.positions.assign(position.data(), position.data() + body->size());
    }
}

template <int Dim>
std::string Health<Dim>::lastPlace(const bodies::Body<Dim>& body,
                                   const std::vector<std::int64_t>& ids) const {
    const Last& last = last_.at(body.name);
    Box<Dim> box;
    for (std::size_t i = 0; i < last.ids.size(); ++i)
        if (std::binary_search(ids.begin(), ids.end(), last.ids[i])) box.include(last.positions[i]);
    if (box.empty()) return "";
    const std::string lower = world_.placeText(box.lower), upper = world_.placeText(box.upper);
    return ids.size() == 1 ? fmt::format(", last seen at {},", lower)
                           : fmt::format(", last seen between {} and {},", lower, upper);
}

template <int Dim>
void Health<Dim>::check(const Clock& clock) {
    for (const auto& body : world_.bodies) {
        if (!moves(*body)) continue;
        if (!body->isFluid()) {
            if (!isFinite(*body)) fail(*body, clock);
            continue;
        }
        const Extremes e = extremes(*body);
        if (!e.finite) fail(*body, clock);
        const materials::Fluid& fluid = *body->fluid().material;
        if (std::sqrt(e.speed2) > speed_limit * fluid.soundSpeed() && !warned_speed_[body->name])
            checkSpeed(*body, clock);
        const double rho0 = fluid.density();
        if (e.density > density_limit * rho0 && !warned_density_[body->name]) {
            warned_density_[body->name] = true;
            log::warning(fmt::format(
                "time {}: the density of {} is off by {:.3g} % (up to 3 % is normal)",
                world_.quantityText(clock.time, unit::time), body->name, 100 * e.density / rho0));
        }
    }
    for (auto& order : orders_) order.check(clock);
    if (clock.steps % steps_between_places == 0) remember();
}

template <int Dim>
void Health<Dim>::checkSpeed(const bodies::Body<Dim>& body, const Clock& clock) {
    const double sound = body.fluid().material->soundSpeed();
    const double speed = speedAboutMean(body);
    if (!(speed > speed_limit * sound)) return;
    warned_speed_[body.name] = true;
    log::warning(fmt::format(
        "time {}: {} moves at {:.3g}{} about its mean velocity, more than a "
        "tenth of its sound speed {:.3g}{}; raise sound_speed",
        world_.quantityText(clock.time, unit::time), body.name, speed,
        world_.units.suffix(unit::velocity), sound, world_.units.suffix(unit::velocity)));
}

template <int Dim>
std::vector<std::int64_t> Health<Dim>::spoilt(const bodies::Body<Dim>& body,
                                              const particles::FieldInfo& info) {
    std::vector<std::int64_t> ids;
    const particles::FieldBase* field = body.particles.find(info.name);
    if (!field) return ids;
    const auto width = static_cast<std::size_t>(field->components());
    const std::int64_t* id = body.particles.find(fields::id.name)->integers();
    for (std::size_t i = 0; i < body.size(); ++i) {
        const double* values = field->numbers() + i * width;
        if (!std::all_of(values, values + width, [](double v) { return std::isfinite(v); }))
            ids.push_back(id[i]);
    }
    std::sort(ids.begin(), ids.end());
    return ids;
}

template <int Dim>
void Health<Dim>::fail(const bodies::Body<Dim>& body, const Clock& clock) const {
    // Particles spoil their neighbors: the field that fewest have lost is the closest to the cause.
    const particles::FieldInfo* info = &fields::density;
    std::vector<std::int64_t> ids = spoilt(body, *info);
    std::vector<std::int64_t> others = spoilt(body, fields::velocity);
    if (ids.empty() || (!others.empty() && others.size() < ids.size())) {
        info = &fields::velocity;
        ids = std::move(others);
    }
    if (ids.empty())
        throw PhysicsError(fmt::format("speeds of {} are too large to square at time {}", body.name,
                                       world_.quantityText(clock.time, unit::time)));
    const auto writer = last_writer_.find({body.name, std::string(info->name)});
    throw PhysicsError(fmt::format(
        "{} of {} of {}{} is not finite after {} at time {}; a smaller cfl{} may help", info->name,
        ids.size() == 1 ? fmt::format("particle {}", ids.front())
                        : fmt::format("{} of {} particles", ids.size(), body.size()),
        body.name, lastPlace(body, ids), writer == last_writer_.end() ? "the step" : writer->second,
        world_.quantityText(clock.time, unit::time),
        body.isFluid() ? " or a higher sound_speed" : ""));
}

template class Health<2>;
template class Health<3>;

}  // namespace sphinx::run
