// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/reduce_motion.h"

#include "bodies/voids.h"
#include "core/sum_all.h"
#include "dynamics/load.h"
#include "dynamics/solid/internal_energy.h"
#include "io/series/columns.h"
#include "materials/fluid_laws.h"
#include "measure/reduce.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sphinx::measure {
namespace {

template <class T, int Dim>
const particles::Field<T>& require(const ReducedBody<Dim>& reduced,
                                   const particles::FieldInfo& info) {
    return dynamic_cast<const particles::Field<T>&>(
        io::fieldOf(*reduced.body, input::Name{std::string(info.name), reduced.place}));
}

/// Position, velocity and mass, for most of the sums.
template <int Dim>
struct Motion {
    explicit Motion(const ReducedBody<Dim>& reduced)
        : particles(reduced),
          body(reduced.body),
          x(&body->particles.position()),
          v(&require<Vec<Dim>>(reduced, fields::velocity)),
          m(&require<double>(reduced, fields::mass)) {}

    /// Of the material; images are none.
    double mass(std::size_t i) const { return body->hasMass(i) ? (*m)[i] : 0; }
    double kinetic(std::size_t i) const { return 0.5 * mass(i) * (*v)[i].squaredNorm(); }

    ReducedParticles<Dim> particles;
    bodies::Body<Dim>* body;
    const particles::Field<Vec<Dim>>* x;
    const particles::Field<Vec<Dim>>* v;
    const particles::Field<double>* m;
};

/// A source of N sums whose terms `term(i)` gives as an array.
template <int N, int Dim, class Term>
std::unique_ptr<io::SeriesSource> sums(std::vector<io::SeriesQuantity> quantities,
                                       const ReducedParticles<Dim>& particles, Term term) {
    return std::make_unique<ReduceSource>(
        std::move(quantities), [particles, term](std::span<double> row) {
            const std::array<double, N> sum =
                sumAll(particles.size(), [&](std::size_t n) { return term(particles[n]); });
            std::copy(sum.begin(), sum.end(), row.begin());
        });
}

/// sum of m e(rho); a void holds no energy.
template <int Dim>
double fluidEnergy(const Motion<Dim>& motion, const particles::Field<double>& density,
                   const bodies::Voids<Dim>& voids) {
    return materials::withLaw(*motion.body->fluid().material, [&](const auto& law) {
        return sumAll(motion.particles.size(), [&](std::size_t n) {
            const std::size_t i = motion.particles[n];
            return voids.at(i, density[i]) ? 0 : motion.mass(i) * law.internalEnergy(density[i]);
        });
    });
}

}  // namespace

template <int Dim>
std::unique_ptr<io::SeriesSource> mechanicalEnergy(const ReducedBody<Dim>& reduced) {
    if (reduced.body->isWall())
        io::failAt(reduced.place,
                   "'" + reduced.body->name +
                       "' is rigid: it has no internal energy; ask for kinetic_energy");
    if (reduced.part && reduced.body->isElastic())
        io::failAt(reduced.place, "the internal energy is that of all of '" + reduced.body->name +
                                      "'; of a part ask for kinetic_energy");
    const std::string energy = reduced.units.text(unit::energy);
    const Motion<Dim> motion(reduced);
    const auto* density = &require<double>(reduced, fields::density);
    const bodies::Voids<Dim> voids(*reduced.body);
    neighbors::Relations<Dim>* relations = reduced.relations;
    return std::make_unique<ReduceSource>(
        std::vector<io::SeriesQuantity>{
            {"kinetic", energy, "sum of m v^2/2", {}},
            {"potential", energy, "-sum of m g . x", {}},
            {"internal",
             energy,
             "of a fluid sum of m e(rho), zero at the density of zero pressure; of an elastic body "
             "sum of V W(F), with its hourglass control",
             {}},
            {"total", energy, "kinetic + potential + internal", {}}},
        [motion, density, voids, relations](std::span<double> row) {
            bodies::Body<Dim>& body = *motion.body;
            const Vec<Dim> g = body.gravity();
            const auto sum = sumAll(motion.particles.size(), [&](std::size_t n) {
                const std::size_t i = motion.particles[n];
                return std::array<double, 2>{motion.kinetic(i),
                                             -motion.mass(i) * g.dot((*motion.x)[i])};
            });
            std::copy(sum.begin(), sum.end(), row.begin());
            row[2] = body.isFluid() ? fluidEnergy(motion, *density, voids)
                                    : dynamics::solid::internalEnergy(body, *relations);
            row[3] = row[0] + row[1] + row[2];
        });
}

template <int Dim>
std::unique_ptr<io::SeriesSource> kineticEnergy(const ReducedBody<Dim>& reduced) {
    const Motion<Dim> motion(reduced);
    return sums<1>({{"kinetic", reduced.units.text(unit::energy), "sum of m v^2/2", {}}},
                   motion.particles,
                   [motion](std::size_t i) { return std::array<double, 1>{motion.kinetic(i)}; });
}

template <int Dim>
std::unique_ptr<io::SeriesSource> mass(const ReducedBody<Dim>& reduced) {
    const Motion<Dim> motion(reduced);
    std::vector<io::SeriesQuantity> quantities{
        {"mass",
         reduced.units.text(unit::mass),
         "of the " + reduced.what() + ", without what a clamp holds",
         {}},
        {"particles", "", "number of particles", {}}};
    if (!reduced.part)
        quantities.push_back({"removed", "", "particles that have left the body", {}});
    return std::make_unique<ReduceSource>(std::move(quantities), [motion](std::span<double> row) {
        const ReducedParticles<Dim>& particles = motion.particles;
        row[0] = sumAll(particles.size(), [&](std::size_t n) { return motion.mass(particles[n]); });
        row[1] = static_cast<double>(particles.size());
        if (!particles.part)
            row[2] = static_cast<double>(particles.body->particles.nextId()) - row[1];
    });
}

template <int Dim>
std::unique_ptr<io::SeriesSource> momentum(const ReducedBody<Dim>& reduced) {
    const Motion<Dim> motion(reduced);
    return sums<Dim>({{"momentum", reduced.units.text(unit::momentum), "sum of m v",
                       io::componentLabels<Dim>(particles::Rank::vector)}},
                     motion.particles, [motion](std::size_t i) {
                         std::array<double, Dim> term;
                         for (int k = 0; k < Dim; ++k) term[k] = motion.mass(i) * (*motion.v)[i][k];
                         return term;
                     });
}

template <int Dim>
std::unique_ptr<io::SeriesSource> angularMomentum(const ReducedBody<Dim>& reduced) {
    const Motion<Dim> motion(reduced);
    io::SeriesQuantity quantity{"angular_momentum",
                                reduced.units.text(unit::momentum * unit::length),
                                "sum of m x cross v about the origin", io::momentLabels<Dim>()};
    constexpr int size = dynamics::Moment<Dim>::SizeAtCompileTime;
    return sums<size>({std::move(quantity)}, motion.particles, [motion](std::size_t i) {
        const dynamics::Moment<Dim> turn = dynamics::momentOf<Dim>((*motion.x)[i], (*motion.v)[i]);
        std::array<double, size> term;
        for (int k = 0; k < size; ++k) term[k] = motion.mass(i) * turn[k];
        return term;
    });
}

template <int Dim>
std::unique_ptr<io::SeriesSource> contactForce(const ReducedBody<Dim>& reduced,
                                               const std::optional<Vec<Dim>>& about) {
    const auto* force = &require<Vec<Dim>>(reduced, fields::contact_force);
    const auto* x = &reduced.body->particles.position();
    std::vector<io::SeriesQuantity> quantities{{"contact_force", reduced.units.text(unit::force),
                                                "force of other surfaces",
                                                io::componentLabels<Dim>(particles::Rank::vector)}};
    if (about)
        quantities.push_back({"contact_moment", reduced.units.text(unit::force * unit::length),
                              "moment of it about the point", io::momentLabels<Dim>()});
    const ReducedParticles<Dim> particles = reduced;
    return std::make_unique<ReduceSource>(
        std::move(quantities), [particles, force, x, about](std::span<double> row) {
            const Vec<Dim> from = about.value_or(Vec<Dim>(Vec<Dim>::Zero()));
            const auto load = sumAll(particles.size(), [&](std::size_t n) {
                dynamics::Load<Dim> one;
                one.add((*x)[particles[n]] - from, (*force)[particles[n]]);
                return one;
            });
            std::copy(load.force.begin(), load.force.end(), row.begin());
            if (about) std::copy(load.moment.begin(), load.moment.end(), row.begin() + Dim);
        });
}

template <int Dim>
std::unique_ptr<io::SeriesSource> maximumSpeed(const ReducedBody<Dim>& reduced) {
    const ReducedParticles<Dim> particles = reduced;
    const auto* v = &require<Vec<Dim>>(reduced, fields::velocity);
    return std::make_unique<ReduceSource>(
        std::vector<io::SeriesQuantity>{
            {"maximum_speed", reduced.units.text(unit::velocity), "largest abs(v)", {}}},
        [particles, v](std::span<double> row) {
            row[0] = particles.size() == 0
                         ? nan_value
                         : std::sqrt(maxAll(particles.size(), 0, [&](std::size_t n) {
                               return (*v)[particles[n]].squaredNorm();
                           }));
        });
}

template <int Dim>
std::unique_ptr<io::SeriesSource> frontPosition(const ReducedBody<Dim>& reduced, int axis) {
    const ReducedParticles<Dim> particles = reduced;
    return std::make_unique<ReduceSource>(
        std::vector<io::SeriesQuantity>{{"front_position",
                                         reduced.units.text(unit::length),
                                         std::string("largest ") + "xyz" [axis],
                                         {}}},
        [particles, axis](std::span<double> row) {
            const particles::Field<Vec<Dim>>& x = particles.body->particles.position();
            row[0] = particles.size() == 0
                         ? nan_value
                         : maxAll(particles.size(), x[particles[0]][axis],
                                  [&](std::size_t n) { return x[particles[n]][axis]; });
        });
}

#define SPHINX_INSTANTIATE(Dim)                                                              \
    template std::unique_ptr<io::SeriesSource> mechanicalEnergy(const ReducedBody<Dim>&);    \
    template std::unique_ptr<io::SeriesSource> kineticEnergy(const ReducedBody<Dim>&);       \
    template std::unique_ptr<io::SeriesSource> mass(const ReducedBody<Dim>&);                \
    template std::unique_ptr<io::SeriesSource> momentum(const ReducedBody<Dim>&);            \
    template std::unique_ptr<io::SeriesSource> angularMomentum(const ReducedBody<Dim>&);     \
    template std::unique_ptr<io::SeriesSource> contactForce(const ReducedBody<Dim>&,         \
                                                            const std::optional<Vec<Dim>>&); \
    template std::unique_ptr<io::SeriesSource> maximumSpeed(const ReducedBody<Dim>&);        \
    template std::unique_ptr<io::SeriesSource> frontPosition(const ReducedBody<Dim>&, int axis);
SPHINX_INSTANTIATE(2)
SPHINX_INSTANTIATE(3)
#undef SPHINX_INSTANTIATE

}  // namespace sphinx::measure
