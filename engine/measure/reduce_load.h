// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/output/factory.h"
#include "io/series/series.h"

#include <optional>

namespace sphinx::measure {

/// Force of the constraints that hold particles of the body, over their last step, and with a point
/// their moment about it. Throws CaseError at the place when no method of the loop holds any.
template <int Dim>
std::unique_ptr<io::SeriesSource> makeReactionSource(const bodies::Body<Dim>& body,
                                                     const input::Place& place,
                                                     const io::OutputContext<Dim>& context,
                                                     const std::optional<Vec<Dim>>& about);
/// The same of the forces that act on it from outside.
template <int Dim>
std::unique_ptr<io::SeriesSource> makeAppliedSource(const bodies::Body<Dim>& body,
                                                    const input::Place& place,
                                                    const io::OutputContext<Dim>& context,
                                                    const std::optional<Vec<Dim>>& about);

}  // namespace sphinx::measure
