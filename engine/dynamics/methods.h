// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"

/// All methods: AREA.NAME of a case is declared in dynamics/AREA/NAME.cpp.
namespace sphinx::dynamics {

namespace constraint {
void declareClamp(input::Registry& registry);
void declareFix(input::Registry& registry);
void declarePrescribedMotion(input::Registry& registry);
}  // namespace constraint

namespace contact {
void declareForce(input::Registry& registry);
void declareTimeStep(input::Registry& registry);
}  // namespace contact

namespace fluid {
void declareAcousticTimeStep(input::Registry& registry);
void declareAdvectionTimeStep(input::Registry& registry);
void declareAveragePressure(input::Registry& registry);
void declareDensitySummation(input::Registry& registry);
void declareImplicitViscosity(input::Registry& registry);
void declarePolymerStress(input::Registry& registry);
void declarePressureRelaxation(input::Registry& registry);
void declareTransportVelocity(input::Registry& registry);
void declareViscousForce(input::Registry& registry);
}  // namespace fluid

namespace force {
void declareBodyForce(input::Registry& registry);
void declareGravity(input::Registry& registry);
void declareMeanVelocity(input::Registry& registry);
void declarePointForce(input::Registry& registry);
void declareSpring(input::Registry& registry);
void declareSurfacePressure(input::Registry& registry);
void declareVelocityDamping(input::Registry& registry);
}  // namespace force

namespace fsi {
void declareAverageKinematics(input::Registry& registry);
void declarePressureForce(input::Registry& registry);
void declareViscousForce(input::Registry& registry);
}  // namespace fsi

namespace geometry {
void declareNormalsFromShape(input::Registry& registry);
}  // namespace geometry

namespace multibody {
void declareStep(input::Registry& registry);
}  // namespace multibody

namespace neighbors {
void declareUpdate(input::Registry& registry);
}  // namespace neighbors

namespace particles {
void declareSort(input::Registry& registry);
}  // namespace particles

namespace solid {
void declareAcousticTimeStep(input::Registry& registry);
void declareLinearCorrection(input::Registry& registry);
void declareStressRelaxation(input::Registry& registry);
void declareStressUpdate(input::Registry& registry);
void declareUpdateNormals(input::Registry& registry);
}  // namespace solid

}  // namespace sphinx::dynamics
