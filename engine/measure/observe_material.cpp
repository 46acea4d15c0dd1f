// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/observe_material.h"

#include "core/errors.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace sphinx::measure {
namespace {

constexpr Index removed = std::numeric_limits<Index>::max();
constexpr Index unknown = removed - 1;

}  // namespace

template <int Dim>
MaterialWeights<Dim>::MaterialWeights(const bodies::Body<Dim>& observer,
                                      neighbors::Relations<Dim>& relations,
                                      const bodies::Domain<Dim>& domain)
    : ObserveWeights<Dim>(observer, relations), domain_(&domain) {}

template <int Dim>
void MaterialWeights<Dim>::update() {
    if (attached_.empty()) attach();
    locate();
    for (std::size_t point = 0; point < attached_.size(); ++point) {
        std::vector<ParticleWeight>& weights = weights_[point];
        weights.clear();
        double sum = 0;
        for (const Anchor& anchor : attached_[point].anchors) {
            if (anchor.particle == removed) continue;
            weights.push_back({anchor.body, anchor.particle, anchor.weight});
            sum += anchor.weight;
        }
        for (ParticleWeight& one : weights) one.weight /= sum;
        coverage_[point] = sum;
        position_[point] = meanPosition(weights) + attached_[point].offset;
    }
}

template <int Dim>
void MaterialWeights<Dim>::attach() {
    ObserveWeights<Dim>::update();
    attached_.resize(this->points());
    for (std::size_t point = 0; point < attached_.size(); ++point) {
        // By their numbers, wherever they stand in memory.
        const auto id = [&](const ParticleWeight& one) {
            return std::pair(one.body, this->bodies()[one.body]->particles.id()[one.particle]);
        };
        std::ranges::sort(weights_[point], {}, id);
        for (const ParticleWeight& one : weights_[point])
            attached_[point].anchors.push_back(
                {one.body, id(one).second, one.particle, one.weight * coverage_[point]});
        attached_[point].offset = domain_->difference(observer_->particles.position()[point],
                                                      meanPosition(weights_[point]));
    }
}

template <int Dim>
Vec<Dim> MaterialWeights<Dim>::meanPosition(const std::vector<ParticleWeight>& weights) const {
    if (weights.empty()) return Vec<Dim>::Constant(nan_value);
    const auto positionOf = [&](const ParticleWeight& one) -> const Vec<Dim>& {
        return this->bodies()[one.body]->particles.position()[one.particle];
    };
    // Relative to one of them: they may stand on both sides of a periodic boundary.
    const Vec<Dim> origin = positionOf(weights.front());
    Vec<Dim> mean = Vec<Dim>::Zero();
    for (const ParticleWeight& one : weights)
        mean += one.weight * domain_->difference(positionOf(one), origin);
    return origin + mean;
}

/// Finds the particles again after they were sorted or some were removed.
template <int Dim>
void MaterialWeights<Dim>::locate() {
    for (std::size_t b = 0; b < this->bodies().size(); ++b) {
        particles::ParticleSet<Dim>& particles = this->bodies()[b]->particles;
        bool moved = false;
        const auto eachAnchor = [&](auto&& act) {
            for (Point& point : attached_)
                for (Anchor& anchor : point.anchors)
                    if (anchor.body == b) act(anchor);
        };
        eachAnchor([&](const Anchor& anchor) {
            if (anchor.particle == removed) return;
            moved = moved || anchor.particle >= particles.size() ||
                    particles.id()[anchor.particle] != anchor.id;
        });
        if (!moved) continue;
        std::vector<Index> place(static_cast<std::size_t>(particles.nextId()), removed);
        for (std::size_t i = 0; i < particles.size(); ++i)
            place[static_cast<std::size_t>(particles.id()[i])] = static_cast<Index>(i);
        eachAnchor([&](Anchor& anchor) {
            const auto id = static_cast<std::size_t>(anchor.id);
            anchor.particle = id < place.size() ? place[id] : removed;
        });
    }
}

/// What is attached, all points one after the other.
template <int Dim>
struct MaterialWeights<Dim>::Arrays {
    std::vector<double> offset;          // Dim components a point
    std::vector<std::int64_t> anchors;   // how many a point has
    std::vector<std::int64_t> body, id;  // of an anchor
    std::vector<double> weight;          // likewise

    explicit Arrays(const std::vector<Point>& points) {
        for (const Point& point : points) {
            offset.insert(offset.end(), point.offset.begin(), point.offset.end());
            anchors.push_back(static_cast<std::int64_t>(point.anchors.size()));
            for (const Anchor& anchor : point.anchors) {
                body.push_back(anchor.body);
                id.push_back(anchor.id);
                weight.push_back(anchor.weight);
            }
        }
    }

    void transfer(Archive& archive) {
        archive.value("offset", offset);
        archive.value("anchors", anchors);
        archive.value("body", body);
        archive.value("id", id);
        archive.value("weight", weight);
    }

    /// Whether the lengths fit together, and there are no other bodies than so many.
    bool sound(std::size_t bodies) const {
        std::size_t all = 0;
        for (const std::int64_t some : anchors) {
            if (some < 0 || static_cast<std::size_t>(some) > id.size() - all) return false;
            all += static_cast<std::size_t>(some);
        }
        const auto there = [&](std::int64_t b) {
            return b >= 0 && static_cast<std::size_t>(b) < bodies;
        };
        return offset.size() == Dim * anchors.size() && all == id.size() &&
               body.size() == id.size() && weight.size() == id.size() &&
               std::all_of(body.begin(), body.end(), there);
    }

    std::vector<Point> points() const {
        std::vector<Point> result(anchors.size());
        std::size_t k = 0;
        for (std::size_t point = 0; point < result.size(); ++point) {
            for (int c = 0; c < Dim; ++c) result[point].offset[c] = offset[Dim * point + c];
            for (const std::size_t end = k + anchors[point]; k < end; ++k)
                result[point].anchors.push_back(
                    {static_cast<std::uint32_t>(body[k]), id[k], unknown, weight[k]});
        }
        return result;
    }
};

template <int Dim>
void MaterialWeights<Dim>::transfer(Archive& archive) {
    Arrays arrays(attached_);
    arrays.transfer(archive);
    if (!archive.loading()) return;
    if (!arrays.sound(this->bodies().size()))
        throw FileError("the attachment of observer '" + observer_->name + "' is damaged");
    attached_.clear();
    // Observers are free to change between a run and its resumption.
    if (arrays.anchors.size() == this->points()) attached_ = arrays.points();
}

template class MaterialWeights<2>;
template class MaterialWeights<3>;

}  // namespace sphinx::measure
