// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lanes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace sphinx {

/// Sum of any doubles, correctly rounded: the order in which they are added, and how they are
/// shared among totals that are added in the end, make no difference to any bit. Needs no bound of
/// the terms, unlike ExactSum, which is faster. Not finite as soon as a term is not.
///
/// The small superaccumulator of Neal 2015 (arXiv:1505.05571): a fixed-point number wide enough for
/// every double, in chunks of 32 bits, each kept in 64, so that carries are passed on only once in
/// 2047 additions. Terms that come many at a time are first summed on two grids without any error
/// (as in Demmel & Nguyen 2013, doi:10.1109/ARITH.2013.9), eight at a time.
class ExactTotal {
 public:
    void add(double term) {
        const auto bits = std::bit_cast<std::uint64_t>(term);
        const auto exponent = static_cast<int>(bits >> 52) & 0x7ff;
        std::uint64_t mantissa = bits & ((std::uint64_t{1} << 52) - 1);
        if (exponent == 0x7ff) [[unlikely]] {
            not_finite_ += term;
            return;
        }
        mantissa |= std::uint64_t{exponent != 0} << 52;
        const int place = exponent + (exponent == 0);
        const int shift = place % chunk_bits;
        const auto low = static_cast<std::int64_t>((mantissa << shift) & chunk_mask);
        const auto high = static_cast<std::int64_t>(mantissa >> (chunk_bits - shift));
        const std::int64_t sign = static_cast<std::int64_t>(bits) >> 63;  // 0 or -1
        const int chunk = place / chunk_bits;
        first_ = std::min(first_, chunk);
        last_ = std::max(last_, chunk + 1);
        at(chunk) += (low ^ sign) - sign;
        at(chunk + 1) += (high ^ sign) - sign;
        if (++pending_ == most_pending) carry();
    }

    /// At most so many terms at a time.
    static constexpr std::size_t batch = 512;
    /// Adds n terms, whose array is filled up with zeros to a multiple of lane_count; it is
    /// changed.
    void addBatch(double* terms, std::size_t n) {
        // Each time what is left is below 2^-84 of what there was: once is the rule.
        while (const double bound = boundOf(terms, n)) {
            if (!(bound > 0x1p-900 && bound < 0x1p900)) return addEach(terms, n);
            if (!addOnGrids(terms, n, bound)) return;
        }
    }

    ExactTotal& operator+=(ExactTotal other) {
        carry();
        other.carry();
        first_ = std::min(first_, other.first_);
        last_ = std::max(last_, other.last_);
        for (int k = other.first_; k <= other.last_; ++k) at(k) += other.at(k);
        not_finite_ += other.not_finite_;
        pending_ = 1;  // a chunk holds less than twice what one addition may leave
        return *this;
    }
    double value() const {
        if (not_finite_ != 0) return not_finite_;
        ExactTotal sum = *this;
        sum.carry();
        if (sum.first_ > sum.last_) return 0;
        const bool negative = sum.at(sum.last_) < 0;
        if (negative) {
            for (int k = sum.first_; k <= sum.last_; ++k) sum.at(k) = -sum.at(k);
            sum.carry();
        }
        const double size = sum.magnitude();
        return negative ? -size : size;
    }

 private:
    static constexpr int chunk_bits = 32;
    static constexpr std::uint64_t chunk_mask = 0xffffffff;
    static constexpr int chunks = 67;
    /// A term adds less than 2^52 to a chunk.
    static constexpr int most_pending = 2047;
    /// The last bit of chunk 0 is 2^-1075; the topmost has the carries of 2^32 terms.
    static constexpr int lowest_exponent = -1075;

    std::int64_t& at(int chunk) { return chunks_[static_cast<std::size_t>(chunk)]; }
    std::int64_t at(int chunk) const { return chunks_[static_cast<std::size_t>(chunk)]; }

    /// The largest size of the terms; NaN if one is not finite.
    static double boundOf(const double* terms, std::size_t n) {
        Lanes largest{}, faults{};
        for (std::size_t k = 0; k < n; k += lane_count) {
            const Lanes x = loadLanes(terms + k);
            largest = maxLanes(largest, maxLanes(x, -x));
            faults += x - x;  // 0, unless x is not finite
        }
        double bound = 0;
        for (int k = 0; k < lane_count; ++k) bound = std::max(bound, largest[k]);
        return bound + sumLanes(faults);
    }
    /// Adds what of the terms is on two grids, and leaves the rest in their places. Whether there
    /// is any.
    bool addOnGrids(double* terms, std::size_t n, double bound) {
        // So coarse a grid that a sum of `batch` multiples fits in a double, see SumGrid.
        constexpr std::uint64_t exponent_mask = std::uint64_t{0x7ff} << 52;
        const auto power = std::bit_cast<std::uint64_t>(bound) & exponent_mask;
        const double coarse = 0x1.8p11 * std::bit_cast<double>(power);
        const double fine = 0x1p-43 * coarse;
        Lanes sum{}, fine_sum{};
        LaneMask left{};
        for (std::size_t k = 0; k < n; k += lane_count) {
            const Lanes x = loadLanes(terms + k);
            const Lanes high = (x + coarse) - coarse;
            const Lanes low = ((x - high) + fine) - fine;
            const Lanes rest = (x - high) - low;
            sum += high;
            fine_sum += low;
            left |= rest != 0;
            storeLanes(rest, terms + k);
        }
        add(sumLanes(sum));
        add(sumLanes(fine_sum));
        bool any = false;
        for (int k = 0; k < lane_count; ++k) any |= left[k] != 0;
        return any;
    }
    void addEach(const double* terms, std::size_t n) {
        for (std::size_t k = 0; k < n; ++k) add(terms[k]);
    }
    /// All chunks but the last in use, which has the sign, become 0 to 2^32 - 1; that one stays
    /// below 2^32 in size.
    void carry() {
        for (int k = first_; k <= last_; ++k) {
            const bool last = k == last_;
            if (last && at(k) >> chunk_bits == (at(k) < 0 ? -1 : 0)) break;
            at(k + 1) += at(k) >> chunk_bits;
            at(k) &= static_cast<std::int64_t>(chunk_mask);
            if (last) ++last_;
        }
        pending_ = 0;
    }
    /// Of a sum without pending carries that is not negative.
    double magnitude() const {
        int top = last_;
        while (top > first_ && at(top) == 0) --top;
        const auto chunk = [&](int below) {
            return below > top ? 0 : static_cast<std::uint64_t>(at(top - below));
        };
        std::uint64_t leading = chunk(0) << chunk_bits | chunk(1);
        if (leading == 0) return 0;
        // 64 bits from the first that is set. That any below them is set goes to the last one, so
        // that the conversion, which keeps 53, rounds as if it saw them.
        const int zeros = std::countl_zero(leading);
        const std::uint64_t next = chunk(2) << zeros;
        leading = leading << zeros | next >> chunk_bits;
        bool rest = (next & chunk_mask) != 0;
        for (int k = first_; k < top - 2; ++k) rest |= at(k) != 0;
        leading |= std::uint64_t{rest};
        const int exponent = lowest_exponent + chunk_bits * (top - 1) - zeros;
        return std::ldexp(static_cast<double>(leading), exponent);
    }

    std::array<std::int64_t, chunks> chunks_{};
    int first_ = chunks;  // chunks in use: first_ to last_
    int last_ = -1;
    int pending_ = 0;
    double not_finite_ = 0;
};

}  // namespace sphinx
