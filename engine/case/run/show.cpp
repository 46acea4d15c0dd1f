// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/run/show.h"

#include "input/tree/yaml.h"

namespace sphinx::run {

std::string showCase(const model::Case& model) { return input::writeYaml(model.resolved, true); }

}  // namespace sphinx::run
