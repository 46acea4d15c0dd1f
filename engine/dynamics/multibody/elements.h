// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/multibody/simbody.h"
#include "dynamics/multibody/time_span.h"

#include <memory>
#include <vector>

// What acts in a mechanism, as Simbody wants to be told.
namespace sphinx::dynamics::multibody {

/// An entry of `forces`.
class Element : public SimTK::Force::Custom::Implementation {
 public:
    /// As forceColumns() names them.
    virtual std::vector<double> values(const SimTK::State& state) const = 0;
};

/// Whoever gets one of these owns it.
Element* makeElement(const PointSpring& spring, const Station& from, const Station& to);
Element* makeElement(const GivenForce& given, const Station& at);
Element* makeElement(const CatenaryLine& line, const Vector& up, const Station& from,
                     const Station& to);

/// Force or moment on a coordinate as a function of time.
SimTK::Force::Custom::Implementation* makeMotor(const SimTK::MobilizedBody& body, int coordinate,
                                                FunctionOfTime value);

/// What particles do to the bodies in a step; both live longer.
SimTK::Force::Custom::Implementation* makeParticleLoads(
    const std::vector<SimTK::MobilizedBody>& bodies, const std::vector<BodyLoad>& loads);
Screw forceOf(const BodyLoad& load, const Screw& velocity);

/// All coordinates of a joint as functions of time, or one of several; the span lives longer.
SimTK::Motion::Custom::Implementation* makeMotion(std::vector<FunctionOfTime> values,
                                                  const TimeSpan& span);
SimTK::Function* makeMotion(FunctionOfTime value, const TimeSpan& span);

}  // namespace sphinx::dynamics::multibody
