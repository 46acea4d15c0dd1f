// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/expressions/tabulated_function.h"

#include <fmt/format.h>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace sphinx::input {
namespace {

/// Second derivatives M of the natural cubic spline: M_0 = M_n = 0, and between
///   h_(k-1) M_(k-1) + 2 (h_(k-1) + h_k) M_k + h_k M_(k+1) = 6 (s_k - s_(k-1))
/// with the widths h and slopes s of the pieces, by elimination.
std::vector<double> naturalSpline(const std::vector<double>& x, const std::vector<double>& y) {
    const std::size_t n = x.size();
    std::vector<double> curvature(n, 0), factor(n, 0);
    for (std::size_t k = 1; k + 1 < n; ++k) {
        const double before = x[k] - x[k - 1], after = x[k + 1] - x[k];
        const double bend = (y[k + 1] - y[k]) / after - (y[k] - y[k - 1]) / before;
        const double pivot = 2 * (before + after) - before * factor[k - 1];
        factor[k] = after / pivot;
        curvature[k] = (6 * bend - before * curvature[k - 1]) / pivot;
    }
    for (std::size_t k = n - 1; k-- > 1;) curvature[k] -= factor[k] * curvature[k + 1];
    return curvature;
}

}  // namespace

TabulatedFunction::TabulatedFunction(std::string name, Column argument, Column value,
                                     Interpolation interpolation, Outside outside,
                                     const UnitSystem& units)
    : name_(std::move(name)),
      argument_(std::move(argument)),
      value_(std::move(value)),
      outside_(outside),
      units_(units) {
    assert(argument_.numbers.size() >= 2 && argument_.numbers.size() == value_.numbers.size());
    assert(std::ranges::is_sorted(argument_.numbers, std::ranges::less_equal{}));
    if (interpolation == Interpolation::cubic)
        curvature_ = naturalSpline(argument_.numbers, value_.numbers);
}

double TabulatedFunction::operator()(double argument) const {
    if (outside_ == Outside::error && (argument < first() || argument > last()))
        throw OutsideTable{this, argument};
    return continued(argument);
}

double TabulatedFunction::continued(double argument) const {
    if (outside_ == Outside::hold) argument = std::clamp(argument, first(), last());
    const std::vector<double>& x = argument_.numbers;
    const std::vector<double>& y = value_.numbers;
    // The piece that begins at the last row not beyond it; the last piece also for its end.
    const auto next = std::upper_bound(x.begin() + 1, x.end() - 1, argument);
    const auto k = static_cast<std::size_t>(next - x.begin()) - 1;
    const double h = x[k + 1] - x[k];
    const double a = (x[k + 1] - argument) / h;
    const double b = (argument - x[k]) / h;
    const double straight = a * y[k] + b * y[k + 1];
    if (curvature_.empty()) return straight;
    return straight +
           ((a * a * a - a) * curvature_[k] + (b * b * b - b) * curvature_[k + 1]) * (h * h / 6);
}

std::string TabulatedFunction::argumentText(double argument) const {
    return fmt::format("{:g}{}", argument,
                       argument_.dimension ? units_.suffix(*argument_.dimension) : "");
}

std::string TabulatedFunction::rangeText() const {
    return fmt::format("the table '{}' has values from {} to {}", name_, argumentText(first()),
                       argumentText(last()));
}

}  // namespace sphinx::input
