// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/fields.h"

namespace sphinx::particles::fields {

const std::vector<const FieldInfo*>& all() {
    static const std::vector<const FieldInfo*> list = {
        &id,
        &position,
        &velocity,
        &mass,
        &volume,
        &density,
        &density_rate,
        &reference_density,
        &slack,
        &pressure,
        &average_pressure,
        &viscosity,
        &shear_rate,
        &conformation,
        &acceleration,
        &external_acceleration,
        &normal,
        &depth,
        &fibre,
        &sheet,
        &initial_position,
        &initial_normal,
        &correction_matrix,
        &deformation_gradient,
        &deformation_rate,
        &corrected_stress,
        &pressure_force,
        &viscous_force,
        &average_velocity,
        &radiation_impedance,
        &slip,
        &contact_force,
        &contact_pressure,
        &contact_couple,
        &displacement,
        &green_lagrange_strain,
        &piola_kirchhoff_stress,
        &cauchy_stress,
        &von_mises_stress,
        &strain_energy_density,
    };
    return list;
}

const FieldInfo* find(std::string_view name) {
    for (const FieldInfo* info : all())
        if (info->name == name) return info;
    return nullptr;
}

}  // namespace sphinx::particles::fields
