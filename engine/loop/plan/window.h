// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace sphinx::loop {

/// `from:` and `until:` of a call: the substeps of its layer in which it acts, by the time at which
/// they begin. Two calls of which one acts until T and the other from T share all substeps. At the
/// begin of the first substep after it the method rests (Method::rest).
struct Window {
    std::optional<double> from;   ///< case units; without: since the start
    std::optional<double> until;  ///< case units, not included; without: to the end

    bool limited() const { return from || until; }
    bool holds(double time) const { return (!from || time >= *from) && (!until || time < *until); }
};

/// "from 0.4 until 0.5", each with the unit behind it; empty when it is not limited.
std::string describe(const Window& window, const std::string& unit);

}  // namespace sphinx::loop
