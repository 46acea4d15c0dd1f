// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/model/smoothing.h"

namespace sphinx::model {

using kernels::KernelType;

KernelType defaultKernel(bodies::Role role, bool has_ratio) {
    return has_ratio || role == bodies::Role::elastic ? KernelType::wendland_c2
                                                      : KernelType::quintic_spline;
}

double defaultSmoothingRatio(bodies::Role role, KernelType kernel) {
    if (role == bodies::Role::elastic) return 0.85;
    switch (kernel) {
        case KernelType::quintic_spline: return 1;
        case KernelType::cubic_spline: return 1.35;
        case KernelType::wendland_c2: break;
    }
    return 1.5;
}

}  // namespace sphinx::model
