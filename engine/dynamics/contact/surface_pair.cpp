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
constexpr double reach_of_spacing = 1.5;
/// Cosine of the angle up to which a normal opposes another. A mean has no small weights: a floor
/// beside the side of a box would meet the plane of that side in full as soon as the box leans.
constexpr double least_opposed = 0.5;
/// In spacings: beyond an edge the plane of its face bends away by the square of the way over this.
constexpr double bend_radius = 0.25;
/// Of dp^(Dim-1): what sees less of the other surface bears less.
constexpr double least_weight = 0.1;

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

/// A layer of a thickness d, compressed by g, has the logarithmic strain of its material, so no
/// surfaces meet through it: with s = g/d, by kappa,
///   energy d^2 (s + (1 - s) ln(1 - s)), pressure -d ln(1 - s), stiffness 1/(1 - s);
/// beyond s = 0.9 the stiffness stays.
Compression compressed(double g, double thickness) {
    if (thickness == 0) return {0.5 * g * g, g, 1};
    constexpr double most = 0.9;
    const double s = std::min(g / thickness, most), left = 1 - s, log = std::log1p(-s);
    const double more = g - s * thickness;
    const double pressure = -thickness * log;
    return {thickness * thickness * (s + left * log) + more * (pressure + 0.5 * more / left),
            pressure + more / left, 1 / left};
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
    all.area = point.met_area;
    all.ends = point.ends;
    for (int c = 0; c < Dim; ++c) {
        all.edge[c] = point.edge[c];
        all.beyond[c] = point.beyond[c];
    }
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
    all.area = place[3];
    all.ends = normal[3];
    if (maskBits(normal[3] > 0) == 0) {
        all.edge = all.beyond = Vector::Zero();
        return all;
    }
    gatherRecords<stride>(surface.records() + 12, points, place);
    gatherRecords<stride>(surface.records() + 16, points, normal);
    for (int c = 0; c < Dim; ++c) {
        all.edge[c] = place[c];
        all.beyond[c] = normal[c];
    }
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
    const Wide past = select(j.ends > 0, max(apart(i.place, j.edge).dot(j.beyond), 0), 0);
    seen.bend = (2 / (bend_radius * spacing_)) * past;
    seen.gap = seen.apart.dot(j.normal) + 0.5 * seen.bend * past;
    seen.normal = j.normal + seen.bend * j.beyond;
    const LaneMask valid = (lane < static_cast<std::int64_t>(count)) & (near > 0) & (opposed > 0);
    // Not negative: a plane is no farther than its point.
    const Wide up = 1 + seen.gap * (1 / this->reach_);
    const Wide up3 = up * up * up;
    const Wide bare = select(valid, j.area * near * near * up3, 0);
    seen.rise = (4 / this->reach_) * opposed * bare * near;
    seen.bare = bare * near * up;
    seen.weight = opposed * seen.bare;
    seen.slope = (-6 / (this->reach_ * this->reach_) * opposed * bare * up) * seen.apart;
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
               bare_gap = zero, risen = zero, risen_gap = zero;
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
            risen += seen.rise * seen.normal;
            risen_gap += seen.rise * seen.gap * seen.normal;
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
            touch.normal = (sum(normal) + sum(slope_gap) + sum(risen_gap) -
                            share.gap * (sum(slope) + sum(risen))) /
                           touch.weight;
            touch.turn = (sum(bare_gap) - share.gap * sum(bare)) / touch.weight;
            touch.by_place = sum(slope) + sum(risen);
            touch.by_normal = sum(bare);
            touch.layer = compressed(-touch.gap, this->law_.thickness);
            const Eigen::Map<const Vec<Dim>> own(from[n].velocity);
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
            return side.touches[n].weight > 0 ? 0.5 * side.from->area(n) : 0.0;
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
        if (touch.weight == 0 || from.area(n) == 0) return;
        const double area = from.area(n);
        const double closing = -touch.velocity.dot(touch.normal);
        const double whole = least_weight * std::pow(from.body().spacing, Dim - 1);
        const double part = std::min(1.0, touch.weight / whole);
        const double seen = part * part * (3 - 2 * part);
        const double force =
            seen * stiffness * area * std::max(0.0, damping_time * closing + touch.layer.pressure);
        side.shares[n].normal = force / touch.weight;
        side.shares[n].fade =
            -6 * part * (1 - part) / whole * stiffness * area * touch.layer.energy;
        const double length = touch.normal.norm();
        const Vec<Dim> normal = touch.normal / length;
        const auto along = [&](const Vec<Dim>& v) { return Vec<Dim>(v - v.dot(normal) * normal); };
        const Vec<Dim> slip = along(touch.velocity);
        Vec<Dim> friction = -seen * viscosity * area * slip;
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
    from.willPush(active);
    parallelFor(active.size(), [&](std::size_t m) {
        const Index n = active[m];
        const Points i = one(from, n);
        const Touch& touch = side.touches[n];
        const Share& own = side.shares[n];
        const Vector zero = Vector::Zero();
        Vector pushed = zero, turned = zero, rubbed = zero, pushed_edge = zero, turned_edge = zero;
        const Index* near = side.near.data() + side.lists->first(n);
        const std::size_t count = side.near_count[n];
        constexpr int stride = sizeof(Share) / sizeof(double);
        for (std::size_t k = 0; k < count; k += lane_count) {
            Lanes share[4], friction[4];
            gatherRecords<stride>(&back.shares.data()->normal, near + k, share);
            if (maskBits((share[0] != 0) | (share[2] != 0)) == 0) continue;
            gatherRecords<stride>(back.shares.data()->friction, near + k, friction);
            const Points j = eight(to, near + k);
            const View seen = view(j, i, count - k);
            const Wide force = share[0], beyond = seen.gap - Wide(share[1]), fade = share[2];
            const Wide whole = seen.weight + beyond * seen.rise;
            const Wide plane = force * whole + fade * seen.rise;
            pushed += plane * i.normal + (force * beyond + fade) * seen.slope;
            turned += plane * seen.apart - ((force * beyond + fade) * seen.bare) * j.normal;
            pushed_edge += (plane * seen.bend) * i.beyond;
            turned_edge += (plane * seen.bend) * apart(j.place, i.edge);
            for (int c = 0; c < Dim; ++c) rubbed[c] += seen.weight * Wide(friction[c]);
        }
        Vec<Dim> force, turn;
        for (int c = 0; c < Dim; ++c) {
            const double felt = touch.weight * own.friction[c];
            const double back = -sumLanes(rubbed[c].at);
            force[c] = touch.weight * own.normal * touch.normal[c] + own.fade * touch.by_place[c] -
                       sumLanes(pushed[c].at) + felt + back;
            // dE = -f dg, and the work of friction, f (dr + arm dn)
            turn[c] = -touch.weight * own.normal * touch.turn[c] - own.fade * touch.by_normal[c] -
                      sumLanes(turned[c].at);
        }
        from.push(n, force, turn);
        if (from[n].ends == 0) return;
        for (int c = 0; c < Dim; ++c) {
            force[c] = -sumLanes(pushed_edge[c].at);
            turn[c] = -sumLanes(turned_edge[c].at);
        }
        from.pushEdge(n, force, turn);
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
    this->stiffening_ = 0;
    for (const Side& side : sides_) {
        const std::vector<Index>& active = side.lists->active();
        this->stiffening_ = maxAll(active.size(), this->stiffening_, [&](std::size_t m) {
            const Touch& touch = side.touches[active[m]];
            if (touch.weight == 0) return 0.0;
            return touch.layer.stiffness * side.from->leverage(active[m]);
        });
    }
    for (std::size_t s = 0; s < sides_.size(); ++s)
        collect(sides_[s], sides_[sides_.size() - 1 - s]);
}

template <int Dim>
void SurfacePair<Dim>::transfer(Archive& archive) {
    archive.value("stiffening", this->stiffening_);
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
