// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sum_all.h"
#include "dynamics/words.h"

#include <array>

namespace sphinx::dynamics::fluid {

/// Mean of a vector over the particles of bodies, zero where there are none.
template <int Dim>
class Mean {
 public:
    void add(const Field<Vec<Dim>>& field, std::size_t n) {
        using Terms = std::array<double, Dim + 1>;
        const Terms sum = sumAll(n, [&](std::size_t i) {
            Terms terms;
            for (int c = 0; c < Dim; ++c) terms[c] = field[i][c];
            terms[Dim] = 1;
            return terms;
        });
        for (int c = 0; c < Dim; ++c) sum_[c] += sum[c];
        count_ += sum[Dim];
    }
    Vec<Dim> value() const { return count_ > 0 ? Vec<Dim>(sum_ / count_) : sum_; }

 private:
    Vec<Dim> sum_ = Vec<Dim>::Zero();
    double count_ = 0;
};

}  // namespace sphinx::dynamics::fluid
