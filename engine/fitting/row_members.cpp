// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/row_members.h"

#include "core/parallel.h"
#include "fitting/measure.h"
#include "fitting/near_pairs.h"
#include "fitting/surface_row.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace sphinx::fitting {
namespace {

// In spacings.
constexpr double deepest = 1.6;
constexpr double reach = 3;
constexpr double row_depth = 0.5;
/// What a spacing of depth counts against a point in the same place.
constexpr double weight_of_depth = 0.25;
/// Weights are whole numbers: the same for points that a symmetry exchanges.
constexpr double unit = 1e-6;
constexpr double tolerated = 0.005;
/// Places nearer than that are on one surface, in spacings.
constexpr double same_surface = 1.7;

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
    Elimination(const geometry::Shape<Dim>& shape, const particles::Lattice<Dim>& lattice,
                const std::vector<Vec<Dim>>& points);

    /// Of each surface the measure of its layer.
    std::vector<double> layers() const;
    void leaveOutUntil(std::size_t surface, double number);
    std::vector<std::uint8_t> members(std::size_t points) const;

 private:
    using Queue = std::priority_queue<Entry>;

    void findSurfaces(const AlignedVector<Vec<Dim>>& place);
    std::vector<Index> mostCrowded(Queue& queue);
    std::vector<Index> apart(std::vector<Index> alike, std::size_t number) const;
    void leaveOut(Index candidate);

    const geometry::Shape<Dim>* shape_;
    particles::Lattice<Dim> lattice_;
    std::vector<Index> point_;  // of each candidate
    AlignedVector<Vec<Dim>> x_;
    std::vector<std::int64_t> weight_;
    std::vector<std::int64_t> aside_;
    std::vector<std::uint8_t> is_member_;
    std::vector<Index> surface_;
    NearPairs near_;
    std::vector<std::int64_t> crowding_;  // of each of those pairs
    std::vector<Queue> queues_;           // of each surface
    std::vector<std::size_t> left_;
};

template <int Dim>
Elimination<Dim>::Elimination(const geometry::Shape<Dim>& shape,
                              const particles::Lattice<Dim>& lattice,
                              const std::vector<Vec<Dim>>& points)
    : shape_(&shape), lattice_(lattice) {
    const double spacing = lattice.spacing;
    const SurfaceRow<Dim> row(shape, spacing);
    const Box<Dim> bounds = shape.bounds();
    const Vec<Dim> middle = 0.5 * (bounds.lower + bounds.upper);
    AlignedVector<double> depth(points.size());
    parallelFor(points.size(),
                [&](std::size_t i) { depth[i] = -shape.signedDistance(points[i]) / spacing; });
    for (std::size_t i = 0; i < points.size(); ++i)
        if (depth[i] < deepest) {
            point_.push_back(static_cast<Index>(i));
            x_.push_back(points[i]);
        }
    const std::size_t candidates = point_.size();
    AlignedVector<Vec<Dim>> place(candidates);
    parallelFor(candidates,
                [&](std::size_t c) { place[c] = row.place(x_[c], row_depth * spacing); });
    near_ = nearPairs(place, reach * spacing);
    findSurfaces(place);
    weight_.resize(candidates);
    aside_.resize(candidates);
    is_member_.assign(candidates, 1);
    crowding_.resize(near_.neighbor.size());
    parallelFor(candidates, [&](std::size_t c) {
        weight_[c] = std::llround(weight_of_depth * depth[point_[c]] / unit);
        aside_[c] = std::llround((x_[c] - middle).template lpNorm<1>() / (unit * spacing));
        for (std::size_t k = near_.first[c]; k < near_.first[c + 1]; ++k) {
            if (surface_[near_.neighbor[k]] != surface_[c]) continue;
            const double way = (place[c] - place[near_.neighbor[k]]).norm() / (reach * spacing);
            crowding_[k] = std::llround((1 - way) * (1 - way) / unit);
            weight_[c] += crowding_[k];
        }
    });
    for (std::size_t c = 0; c < candidates; ++c) {
        queues_[surface_[c]].push({weight_[c], aside_[c], static_cast<Index>(c)});
        ++left_[surface_[c]];
    }
}

/// Numbers those in order that no chain of near places joins.
template <int Dim>
void Elimination<Dim>::findSurfaces(const AlignedVector<Vec<Dim>>& place) {
    constexpr Index unknown = ~Index{0};
    const double near = same_surface * lattice_.spacing;
    surface_.assign(place.size(), unknown);
    std::vector<Index> open;
    for (Index c = 0; c < place.size(); ++c) {
        if (surface_[c] != unknown) continue;
        const auto number = static_cast<Index>(queues_.size());
        queues_.emplace_back();
        left_.push_back(0);
        surface_[c] = number;
        open.push_back(c);
        while (!open.empty()) {
            const Index at = open.back();
            open.pop_back();
            for (std::size_t k = near_.first[at]; k < near_.first[at + 1]; ++k) {
                const Index next = near_.neighbor[k];
                if (surface_[next] != unknown || (place[next] - place[at]).norm() > near) continue;
                surface_[next] = number;
                open.push_back(next);
            }
        }
    }
}

template <int Dim>
std::vector<double> Elimination<Dim>::layers() const {
    std::vector<double> layers(queues_.size());
    if (layers.size() == 1) {
        layers[0] = measureLayer(*shape_, lattice_, lattice_.spacing);
        return layers;
    }
    neighbors::CellGrid<Dim> grid;
    grid.build(x_.data(), x_.size(), deepest * lattice_.spacing);
    forEachPieceOfLayer(*shape_, lattice_, lattice_.spacing,
                        [&](const Vec<Dim>& at, double volume) {
                            Index nearest = 0;
                            double squared = std::numeric_limits<double>::infinity();
                            forEachAround(grid, at, [&](Index c) {
                                const double way = (x_[c] - at).squaredNorm();
                                if (way < squared) squared = way, nearest = c;
                            });
                            if (std::isfinite(squared)) layers[surface_[nearest]] += volume;
                        });
    return layers;
}

/// All that are alike, taken from the queue.
template <int Dim>
std::vector<Index> Elimination<Dim>::mostCrowded(Queue& queue) {
    std::vector<Index> alike;
    Entry top{};
    while (!queue.empty()) {
        const Entry next = queue.top();
        const bool stale = !is_member_[next.candidate] || next.weight != weight_[next.candidate];
        if (!stale && !alike.empty() && (next.weight != top.weight || next.aside != top.aside))
            break;
        queue.pop();
        if (stale) continue;
        top = next;
        alike.push_back(next.candidate);
    }
    return alike;
}

/// So many of them, each as far as can be from those before it: gaps close on either side.
template <int Dim>
std::vector<Index> Elimination<Dim>::apart(std::vector<Index> alike, std::size_t number) const {
    const auto squared = [&](Index a, Index b) { return (x_[a] - x_[b]).squaredNorm(); };
    for (std::size_t k = 1; k < number && number < alike.size(); ++k) {
        const auto nearest = [&](Index candidate) {
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t before = 0; before < k; ++before)
                least = std::min(least, squared(alike[before], candidate));
            return least;
        };
        const auto farthest = std::ranges::max_element(
            alike.begin() + static_cast<std::ptrdiff_t>(k), alike.end(), {}, nearest);
        std::swap(alike[k], *farthest);
    }
    alike.resize(number);
    return alike;
}

template <int Dim>
void Elimination<Dim>::leaveOut(Index candidate) {
    is_member_[candidate] = 0;
    --left_[surface_[candidate]];
    for (std::size_t k = near_.first[candidate]; k < near_.first[candidate + 1]; ++k) {
        const Index other = near_.neighbor[k];
        if (crowding_[k] == 0) continue;
        weight_[other] -= crowding_[k];
        if (is_member_[other])
            queues_[surface_[other]].push({weight_[other], aside_[other], other});
    }
}

template <int Dim>
void Elimination<Dim>::leaveOutUntil(std::size_t surface, double number) {
    const auto excessNow = [&] { return static_cast<double>(left_[surface]) - number; };
    while (excessNow() > 0) {
        const std::vector<Index> alike = mostCrowded(queues_[surface]);
        if (alike.empty()) return;
        const double excess = excessNow();
        const auto count = static_cast<double>(alike.size());
        if (count <= excess) {
            for (const Index candidate : alike) leaveOut(candidate);
            continue;
        }
        const bool all = count - excess < excess;
        auto last = all ? alike.size() : std::size_t{0};
        if (std::min(count - excess, excess) > tolerated * number)
            last = static_cast<std::size_t>(std::llround(excess));
        for (const Index candidate : apart(alike, last)) leaveOut(candidate);
        return;
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
std::vector<std::uint8_t> rowMembers(const geometry::Shape<Dim>& shape,
                                     const particles::Lattice<Dim>& lattice,
                                     const std::vector<Vec<Dim>>& points, double volume) {
    Elimination<Dim> elimination(shape, lattice, points);
    const std::vector<double> layers = elimination.layers();
    for (std::size_t surface = 0; surface < layers.size(); ++surface)
        elimination.leaveOutUntil(surface, layers[surface] / volume);
    return elimination.members(points.size());
}

template std::vector<std::uint8_t> rowMembers(const geometry::Shape<2>&,
                                              const particles::Lattice<2>&,
                                              const std::vector<Vec<2>>&, double);
template std::vector<std::uint8_t> rowMembers(const geometry::Shape<3>&,
                                              const particles::Lattice<3>&,
                                              const std::vector<Vec<3>>&, double);

}  // namespace sphinx::fitting
