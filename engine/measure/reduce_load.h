// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/output/factory.h"
#include "io/series/series.h"

#include <optional>

namespace sphinx::measure {

/// Methods of the loop that know what they exert on a solid (dynamics/known_load.h).
enum class KnownLoads {
    supports,  ///< constraints, by their reactions
    applied,   ///< forces from outside
};

/// Sum of the loads of that kind on the body, over their last step, and with a point their moment
/// about it. Throws CaseError at the place when no method of the loop is one.
template <int Dim>
std::unique_ptr<io::SeriesSource> makeLoadSource(KnownLoads kind, const bodies::Body<Dim>& body,
                                                 const input::Place& place,
                                                 const io::OutputContext<Dim>& context,
                                                 const std::optional<Vec<Dim>>& about);

}  // namespace sphinx::measure
