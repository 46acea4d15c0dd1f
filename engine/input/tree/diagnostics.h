// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/tree/place.h"

#include <string>
#include <vector>

namespace sphinx::input {

/// Collects what is wrong with a case, and says it like a compiler:
///     case.yaml:31:53: error: density is -1 but must be above 0
///       fresh_water: {type: weakly_compressible_fluid, density: -1}
///                                                               ^
class Diagnostics {
 public:
    void error(const Place& place, std::string message);
    void warning(const Place& place, std::string message);

    bool hasErrors() const { return errors_ > 0; }
    std::size_t errors() const { return errors_; }
    /// Everything so far, sorted by place, each ending with a newline.
    std::string text() const;
    /// Throws CaseError with text() when there is an error.
    void throwIfErrors() const;

 private:
    struct Entry {
        bool is_error;
        Place place;
        std::string message;
    };
    std::vector<Entry> entries_;
    std::size_t errors_ = 0;
};

}  // namespace sphinx::input
