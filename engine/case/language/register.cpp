// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/register.h"

#include "case/language/read.h"
#include "dynamics/register.h"
#include "io/register.h"
#include "materials/register.h"
#include "measure/register.h"
#include "particles/register.h"

namespace sphinx::language {

void registerAll(input::Registry& registry) {
    registerCaseLanguage(registry);
    materials::registerMaterials(registry);
    dynamics::registerDynamics(registry);
    io::registerOutputs(registry);
    measure::registerMeasures(registry);
    particles::registerFields(registry);
}

}  // namespace sphinx::language
