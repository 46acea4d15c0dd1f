// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/register.h"

#include "measure/multibody.h"
#include "measure/observe.h"
#include "measure/reduce.h"

namespace sphinx::measure {

void registerMeasures(input::Registry& registry) {
    declareMultibody(registry);
    declareObserve(registry);
    declareReduce(registry);
}

}  // namespace sphinx::measure
