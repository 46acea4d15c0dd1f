// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"
#include "input/declaration/registry.h"

#include <string>
#include <vector>

namespace sphinx::language {

/// Declares the blocks of the language, the shapes and the kernels.
void registerCaseLanguage(input::Registry& registry);

/// Reads and checks a case file without making particles. `overrides` are the values of --set,
/// "path=YAML". Throws CaseError with all messages when the case is wrong, FileError when the file
/// cannot be read.
model::Case readCase(const std::string& path, const std::vector<std::string>& overrides,
                     const input::Registry& registry);

/// The same for a text in memory, shown as `name` in messages.
model::Case readCaseText(const std::string& name, const std::string& text,
                         const input::Registry& registry);

}  // namespace sphinx::language
