// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact/search.h"

#include "core/lanes.h"
#include "core/parallel.h"
#include "neighbors/candidates.h"

#include <algorithm>

namespace sphinx::dynamics::contact {
namespace {

/// Margin of lists with something in them, of the reach: the less the longer they have held.
constexpr double least_margin = 0.05;
constexpr double largest_margin = 0.25;
/// Of one body, in spacings.
constexpr double excluded_of_spacing = 2;
constexpr int few_steps = 20;
constexpr int many_steps = 100;

template <int Dim>
double longest(const Surface<Dim>& surface) {
    double length = 0;
    for (std::size_t n = 0; n < surface.size(); ++n) length = std::max(length, surface.length(n));
    return length;
}

template <int Dim>
Box<Dim> boxAround(const Surface<Dim>& surface) {
    Box<Dim> box;
    for (std::size_t n = 0; n < surface.size(); ++n) box.include(surface.place(n));
    return box;
}

}  // namespace

template <int Dim>
Search<Dim>::Search(const Domain<Dim>& domain, const Surface<Dim>& a, const Surface<Dim>& b,
                    double reach)
    : domain_(&domain), a_{&a}, b_{&b}, reach_(reach), relative_margin_(largest_margin) {}

template <int Dim>
void Search<Dim>::Lists::assign(const std::vector<std::vector<Index>>& found) {
    active_.clear();
    neighbors_.clear();
    first_.assign(found.size(), 0);
    count_.assign(found.size(), 0);
    for (std::size_t n = 0; n < found.size(); ++n) {
        if (found[n].empty()) continue;
        active_.push_back(static_cast<Index>(n));
        first_[n] = neighbors_.size();
        count_[n] = static_cast<std::uint32_t>(found[n].size());
        neighbors_.insert(neighbors_.end(), found[n].begin(), found[n].end());
        while (neighbors_.size() % lane_count != 0) neighbors_.push_back(found[n].front());
    }
}

template <int Dim>
double Search<Dim>::moved(const Seen& seen) const {
    const Surface<Dim>& surface = *seen.surface;
    if (seen.version == surface.version()) return 0;
    return std::sqrt(maxAll(surface.size(), 0, [&](std::size_t n) {
        return domain_->difference(surface.place(n), seen.places[n]).squaredNorm();
    }));
}

template <int Dim>
double Search<Dim>::fastest(const Surface<Dim>& surface) const {
    if (!surface.body().isElastic()) return 0;
    const double speed =
        maxAll(surface.size(), 0, [&](std::size_t n) { return surface.velocity(n).squaredNorm(); });
    const materials::ElasticSolid& material = *surface.body().elastic().material;
    return 2 * std::sqrt(speed) + std::sqrt(material.longitudinalModulus() / material.density());
}

template <int Dim>
bool Search<Dim>::holds() {
    if (margin_ < 0 || a_.places.size() != a_.surface->size() ||
        b_.places.size() != b_.surface->size())
        return false;
    const double dt = std::max(a_.surface->dt(), b_.surface->dt());
    left_ -= fastest_ * dt;
    if (left_ >= 0 && isBounded(a_) && isBounded(b_)) return true;
    left_ = margin_ - moved(a_) - moved(b_);
    if (left_ < 0) return false;
    fastest_ = fastest(*a_.surface) + fastest(*b_.surface);
    left_ -= fastest_ * dt;
    for (Seen* seen : {&a_, &b_}) seen->looked_at = seen->surface->version();
    return true;
}

template <int Dim>
double Search<Dim>::between() const {
    if (std::ranges::find(domain_->periodic, true) != domain_->periodic.end()) return 0;
    const Box<Dim> a = boxAround(*a_.surface);
    const Box<Dim> b = boxAround(*b_.surface);
    return (a.lower - b.upper).cwiseMax(b.lower - a.upper).cwiseMax(0).norm();
}

template <int Dim>
void Search<Dim>::update() {
    if (holds()) {
        ++age_;
        return;
    }
    if (age_ < few_steps) relative_margin_ = std::min(2 * relative_margin_, largest_margin);
    if (age_ > many_steps) relative_margin_ = std::max(0.5 * relative_margin_, least_margin);
    age_ = 0;
    build();
    for (Seen* seen : {&a_, &b_}) {
        const Surface<Dim>& surface = *seen->surface;
        if (seen->version == surface.version()) continue;
        seen->version = surface.version();
        seen->places.resize(surface.size());
        for (std::size_t n = 0; n < surface.size(); ++n) seen->places[n] = surface.place(n);
    }
    left_ = -1;
}

template <int Dim>
void Search<Dim>::build() {
    const Surface<Dim>& from = *a_.surface;
    const Surface<Dim>& to = *b_.surface;
    margin_ = relative_margin_ * reach_;
    std::vector<std::vector<Index>> found(from.size());
    a_to_b_.assign(found);
    if (!self()) b_to_a_.assign(std::vector<std::vector<Index>>(to.size()));
    if (from.size() == 0 || to.size() == 0) return;
    const double reach = reach_ + longest(from) + longest(to);  // between particles
    if (const double apart = self() ? 0 : between(); apart > reach + margin_) {
        margin_ = apart - reach;
        return;
    }
    // Images of the points of `to` that lie in the box around `from`.
    const double far = reach + margin_;
    const Box<Dim> box = boxAround(from);
    AlignedVector<Vec<Dim>> places;
    std::vector<Index> points;
    const sphinx::neighbors::Images<Dim> images(*domain_);
    for (const Vec<Dim>& shift : images.shifts())
        for (std::size_t n = 0; n < to.size(); ++n) {
            const Vec<Dim> place = to.place(n) + shift;
            if (((place - box.lower).array() < -far).any() ||
                ((place - box.upper).array() > far).any())
                continue;
            places.push_back(place);
            points.push_back(static_cast<Index>(n));
        }
    if (places.empty()) return;
    sphinx::neighbors::CellGrid<Dim> grid;
    grid.build(places.data(), places.size(), far);

    const double excluded = std::max(reach_, excluded_of_spacing * from.body().spacing);
    parallelFor(from.size(), [&](std::size_t n) {
        const Vec<Dim> x = from.place(n);
        std::vector<Index>& mine = found[n];
        std::array<int, Dim> first{}, last{};
        for (int k = 0; k < Dim; ++k) {
            const double cell = (x[k] - grid.origin()[k]) / grid.cellSize();
            const double end = grid.counts()[k] - 1;
            first[k] = static_cast<int>(std::clamp(std::floor(cell) - 1, 0.0, end));
            last[k] = static_cast<int>(std::clamp(std::floor(cell) + 1, 0.0, end));
        }
        std::array<int, Dim> c = first;
        for (bool more = true; more;) {
            const std::size_t cell = grid.cellIndex(c);
            for (std::size_t s = grid.start(cell); s < grid.start(cell + 1); ++s) {
                const Index place = grid.order()[s];
                const Index m = points[place];
                const double near = reach_ + margin_ + from.length(n) + to.length(m);
                if ((places[place] - x).squaredNorm() >= near * near) continue;
                if (self() &&
                    (m == n ||
                     domain_->difference(from.initialPlace(n), to.initialPlace(m)).squaredNorm() <
                         excluded * excluded))
                    continue;
                mine.push_back(m);
            }
            more = false;
            for (int k = 0; k < Dim && !more; ++k) {
                more = ++c[k] <= last[k];
                if (!more) c[k] = first[k];
            }
        }
        std::ranges::sort(mine);
    });
    a_to_b_.assign(found);
    if (self()) return;
    std::vector<std::vector<Index>> back(to.size());
    for (const Index n : a_to_b_.active())
        for (const Index m : found[n]) back[m].push_back(n);
    b_to_a_.assign(back);
}

template class Search<2>;
template class Search<3>;

}  // namespace sphinx::dynamics::contact
