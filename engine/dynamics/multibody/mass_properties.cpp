// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/multibody/mass_properties.h"

#include "core/sum_all.h"
#include "dynamics/multibody/in_space.h"
#include "dynamics/part.h"

#include <cmath>

namespace sphinx::dynamics::multibody {
namespace {

template <int Dim>
const Field<Vec<Dim>>& startOf(const Body<Dim>& body) {
    const ParticleSet<Dim>& particles = body.particles;
    if (!particles.find(fields::initial_position.name)) return particles.position();
    return particles.vector(fields::initial_position);
}

}  // namespace

template <int Dim>
MassProperties massProperties(const World<Dim>& world, const std::vector<input::Name>& names) {
    MassProperties all;
    Vector moment = Vector::Zero();
    for (const input::Name& name : names) {
        const ConstPart<Dim> part(world, name);
        const auto& mass = part.body().particles.scalar(fields::mass);
        const auto& start = startOf(part.body());
        all.particles += part.size();
        all.mass += part.mass();
        moment += inSpace<Dim>(sumAll(part.size(), [&](std::size_t n) -> Vec<Dim> {
            return mass[part[n]] * start[part[n]];
        }));
    }
    if (!(all.mass > 0)) return all;
    all.center = moment / all.mass;
    for (const input::Name& name : names) {
        const ConstPart<Dim> part(world, name);
        const auto& mass = part.body().particles.scalar(fields::mass);
        const auto& volume = part.body().particles.scalar(fields::volume);
        const auto& start = startOf(part.body());
        const std::array<double, 9> sum = sumAll(part.size(), [&](std::size_t n) {
            const std::size_t i = part[n];
            const Vector r = inSpace<Dim>(start[i]) - all.center;
            const double d = std::pow(volume[i], 1.0 / Dim);
            const Matrix own = Matrix::Identity() * (d * d / 6);
            const Matrix I =
                mass[i] * (r.squaredNorm() * Matrix::Identity() - r * r.transpose() + own);
            std::array<double, 9> values;
            std::copy_n(I.data(), 9, values.begin());
            return values;
        });
        all.inertia += Eigen::Map<const Matrix>(sum.data());
    }
    return all;
}

template MassProperties massProperties(const World<2>&, const std::vector<input::Name>&);
template MassProperties massProperties(const World<3>&, const std::vector<input::Name>&);

}  // namespace sphinx::dynamics::multibody
