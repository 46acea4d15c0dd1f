// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/model/smoothing.h"

namespace sphinx::model {

double defaultSmoothingRatio(bodies::Role role) {
    return role == bodies::Role::elastic ? 0.85 : 1.3;
}

}  // namespace sphinx::model
