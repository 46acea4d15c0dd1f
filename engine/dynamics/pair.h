// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/number.h"

namespace sphinx::dynamics {

/// The geometry of a pair i, j as pair terms see it: of one pair (Number = double) or of eight.
/// e_ij points from j to i.
template <int Dim, class Number>
struct Pair {
    Number gradient[Dim];  ///< e_ij W', 1/length^(Dim+1), or in the gradient unit of a list
    Number dW;             ///< abs(W') = -W'
    Number inverse_dW;     ///< 1 / abs(W'), large but finite where W' is 0

    /// The same pair seen from j.
    Pair reversed() const {
        Pair other = *this;
        for (int c = 0; c < Dim; ++c) other.gradient[c] = -gradient[c];
        return other;
    }
};

}  // namespace sphinx::dynamics
