// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace sphinx::dynamics::multibody {

/// The LAPACK and BLAS of this system, by which Simbody solves for constraints: the files, and of
/// OpenBLAS its version and the processor that it has found. The same bits are promised for one
/// name.
std::string linearAlgebra();

/// Has them use one thread, where they know more: how they split sums would change bits.
void keepLinearAlgebraToOneThread();

}  // namespace sphinx::dynamics::multibody
