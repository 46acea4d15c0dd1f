// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/initial_values.h"

#include "case/build/access.h"
#include "case/build/fibres.h"
#include "case/build/parts.h"
#include "core/parallel.h"
#include "input/expressions/vector_at_time.h"
#include "materials/fluid_laws.h"

namespace sphinx::model {

template <int Dim>
void setInitialValues(const Body& source, const std::vector<double>& volumes, double time,
                      sphinx::Body<Dim>& body) {
    ParticleSet<Dim>& particles = body.particles;
    const auto& position = particles.position();
    auto& velocity = particles.vector(fields::velocity);
    auto& density = particles.scalar(fields::density);
    auto& mass = particles.scalar(fields::mass);
    auto& volume = particles.scalar(fields::volume);
    const std::size_t n = body.size();

    if (source.initial.velocity) {
        const input::VectorAtTime<Dim> initial(*source.initial.velocity, time);
        parallelFor(n, [&](std::size_t i) { velocity[i] = initial(position[i]); });
    }
    const double rho0 = body.material()->density();
    for (std::size_t i = 0; i < n; ++i) {
        density[i] = rho0;
        volume[i] = volumes[i];
    }
    if (body.isFluid()) {
        auto& pressure = particles.scalar(fields::pressure);
        auto& reference = particles.scalar(fields::reference_density);
        particles.scalar(fields::density_rate);
        if (source.initial.pressure)
            withLaw(*body.fluid().material, [&](const auto& law) {
                const auto& initial = *source.initial.pressure;
                parallelFor(n, [&](std::size_t i) {
                    pressure[i] = initial.template operator()<Dim>(position[i], time);
                    density[i] = law.densityAt(pressure[i]);
                });
            });
        for (std::size_t i = 0; i < n; ++i) reference[i] = density[i];
    }
    for (std::size_t i = 0; i < n; ++i) mass[i] = density[i] * volume[i];
    if (body.isElastic()) {
        auto& average_velocity = particles.vector(fields::average_velocity);
        for (std::size_t i = 0; i < n; ++i) average_velocity[i] = velocity[i];
    }
}

std::vector<std::string> initialFields(const Case& model, const Body& body) {
    if (body.role == Role::observer) return {};
    if (body.role == Role::fluid)
        return {"velocity", "density", "density_rate", "reference_density",
                "mass",     "volume",  "pressure"};
    std::vector<std::string> names{"velocity", "acceleration", "density", "mass", "volume"};
    if (hasFibres(model, body)) names.insert(names.end(), {"fibre", "sheet"});
    if (body.role == Role::elastic) {
        names.emplace_back("average_velocity");
        // Zero at first, where a method has them at all.
        for (const char* name :
             {"external_acceleration", "pressure_force", "viscous_force", "average_acceleration"})
            if (isAccessed(model, body, name)) names.emplace_back(name);
    }
    if (keepsInitialPosition(model, body)) names.emplace_back("initial_position");
    return names;
}

template void setInitialValues(const Body&, const std::vector<double>&, double, sphinx::Body<2>&);
template void setInitialValues(const Body&, const std::vector<double>&, double, sphinx::Body<3>&);

}  // namespace sphinx::model
