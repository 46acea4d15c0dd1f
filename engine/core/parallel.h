// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <type_traits>
#include <utility>
#include <vector>

namespace sphinx {

/// Sets the number of threads that loops use from now on; 0 means all of the machine. Throws
/// std::system_error where the system gives no more threads.
void setThreadCount(int threads);
/// 1 on a thread that works alone.
int threadCount();
/// From now on loops of this thread have no other ones: those are at work for somebody else.
void workAlone();

namespace detail {
using RangeFunction = void (*)(void* context, std::size_t begin, std::size_t end);
/// Calls `function` for consecutive ranges of at most `grain` indices, on all threads.
void runRanges(std::size_t n, std::size_t grain, RangeFunction function, void* context);
/// The one copy of a loop's body: compiled twice, for one thread and for several, fused products
/// could round differently in each.
template <class Plain>
[[gnu::noipa]] void callRange(void* context, std::size_t begin, std::size_t end) {
    (*static_cast<Plain*>(context))(begin, end);
}
}  // namespace detail

/// Particles of one range: large enough that a range costs microseconds, small enough to share out.
inline constexpr std::size_t default_grain = 512;

/// body(begin, end) over [0, n) in ranges. Below one grain it is a plain call: no thread, no lock.
/// Which thread runs which range is open, so a body may write only what belongs to its indices.
template <class Body>
void parallelRanges(std::size_t n, Body&& body, std::size_t grain = default_grain) {
    using Plain = std::remove_reference_t<Body>;
    void* context = const_cast<void*>(static_cast<const void*>(&body));
    if (n <= grain || threadCount() == 1) {
        if (n > 0) detail::callRange<Plain>(context, 0, n);
        return;
    }
    detail::runRanges(n, grain, detail::callRange<Plain>, context);
}

/// body(i) for every i in [0, n).
template <class Body>
void parallelFor(std::size_t n, Body&& body, std::size_t grain = default_grain) {
    parallelRanges(
        n,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) body(i);
        },
        grain);
}

/// Reduction over particles of this process with bits that do not depend on the number of threads:
/// fixed blocks of `block` indices are reduced by `range(begin, end) -> T` and joined in order by
/// `join(a, b)`. `identity`: of nothing.
template <class T, class RangeReduction, class Join>
T reduceLocal(std::size_t n, T identity, RangeReduction&& range, Join&& join,
              std::size_t block = 1024) {
    const std::size_t blocks = (n + block - 1) / block;
    if (blocks <= 1) return n == 0 ? identity : range(std::size_t{0}, n);
    std::vector<T> partial(blocks, identity);
    parallelFor(
        blocks,
        [&](std::size_t b) {
            const std::size_t begin = b * block;
            partial[b] = range(begin, begin + block < n ? begin + block : n);
        },
        1);
    T result = identity;
    for (const T& value : partial) result = join(result, value);
    return result;
}

/// The same over the particles of the whole run, for what the motion or a result depends on. This
/// is where several processes would join theirs; today a run is one process.
template <class T, class RangeReduction, class Join>
T reduceAll(std::size_t n, T identity, RangeReduction&& range, Join&& join,
            std::size_t block = 1024) {
    return reduceLocal(n, identity, range, join, block);
}

/// How many of the indices have the property, in this process.
template <class Property>
std::size_t countLocal(std::size_t n, Property&& has) {
    return reduceLocal(
        n, std::size_t{0},
        [&](std::size_t begin, std::size_t end) {
            std::size_t count = 0;
            for (std::size_t i = begin; i < end; ++i) count += has(i) ? 1 : 0;
            return count;
        },
        [](std::size_t a, std::size_t b) { return a + b; });
}

/// Largest value(i) of the run, or `floor` when there is none.
template <class Value>
double maxAll(std::size_t n, double floor, Value&& value) {
    return reduceAll(
        n, floor,
        [&](std::size_t begin, std::size_t end) {
            double largest = floor;
            for (std::size_t i = begin; i < end; ++i) {
                const double v = value(i);
                largest = v > largest ? v : largest;
            }
            return largest;
        },
        [](double a, double b) { return b > a ? b : a; });
}

}  // namespace sphinx
