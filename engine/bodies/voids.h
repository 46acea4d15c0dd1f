// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"
#include "particles/fields.h"

namespace sphinx::bodies {

/// Where a fluid bears no tension (fields::slack), a density below that of zero pressure is no
/// state of it: it tells a void, the width of a gap.
template <int Dim>
class Voids {
 public:
    /// Other bodies than such fluids have none.
    explicit Voids(const Body<Dim>& body)
        : slack_(dynamic_cast<const particles::Field<double>*>(
              body.particles.find(fields::slack.name))),
          rho0_(slack_ ? body.material()->density() : 0) {}

    bool at(std::size_t i, double density) const {
        return slack_ && (*slack_)[i] > 0 && density < rho0_;
    }

 private:
    const particles::Field<double>* slack_;
    double rho0_;
};

}  // namespace sphinx::bodies
