// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"

#include <algorithm>
#include <type_traits>

namespace sphinx::test {

/// Lists hold gradients and distances as 32-bit whole numbers.
inline constexpr double list_error = 1e-8;
/// Of sums over pairs in single precision: some roundings of 6e-8.
inline constexpr double single_error = 1e-6;

/// Gives every particle the value of(x) of a scalar or vector field, x being its position.
template <int Dim, class Of>
void give(bodies::Body<Dim>& body, const particles::FieldInfo& field, Of&& of) {
    particles::ParticleSet<Dim>& p = body.particles;
    for (std::size_t i = 0; i < body.size(); ++i) {
        if constexpr (std::is_arithmetic_v<std::invoke_result_t<Of&, const Vec<Dim>&>>)
            p.scalar(field)[i] = of(p.position()[i]);
        else
            p.vector(field)[i] = of(p.position()[i]);
    }
}

template <int Dim>
double massOf(bodies::Body<Dim>& body) {
    double sum = 0;
    for (std::size_t i = 0; i < body.size(); ++i) sum += body.particles.scalar(fields::mass)[i];
    return sum;
}

/// Mass times value, over the particles: the momentum of their velocities, the force of their
/// accelerations.
template <int Dim>
Vec<Dim> massTimes(bodies::Body<Dim>& body, const particles::FieldInfo& field) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (std::size_t i = 0; i < body.size(); ++i)
        sum += body.particles.scalar(fields::mass)[i] * body.particles.vector(field)[i];
    return sum;
}

template <int Dim>
Vec<Dim> centreOf(bodies::Body<Dim>& body) {
    return massTimes(body, fields::position) / massOf(body);
}

/// The particle nearest to a place.
template <int Dim>
std::size_t nearest(const bodies::Body<Dim>& body, const Vec<Dim>& place) {
    const auto& x = body.particles.position();
    std::size_t found = 0;
    for (std::size_t i = 0; i < body.size(); ++i)
        if ((x[i] - place).norm() < (x[found] - place).norm()) found = i;
    return found;
}

/// All particles, from the last to the first.
template <int Dim>
AlignedVector<Index> reversed(const bodies::Body<Dim>& body) {
    AlignedVector<Index> order(body.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = static_cast<Index>(order.size() - 1 - i);
    return order;
}

}  // namespace sphinx::test
