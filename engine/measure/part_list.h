// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"
#include "neighbors/neighbor_list.h"

namespace sphinx::measure {

/// The neighbors of a list that belong to a part of the body `to`: blocks without any are left out,
/// and the gradients of others are zero, as those beyond the last neighbor are. What is summed over
/// it is the share of the part, term by term.
template <int Dim>
neighbors::NeighborList<Dim> listOfPart(const neighbors::NeighborList<Dim>& list,
                                        const bodies::BodyPart<Dim>& part, std::size_t held);

}  // namespace sphinx::measure
