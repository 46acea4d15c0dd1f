// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"

namespace sphinx::neighbors {

/// Both directions of a pair of different kernels use that of the larger reach.
template <int Dim>
const kernels::Kernel<Dim>& commonKernel(const bodies::Body<Dim>& a, const bodies::Body<Dim>& b) {
    return a.kernel.cutoff() >= b.kernel.cutoff() ? a.kernel : b.kernel;
}

}  // namespace sphinx::neighbors
