// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/register.h"

#include "dynamics/constraint/clamp.h"
#include "dynamics/constraint/fix.h"
#include "dynamics/constraint/prescribed_motion.h"
#include "dynamics/fluid/acoustic_time_step.h"
#include "dynamics/fluid/advection_time_step.h"
#include "dynamics/fluid/average_pressure.h"
#include "dynamics/fluid/density_summation.h"
#include "dynamics/fluid/pressure_relaxation.h"
#include "dynamics/fluid/viscous_force.h"
#include "dynamics/force/body_force.h"
#include "dynamics/force/gravity.h"
#include "dynamics/force/point_force.h"
#include "dynamics/force/spring.h"
#include "dynamics/force/surface_pressure.h"
#include "dynamics/force/velocity_damping.h"
#include "dynamics/fsi/average_kinematics.h"
#include "dynamics/fsi/pressure_force.h"
#include "dynamics/fsi/viscous_force.h"
#include "dynamics/geometry/normals_from_shape.h"
#include "dynamics/neighbors/update.h"
#include "dynamics/particles/sort.h"
#include "dynamics/solid/acoustic_time_step.h"
#include "dynamics/solid/linear_correction.h"
#include "dynamics/solid/stress_relaxation.h"
#include "dynamics/solid/stress_update.h"
#include "dynamics/solid/update_normals.h"

namespace sphinx::dynamics {

void registerDynamics(input::Registry& registry) {
    constraint::declareClamp(registry);
    constraint::declareFix(registry);
    constraint::declarePrescribedMotion(registry);
    fluid::declareAcousticTimeStep(registry);
    fluid::declareAdvectionTimeStep(registry);
    fluid::declareAveragePressure(registry);
    fluid::declareDensitySummation(registry);
    fluid::declarePressureRelaxation(registry);
    fluid::declareViscousForce(registry);
    force::declareBodyForce(registry);
    force::declareGravity(registry);
    force::declarePointForce(registry);
    force::declareSpring(registry);
    force::declareSurfacePressure(registry);
    force::declareVelocityDamping(registry);
    fsi::declareAverageKinematics(registry);
    fsi::declarePressureForce(registry);
    fsi::declareViscousForce(registry);
    geometry::declareNormalsFromShape(registry);
    neighbors::declareUpdate(registry);
    particles::declareSort(registry);
    solid::declareAcousticTimeStep(registry);
    solid::declareLinearCorrection(registry);
    solid::declareStressRelaxation(registry);
    solid::declareStressUpdate(registry);
    solid::declareUpdateNormals(registry);
}

}  // namespace sphinx::dynamics
