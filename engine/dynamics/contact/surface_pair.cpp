// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact/surface_pair.h"

#include "core/errors.h"
#include "core/parallel.h"
#include "core/sum_all.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sphinx::dynamics::contact {
namespace {

/// In spacings. Points a spacing apart touch: of the other surface one and more to each side are in
/// reach.
constexpr double reach_of_spacing = 2;
/// Cosine of the angle up to which a normal opposes another. A mean has no small weights: a floor
/// beside the side of a box would meet the plane of that side in full as soon as the box leans.
constexpr double least_opposed = 0.5;
/// In spacings: what is deeper under another surface is on the far side of a thin body.
constexpr double deepest = 1.5;

/// The damping ratio of a spring and dashpot that pushes and does not pull, with which a mass
/// leaves it with `e` of its speed (Schwager & Poeschel 2007, doi:10.1007/s10035-007-0065-z):
///   e = exp(-z/s (pi - atan2(2 z s, 2 z^2 - 1)...)), s = sqrt(1 - z^2).
double restitutionOf(double z) {
    const double s = std::sqrt(1 - z * z);
    return std::exp(-z / s * std::atan2(2 * z * s, 2 * z * z - 1));
}

double dampingRatio(double restitution) {
    double lower = 0, upper = 1 - 1e-9;
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (lower + upper);
        (restitutionOf(middle) > restitution ? lower : upper) = middle;
    }
    return 0.5 * (lower + upper);
}

}  // namespace

template <int Dim>
SurfacePair<Dim>::SurfacePair(const Domain<Dim>& domain, Surface<Dim>& a, Surface<Dim>& b,
                              const PairLaw& law)
    : Pair<Dim>(domain, a, b, law, reach_of_spacing * std::max(a.body().spacing, b.body().spacing)),
      spacing_(std::max(a.body().spacing, b.body().spacing)) {
    sides_.push_back({&a, &b, &this->search_.ofA(), {}, {}, {}, {}, {}});
    if (&a != &b) sides_.push_back({&b, &a, &this->search_.ofB(), {}, {}, {}, {}, {}});
}

template <int Dim>
[[gnu::always_inline]] inline typename SurfacePair<Dim>::Points SurfacePair<Dim>::one(
    const Surface<Dim>& surface, std::size_t n) const {
    const auto& point = surface[n];
    Points all;
    for (int c = 0; c < Dim; ++c) {
        all.place[c] = point.place[c];
        all.normal[c] = point.normal[c];
    }
    all.depth = point.depth;
    all.area = point.area;
    all.edge = point.edge;
    all.tip = point.tip;
    return all;
}

template <int Dim>
[[gnu::always_inline]] inline typename SurfacePair<Dim>::Points SurfacePair<Dim>::eight(
    const Surface<Dim>& surface, const Index* points) const {
    constexpr int stride = sizeof(typename Surface<Dim>::Point) / sizeof(double);
    Lanes place[4], normal[4];
    gatherRecords<stride>(surface.records(), points, place);
    gatherRecords<stride>(surface.records() + 4, points, normal);
    Points all;
    for (int c = 0; c < Dim; ++c) {
        all.place[c] = place[c];
        all.normal[c] = normal[c];
    }
    all.depth = place[3];
    all.area = normal[3];
    all.edge = gatherStrided<stride>(surface.records() + 11, points);
    all.tip = gatherStrided<stride>(surface.records() + 15, points);
    return all;
}

template <int Dim>
[[gnu::always_inline]] inline typename SurfacePair<Dim>::Vector SurfacePair<Dim>::apart(
    const Vector& a, const Vector& b) const {
    Vector d = a - b;
    for (int c = 0; c < Dim; ++c) {
        if (!this->domain_->periodic[c]) continue;
        const double period = this->domain_->bounds.upper[c] - this->domain_->bounds.lower[c];
        d[c] = select(d[c] > 0.5 * period, d[c] - period, d[c]);
        d[c] = select(d[c] < -0.5 * period, d[c] + period, d[c]);
    }
    return d;
}

template <int Dim>
[[gnu::always_inline]] inline typename SurfacePair<Dim>::View SurfacePair<Dim>::view(
    const Points& i, const Points& j, std::size_t count) const {
    constexpr LaneMask lane = {0, 1, 2, 3, 4, 5, 6, 7};
    View seen;
    seen.apart = apart(i.place, j.place);
    const Wide squared = seen.apart.squaredNorm();
    const Wide near = 1 - squared / (this->reach_ * this->reach_);
    const Wide opposed = -i.normal.dot(j.normal) - least_opposed;
    const Wide inverse = 1 / sqrt(max(squared, 1e-300));
    for (int c = 0; c < Dim; ++c)
        seen.normal[c] = select(j.edge > 0, seen.apart[c] * inverse, j.normal[c]);
    const LaneMask sharp = (i.edge > 0) & !(j.edge > 0);
    for (int c = 0; c < Dim; ++c) seen.turned[c] = select(sharp, i.tip * j.normal[c], 0);
    seen.gap = seen.apart.dot(seen.normal) - j.depth +
               select(sharp, i.tip * i.normal.dot(j.normal), -i.depth);
    const LaneMask valid = (lane < static_cast<std::int64_t>(count)) & (near > 0) & (opposed > 0) &
                           (seen.gap > -deepest * spacing_);
    const Wide bare = select(valid, j.area * near * near, 0);
    seen.bare = bare * near;
    seen.weight = opposed * seen.bare;
    seen.slope = (-6 / (this->reach_ * this->reach_) * opposed * bare) * seen.apart;
    return seen;
}

template <int Dim>
void SurfacePair<Dim>::findNear(Side& side, Index n) const {
    const std::span<const Index> all = side.lists->of(n);
    Index* near = side.near.data() + side.lists->first(n);
    const Points i = one(*side.from, n);
    constexpr int stride = sizeof(typename Surface<Dim>::Point) / sizeof(double);
    std::uint32_t count = 0;
    for (std::size_t m = 0; m < all.size(); m += lane_count) {
        Lanes place[4];
        gatherRecords<stride>(side.to->records(), all.data() + m, place);
        Vector other;
        for (int c = 0; c < Dim; ++c) other[c] = place[c];
        const Wide squared = apart(i.place, other).squaredNorm();
        unsigned bits = lessBits(squared.at, lanes(this->reach_ * this->reach_));
        if (all.size() - m < lane_count) bits &= (1u << (all.size() - m)) - 1;
        for (; bits != 0; bits &= bits - 1)
            near[count++] = all[m + static_cast<std::size_t>(std::countr_zero(bits))];
    }
    side.near_count[n] = count;
    for (; count % lane_count != 0; ++count) near[count] = near[0];
}

template <int Dim>
void SurfacePair<Dim>::meet(Side& side) {
    const Surface<Dim>& from = *side.from;
    side.touches.resize(from.size());
    side.shares.resize(from.size());
    side.stretch.resize(from.size(), Vec<Dim>::Zero());
    side.near_count.resize(from.size());
    side.near.resize(side.lists->size());
    const std::vector<Index>& active = side.lists->active();
    parallelFor(active.size(), [&](std::size_t m) {
        const Index n = active[m];
        findNear(side, n);
        const Points i = one(from, n);
        const Vector zero = Vector::Zero();
        Wide weight = 0, gap = 0;
        Vector normal = zero, velocity = zero, slope = zero, slope_gap = zero, bare = zero,
               bare_gap = zero, turned = zero;
        const Index* near = side.near.data() + side.lists->first(n);
        const std::size_t count = side.near_count[n];
        for (std::size_t k = 0; k < count; k += lane_count) {
            const Points j = eight(*side.to, near + k);
            const View seen = view(i, j, count - k);
            weight += seen.weight;
            gap += seen.weight * seen.gap;
            normal += seen.weight * seen.normal;
            slope += seen.slope;
            slope_gap += seen.gap * seen.slope;
            bare -= seen.bare * j.normal;
            bare_gap -= seen.gap * seen.bare * j.normal;
            turned += seen.weight * seen.turned;
            Lanes moves[4];
            constexpr int stride = sizeof(typename Surface<Dim>::Point) / sizeof(double);
            gatherRecords<stride>(side.to->records() + 8, near + k, moves);
            for (int c = 0; c < Dim; ++c) velocity[c] += seen.weight * moves[c];
        }
        const auto sum = [](const Vector& v) {
            Vec<Dim> all;
            for (int c = 0; c < Dim; ++c) all[c] = sumLanes(v[c].at);
            return all;
        };
        Touch touch;
        Share share;
        touch.weight = sumLanes(weight.at);
        if (touch.weight > 0) {
            share.gap = sumLanes(gap.at) / touch.weight;
            touch.gap = share.gap;
        }
        if (touch.gap < 0) {
            touch.normal = (sum(normal) + sum(slope_gap) - share.gap * sum(slope)) / touch.weight;
            touch.turn = (sum(bare_gap) - share.gap * sum(bare) + sum(turned)) / touch.weight;
            const Eigen::Map<const Vec<Dim>> own(from[n].slip);
            touch.velocity = own - sum(velocity) / touch.weight;
        } else {
            touch = {};
            side.stretch[n].setZero();
        }
        side.touches[n] = touch;
        side.shares[n] = share;
    });
}

template <int Dim>
double SurfacePair<Dim>::dampingTime() const {
    if (this->law_.restitution >= 1) return 0;
    double touching = 0;
    for (const Side& side : sides_) {
        const std::vector<Index>& active = side.lists->active();
        touching += sumAll(active.size(), [&](std::size_t m) {
            const Index n = active[m];
            return side.touches[n].weight > 0 ? 0.5 * (*side.from)[n].area : 0.0;
        });
    }
    if (touching == 0) return 0;
    double inverse_mass = 0;
    for (const Side& side : sides_) inverse_mass += 1 / side.from->body().carriedMass();
    if (inverse_mass == 0) return 0;
    return 2 * dampingRatio(this->law_.restitution) /
           std::sqrt(inverse_mass * this->law_.stiffness * touching);
}

template <int Dim>
void SurfacePair<Dim>::push(Side& side, double damping_time, double dt) {
    const Surface<Dim>& from = *side.from;
    const std::vector<Index>& active = side.lists->active();
    // The points of the other surface bear the other half.
    const double stiffness = 0.5 * this->law_.stiffness;
    const double viscosity = 0.5 * this->law_.viscous / spacing_;
    parallelFor(active.size(), [&](std::size_t m) {
        const Index n = active[m];
        const Touch& touch = side.touches[n];
        if (touch.weight == 0) return;
        const double area = from[n].area;
        const double closing = -touch.velocity.dot(touch.normal);
        const double force = stiffness * area * std::max(0.0, damping_time * closing - touch.gap);
        side.shares[n].normal = force / touch.weight;
        const double length = touch.normal.norm();
        const Vec<Dim> normal = touch.normal / length;
        const auto along = [&](const Vec<Dim>& v) { return Vec<Dim>(v - v.dot(normal) * normal); };
        const Vec<Dim> slip = along(touch.velocity);
        Vec<Dim> friction = -viscosity * area * slip;
        if (this->law_.coulomb > 0) {
            Vec<Dim>& stretch = side.stretch[n];
            stretch = along(stretch) + dt * slip;
            const double most = this->law_.coulomb * force * length / (stiffness * area);
            const double way = stretch.norm();
            if (way > most) stretch *= most / way;
            friction -= stiffness * area * stretch;
        }
        for (int c = 0; c < Dim; ++c) side.shares[n].friction[c] = friction[c] / touch.weight;
    });
}

template <int Dim>
void SurfacePair<Dim>::collect(Side& side, const Side& back) {
    Surface<Dim>& from = *side.from;
    const Surface<Dim>& to = *side.to;
    const std::vector<Index>& active = side.lists->active();
    Loads<Dim>& loads = from.loads();
    for (const Index n : active) loads.touch(from.particle(n));
    from.willTurn(active);
    parallelFor(active.size(), [&](std::size_t m) {
        const Index n = active[m];
        const Points i = one(from, n);
        const Touch& touch = side.touches[n];
        const Share& own = side.shares[n];
        Vector pushed = Vector::Zero(), turned = Vector::Zero(), rubbed = Vector::Zero();
        const Index* near = side.near.data() + side.lists->first(n);
        const std::size_t count = side.near_count[n];
        constexpr int stride = sizeof(Share) / sizeof(double);
        for (std::size_t k = 0; k < count; k += lane_count) {
            Lanes share[4], friction[4];
            gatherRecords<stride>(&back.shares.data()->normal, near + k, share);
            if (maskBits(share[0] != 0) == 0) continue;
            gatherRecords<stride>(back.shares.data()->friction, near + k, friction);
            const Points j = eight(to, near + k);
            const View seen = view(j, i, count - k);
            const Wide force = share[0], beyond = seen.gap - Wide(share[1]);
            pushed += force * (seen.weight * seen.normal + beyond * seen.slope);
            for (int c = 0; c < Dim; ++c) rubbed[c] += seen.weight * Wide(friction[c]);
            const Wide flat = select(i.edge > 0, 0, seen.weight);
            const Wide tip = select(j.edge > 0, j.tip, 0);
            turned +=
                force * (flat * (seen.apart + tip * j.normal) - (beyond * seen.bare) * j.normal);
        }
        Vec<Dim> force, turn;
        for (int c = 0; c < Dim; ++c) {
            const double felt = touch.weight * own.friction[c];
            const double back = -sumLanes(rubbed[c].at);
            force[c] =
                touch.weight * own.normal * touch.normal[c] - sumLanes(pushed[c].at) + felt + back;
            // dE = -f dg, and the work of friction, f (dr + arm dn)
            turn[c] = -touch.weight * own.normal * touch.turn[c] - sumLanes(turned[c].at) -
                      from.slipArm(n) * felt - from.backArm(n) * back;
        }
        if (force.isZero(0)) return;
        from.turn(n, turn);
        const Index particle = from.particle(n);
        loads.force[particle] += force;
        const Eigen::Map<const Vec<Dim>> normal(from[n].normal);
        loads.pressure[particle] -= force.dot(normal) / from[n].area;
    });
}

template <int Dim>
void SurfacePair<Dim>::act(double dt) {
    this->search();
    for (Side& side : sides_) side.from->take(side.lists->active());
    for (std::size_t s = 0; s < sides_.size(); ++s) {
        Side& side = sides_[s];
        std::vector<double>& loaded = loaded_[s];
        if (!loaded.empty()) {
            if (loaded.size() != side.from->size() * Dim)
                throw FileError("the restart has another number of points in contact");
            side.stretch.resize(side.from->size());
            for (std::size_t n = 0; n < side.from->size(); ++n)
                for (int c = 0; c < Dim; ++c) side.stretch[n][c] = loaded[n * Dim + c];
            loaded.clear();
        }
        meet(side);
    }
    const double damping_time = dampingTime();
    for (Side& side : sides_) push(side, damping_time, dt);
    for (std::size_t s = 0; s < sides_.size(); ++s)
        collect(sides_[s], sides_[sides_.size() - 1 - s]);
}

template <int Dim>
void SurfacePair<Dim>::transfer(Archive& archive) {
    constexpr std::array names{"stretch", "stretch_back"};
    for (std::size_t s = 0; s < sides_.size(); ++s) {
        Side& side = sides_[s];
        std::vector<double> numbers = loaded_[s];
        if (!archive.loading() && numbers.empty()) {
            for (const Vec<Dim>& stretch : side.stretch)
                numbers.insert(numbers.end(), stretch.begin(), stretch.end());
        }
        archive.value(names[s], numbers);
        if (archive.loading()) loaded_[s] = std::move(numbers);
    }
}

template class SurfacePair<2>;
template class SurfacePair<3>;

}  // namespace sphinx::dynamics::contact
