// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/tree/diagnostics.h"
#include "input/tree/node.h"
#include "input/tree/yaml.h"

#include <optional>

namespace sphinx::input {

/// Refuses what is no text for a person: bytes that are not UTF-8, control characters, tabs as
/// indentation, enormous files and lines. One report at most.
bool checkText(const std::shared_ptr<const Source>& source, std::string_view text, Offset offset,
               Diagnostics& diagnostics);

/// What a syntax error of yaml-cpp at that byte means to the author of a case, and the byte that it
/// is about. `open` is the bracket of the innermost [...] or {...} that is not closed yet.
struct Explanation {
    std::size_t position;
    std::string message;
};
Explanation explainSyntaxError(std::string_view text, std::size_t position,
                               const std::string& message, std::optional<std::size_t> open);

/// Reports in a finished [...] or {...}: expressions cut by a comma, "time:0.1" without a blank.
void findSplitExpressions(const Node& node, Diagnostics& diagnostics);

/// yaml-cpp accepts a quote that the end of the file closes. `position` is the opening quote.
bool quoteIsClosed(std::string_view text, std::size_t position);

}  // namespace sphinx::input
