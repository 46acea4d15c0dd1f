// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace sphinx::input {

/// How an action uses a field. `accumulate` adds to a value that the layer zeroes first; `release`:
/// what it has written holds on when the window of its line is over: it is zero from then on, or
/// that of a body that stands still. The last three are about a span of the loop in place of a
/// field
/// ("step", "mean"), which one line opens and another closes in turn; others belong within.
enum class AccessMode { read, write, accumulate, release, open, close, within };

/// It changes the field.
inline bool changes(AccessMode mode) {
    return mode == AccessMode::write || mode == AccessMode::accumulate;
}

/// A field of the bodies that `owner` stands for: a parameter that refers to bodies or parts
/// ("body", "from", "bodies"), of a trait ("part.rigid") or all, or "neighbors", the bodies that
/// the first such parameter sees in `topology`, or only those of a trait: "neighbors.fluid",
/// "neighbors.solid"; or "bonded", those that are bonded to it.
struct Access {
    AccessMode mode;
    std::string owner;
    std::string field;  ///< of particles/fields.h, a pseudo field of dynamics/dynamics.h, or a span
    bool if_made = false;  ///< only where another method of the loop writes the field
    bool result = false;   ///< worth adding to even if the loop does not read it
};

}  // namespace sphinx::input
