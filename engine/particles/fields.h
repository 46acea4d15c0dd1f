// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "particles/field.h"

#include <vector>

namespace sphinx::particles {

/// Every field of the program: name, rank, unit, meaning and what a new particle has in it, in one
/// place.
namespace fields {

inline constexpr FieldInfo id{"id", Rank::integer, unit::none, "stable number of the particle",
                              initial_value::given};
inline constexpr FieldInfo position{"position", Rank::vector, unit::length, "current position",
                                    initial_value::given};
inline constexpr FieldInfo velocity{"velocity", Rank::vector, unit::velocity, "velocity",
                                    initial_value::given};
inline constexpr FieldInfo mass{"mass", Rank::scalar, unit::mass,
                                "mass (2D: of a slice of unit depth)", initial_value::given};
inline constexpr FieldInfo volume{"volume", Rank::scalar, unit::volume,
                                  "volume (2D: of a slice of unit depth)", initial_value::given};
inline constexpr FieldInfo density{"density", Rank::scalar, unit::density, "density",
                                   initial_value::given};
inline constexpr FieldInfo density_rate{"density_rate", Rank::scalar, unit::density_rate,
                                        "rate of change of the density by the continuity equation",
                                        initial_value::zero};
inline constexpr FieldInfo reference_density{"reference_density", Rank::scalar, unit::density,
                                             "density at the start, for confined flows",
                                             initial_value::sameAs(density)};
inline constexpr FieldInfo slack{"slack", Rank::scalar, unit::none,
                                 "1 where a fluid with a free surface bears no tension: at its "
                                 "surface and at walls; else 0",
                                 initial_value::zero};
inline constexpr FieldInfo pressure{"pressure", Rank::scalar, unit::pressure, "pressure",
                                    initial_value::given};
inline constexpr FieldInfo average_pressure{"average_pressure", Rank::scalar, unit::pressure,
                                            "pressure of a fluid, averaged over acoustic steps",
                                            initial_value::sameAs(pressure)};
inline constexpr FieldInfo viscosity{"viscosity", Rank::scalar, unit::dynamic_viscosity,
                                     "viscosity of a generalised Newtonian fluid at its shear rate",
                                     initial_value::zero};
inline constexpr FieldInfo shear_rate{"shear_rate", Rank::scalar, unit::frequency,
                                      "shear rate sqrt(2 D:D) of a generalised Newtonian fluid",
                                      initial_value::zero};
inline constexpr FieldInfo conformation{
    "conformation", Rank::matrix, unit::none,
    "conformation c of the polymers in a fluid, 1 at rest: their stress is eta_p (c - 1)/lambda",
    initial_value::identity};
inline constexpr FieldInfo acceleration{"acceleration", Rank::vector, unit::acceleration,
                                        "acceleration of a solid particle", initial_value::zero};
inline constexpr FieldInfo external_acceleration{
    "external_acceleration", Rank::vector, unit::acceleration,
    "acceleration by all other forces (gravity, viscosity), held over a substep",
    initial_value::zero};
inline constexpr FieldInfo normal{"normal", Rank::vector, unit::none,
                                  "outward unit normal of the body's surface"};
inline constexpr FieldInfo fibre{"fibre", Rank::vector, unit::none,
                                 "unit direction of the fibres in the reference configuration",
                                 initial_value::given};
inline constexpr FieldInfo sheet{"sheet", Rank::vector, unit::none,
                                 "unit direction of the sheets in the reference configuration",
                                 initial_value::given};
inline constexpr FieldInfo initial_position{"initial_position", Rank::vector, unit::length,
                                            "position in the reference configuration",
                                            initial_value::sameAs(position)};
inline constexpr FieldInfo initial_normal{"initial_normal", Rank::vector, unit::none,
                                          "outward unit normal in the reference configuration"};
inline constexpr FieldInfo correction_matrix{
    "correction_matrix", Rank::matrix, unit::none,
    "makes gradients in the reference configuration exact for linear functions"};
inline constexpr FieldInfo deformation_gradient{"deformation_gradient", Rank::matrix, unit::none,
                                                "deformation gradient F", initial_value::identity};
inline constexpr FieldInfo deformation_rate{"deformation_rate", Rank::matrix, unit::frequency,
                                            "rate of change of the deformation gradient"};
inline constexpr FieldInfo corrected_stress{
    "corrected_stress", Rank::matrix, unit::pressure,
    "first Piola-Kirchhoff stress times the transposed correction matrix, less the part of the "
    "hourglass control, times what a clamp leaves of the particle; at the half step"};
inline constexpr FieldInfo pressure_force{"pressure_force", Rank::vector, unit::force,
                                          "force of fluids on a solid particle by pressure",
                                          initial_value::zero};
inline constexpr FieldInfo viscous_force{"viscous_force", Rank::vector, unit::force,
                                         "force of fluids on a solid particle by viscosity",
                                         initial_value::zero};
inline constexpr FieldInfo contact_force{"contact_force", Rank::vector, unit::force,
                                         "force of other surfaces on a solid particle",
                                         initial_value::zero};
inline constexpr FieldInfo contact_pressure{
    "contact_pressure", Rank::scalar, unit::pressure,
    "of it the part along the normal, by the undeformed area that the particle stands for",
    initial_value::zero};
inline constexpr FieldInfo contact_couple{"contact_couple", Rank::matrix, unit::energy,
                                          "force of other surfaces times the arm from the "
                                          "particle, of which the skew part turns a rigid one",
                                          initial_value::zero};
inline constexpr FieldInfo average_velocity{
    "average_velocity", Rank::vector, unit::velocity,
    "velocity of a solid particle, averaged over the fluid's acoustic step",
    initial_value::sameAs(velocity)};
inline constexpr FieldInfo radiation_impedance{
    "radiation_impedance", Rank::matrix, unit::mass_rate,
    "force by which fluids answer a particle of an elastic body at once, per velocity: Z of "
    "fsi.pressure_force",
    initial_value::zero};
inline constexpr FieldInfo slip{
    "slip", Rank::vector, unit::length,
    "by how much further a particle of an elastic body moved in the last step of its fluids than "
    "they saw",
    initial_value::zero};
inline constexpr FieldInfo depth{"depth", Rank::scalar, unit::length,
                                 "distance of a solid particle from the body's surface"};

// Computed from the state of elastic bodies, for outputs only: solid/derived_fields.h.
inline constexpr FieldInfo displacement{
    "displacement",      Rank::vector,
    unit::length,        "displacement of an elastic body since the start",
    initial_value::none, FieldKind::derived};
inline constexpr FieldInfo green_lagrange_strain{"green_lagrange_strain",
                                                 Rank::matrix,
                                                 unit::none,
                                                 "Green-Lagrange strain of an elastic body",
                                                 initial_value::none,
                                                 FieldKind::derived};
inline constexpr FieldInfo piola_kirchhoff_stress{
    "piola_kirchhoff_stress", Rank::matrix,
    unit::pressure,           "first Piola-Kirchhoff stress of the elastic law",
    initial_value::none,      FieldKind::derived};
inline constexpr FieldInfo cauchy_stress{"cauchy_stress",     Rank::matrix,
                                         unit::pressure,      "Cauchy stress of the elastic law",
                                         initial_value::none, FieldKind::derived};
inline constexpr FieldInfo von_mises_stress{
    "von_mises_stress",  Rank::scalar,      unit::pressure, "von Mises stress of the elastic law",
    initial_value::none, FieldKind::derived};
inline constexpr FieldInfo strain_energy_density{
    "strain_energy_density", Rank::scalar,
    unit::pressure,          "strain energy per reference volume",
    initial_value::none,     FieldKind::derived};

/// The field of that name, or nullptr.
const FieldInfo* find(std::string_view name);
/// All of them, in the order of declaration.
const std::vector<const FieldInfo*>& all();

}  // namespace fields
}  // namespace sphinx::particles

// Fields are named everywhere.
namespace sphinx {
namespace fields = particles::fields;
}  // namespace sphinx
