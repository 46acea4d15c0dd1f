// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// mechanism.cpp and its like are C++17: this header has nothing newer.

namespace sphinx::dynamics::multibody {

/// A line that hangs in its own weight, without bending stiffness and without inertia.
struct CatenaryLine {
    double length = 0;       ///< without tension
    double stiffness = 0;    ///< force per strain, E A
    double weight = 0;       ///< per length, in what surrounds it; above 0
    bool on_ground = false;  ///< it may lie on level ground at the height of its lower end
};

/// How it hangs from its lower end, the anchor, to its upper one.
struct CatenaryShape {
    double across = 0;   ///< level force, the same all along it
    double upper = 0;    ///< upward force that holds its upper end
    double lower = 0;    ///< downward force that holds its lower end; 0 where it leaves the ground
    double resting = 0;  ///< length that lies on the ground
    double energy = 0;   ///< of its weight above the anchor, and of its strain
};

/// The elastic catenary whose upper end is `across` (at least 0) beside the other and `up` above it
/// (Jonkman 2007, without friction on the ground). It may also be below, where nothing
/// lies on the ground. Throws MechanismError.
CatenaryShape hang(const CatenaryLine& line, double across, double up);

}  // namespace sphinx::dynamics::multibody
