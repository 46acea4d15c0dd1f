// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/register.h"

#include "case/read.h"
#include "dynamics/register.h"
#include "io/register.h"
#include "materials/register.h"
#include "particles/register.h"

namespace sphinx {

void registerAll(input::Registry& registry) {
    model::registerCaseLanguage(registry);
    registerMaterials(registry);
    registerDynamics(registry);
    io::registerOutputs(registry);
    registerFields(registry);
}

}  // namespace sphinx
