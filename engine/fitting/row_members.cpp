// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/row_members.h"

#include "core/parallel.h"
#include "fitting/near_pairs.h"
#include "fitting/surface_row.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

namespace sphinx::fitting {
namespace {

// In spacings.
constexpr double deepest = 1.6;
constexpr double reach = 2;
constexpr double row_depth = 0.5;
/// What a spacing of depth counts against a point in the same place.
constexpr double weight_of_depth = 0.25;
/// Weights are whole numbers: the same for points that a symmetry exchanges.
constexpr double unit = 1e-6;
constexpr double tolerated = 0.01;

/// Those of the same weight and `aside` are exchanged by a symmetry.
struct Entry {
    std::int64_t weight;
    std::int64_t aside;
    Index candidate;
    bool operator<(const Entry& other) const {
        return std::tuple(weight, aside, candidate) <
               std::tuple(other.weight, other.aside, other.candidate);
    }
};

template <int Dim>
class Elimination {
 public:
    Elimination(const geometry::Shape<Dim>& shape, double spacing,
                const std::vector<Vec<Dim>>& points);

    void leaveOutUntil(double number);
    std::vector<std::uint8_t> members(std::size_t points) const;

 private:
    std::vector<Index> mostCrowded();
    void leaveOut(Index candidate);

    std::vector<Index> point_;  // of each candidate
    std::vector<std::int64_t> weight_;
    std::vector<std::int64_t> aside_;
    std::vector<std::uint8_t> is_member_;
    NearPairs near_;
    std::vector<std::int64_t> crowding_;  // of each of those pairs
    std::priority_queue<Entry> queue_;
    std::size_t left_;
};

template <int Dim>
Elimination<Dim>::Elimination(const geometry::Shape<Dim>& shape, double spacing,
                              const std::vector<Vec<Dim>>& points) {
    const SurfaceRow<Dim> row(shape, spacing);
    const Box<Dim> bounds = shape.bounds();
    const Vec<Dim> middle = 0.5 * (bounds.lower + bounds.upper);
    AlignedVector<double> depth(points.size());
    parallelFor(points.size(),
                [&](std::size_t i) { depth[i] = -shape.signedDistance(points[i]) / spacing; });
    for (std::size_t i = 0; i < points.size(); ++i)
        if (depth[i] < deepest) point_.push_back(static_cast<Index>(i));
    left_ = point_.size();
    AlignedVector<Vec<Dim>> place(left_);
    parallelFor(left_, [&](std::size_t c) {
        place[c] = row.place(points[point_[c]], row_depth * spacing);
    });
    near_ = nearPairs(place, reach * spacing);
    weight_.resize(left_);
    aside_.resize(left_);
    is_member_.assign(left_, 1);
    crowding_.resize(near_.neighbor.size());
    parallelFor(left_, [&](std::size_t c) {
        weight_[c] = std::llround(weight_of_depth * depth[point_[c]] / unit);
        aside_[c] =
            std::llround((points[point_[c]] - middle).template lpNorm<1>() / (unit * spacing));
        for (std::size_t k = near_.first[c]; k < near_.first[c + 1]; ++k) {
            const double way = (place[c] - place[near_.neighbor[k]]).norm() / (reach * spacing);
            crowding_[k] = std::llround((1 - way) * (1 - way) / unit);
            weight_[c] += crowding_[k];
        }
    });
    std::vector<Entry> entries;
    for (std::size_t c = 0; c < left_; ++c)
        entries.push_back({weight_[c], aside_[c], static_cast<Index>(c)});
    queue_ = std::priority_queue<Entry>({}, std::move(entries));
}

/// All that are alike, taken from the queue.
template <int Dim>
std::vector<Index> Elimination<Dim>::mostCrowded() {
    std::vector<Index> alike;
    Entry top{};
    while (!queue_.empty()) {
        const Entry next = queue_.top();
        const bool stale = !is_member_[next.candidate] || next.weight != weight_[next.candidate];
        if (!stale && !alike.empty() && (next.weight != top.weight || next.aside != top.aside))
            break;
        queue_.pop();
        if (stale) continue;
        top = next;
        alike.push_back(next.candidate);
    }
    return alike;
}

template <int Dim>
void Elimination<Dim>::leaveOut(Index candidate) {
    is_member_[candidate] = 0;
    --left_;
    for (std::size_t k = near_.first[candidate]; k < near_.first[candidate + 1]; ++k) {
        const Index other = near_.neighbor[k];
        if (crowding_[k] == 0) continue;
        weight_[other] -= crowding_[k];
        if (is_member_[other]) queue_.push({weight_[other], aside_[other], other});
    }
}

template <int Dim>
void Elimination<Dim>::leaveOutUntil(double number) {
    while (static_cast<double>(left_) > number) {
        const std::vector<Index> alike = mostCrowded();
        if (alike.empty()) return;
        const double excess = static_cast<double>(left_) - number;
        const auto count = static_cast<double>(alike.size());
        std::size_t leaving = alike.size();
        if (count > excess) {  // the last ones
            const double error = std::min(count - excess, excess);
            if (error > tolerated * number)
                leaving = static_cast<std::size_t>(std::llround(excess));
            else if (excess < count - excess)
                return;
        }
        for (std::size_t k = 0; k < leaving; ++k) leaveOut(alike[k]);
    }
}

template <int Dim>
std::vector<std::uint8_t> Elimination<Dim>::members(std::size_t points) const {
    std::vector<std::uint8_t> members(points, 0);
    for (std::size_t c = 0; c < point_.size(); ++c) members[point_[c]] = is_member_[c];
    return members;
}

}  // namespace

template <int Dim>
std::vector<std::uint8_t> rowMembers(const geometry::Shape<Dim>& shape, double spacing,
                                     const std::vector<Vec<Dim>>& points, double number) {
    Elimination<Dim> elimination(shape, spacing, points);
    elimination.leaveOutUntil(number);
    return elimination.members(points.size());
}

template std::vector<std::uint8_t> rowMembers(const geometry::Shape<2>&, double,
                                              const std::vector<Vec<2>>&, double);
template std::vector<std::uint8_t> rowMembers(const geometry::Shape<3>&, double,
                                              const std::vector<Vec<3>>&, double);

}  // namespace sphinx::fitting
