// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/register.h"

#include "dynamics/methods.h"
#include "dynamics/multibody/components.h"

namespace sphinx::dynamics {

void registerDynamics(input::Registry& registry) {
    constraint::declareClamp(registry);
    constraint::declareFix(registry);
    constraint::declarePrescribedMotion(registry);
    contact::declareForce(registry);
    contact::declareTimeStep(registry);
    fluid::declareAcousticTimeStep(registry);
    fluid::declareAdvectionTimeStep(registry);
    fluid::declareAveragePressure(registry);
    fluid::declareDensitySummation(registry);
    fluid::declareImplicitViscosity(registry);
    fluid::declarePolymerStress(registry);
    fluid::declarePressureRelaxation(registry);
    fluid::declareTransportVelocity(registry);
    fluid::declareViscousForce(registry);
    force::declareBodyForce(registry);
    force::declareGravity(registry);
    force::declareMeanVelocity(registry);
    force::declarePointForce(registry);
    force::declareSpring(registry);
    force::declareSurfacePressure(registry);
    force::declareVelocityDamping(registry);
    fsi::declareAverageKinematics(registry);
    fsi::declarePressureForce(registry);
    fsi::declareViscousForce(registry);
    geometry::declareNormalsFromShape(registry);
    multibody::declareJoints(registry);
    multibody::declareForces(registry);
    multibody::declareConstraints(registry);
    multibody::declareStep(registry);
    neighbors::declareUpdate(registry);
    particles::declareSort(registry);
    solid::declareAcousticTimeStep(registry);
    solid::declareLinearCorrection(registry);
    solid::declareStressRelaxation(registry);
    solid::declareStressUpdate(registry);
    solid::declareUpdateNormals(registry);
}

}  // namespace sphinx::dynamics
