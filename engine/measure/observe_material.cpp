// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/observe_material.h"

#include "core/errors.h"
#include "io/file/base64.h"
#include "io/file/little_endian.h"

#include <bit>
#include <limits>

namespace sphinx::io {
namespace {

constexpr Index removed = std::numeric_limits<Index>::max();
constexpr Index unknown = removed - 1;

}  // namespace

template <int Dim>
MaterialWeights<Dim>::MaterialWeights(const Body<Dim>& observer, Relations<Dim>& relations,
                                      const Domain<Dim>& domain)
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
        for (const ParticleWeight& one : weights_[point])
            attached_[point].anchors.push_back(
                {one.body, this->bodies()[one.body]->particles.id()[one.particle], one.particle,
                 one.weight * coverage_[point]});
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
        ParticleSet<Dim>& particles = this->bodies()[b]->particles;
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

/// Numbers of 8 bytes: of points, then for each its offset, the number of anchors, and body, id and
/// weight of each.
template <int Dim>
std::string MaterialWeights<Dim>::encoded() const {
    LittleEndian bytes;
    bytes.u64(attached_.size());
    for (const Point& point : attached_) {
        for (int k = 0; k < Dim; ++k) bytes.u64(std::bit_cast<std::uint64_t>(point.offset[k]));
        bytes.u64(point.anchors.size());
        for (const Anchor& anchor : point.anchors)
            bytes.u64(anchor.body)
                .u64(static_cast<std::uint64_t>(anchor.id))
                .u64(std::bit_cast<std::uint64_t>(anchor.weight));
    }
    return bytes.take();
}

template <int Dim>
void MaterialWeights<Dim>::decode(std::string_view bytes) {
    const auto damaged = [&] {
        return FileError("the attachment of observer '" + observer_->name + "' is damaged");
    };
    const auto next = [&] {
        if (bytes.size() < 8) throw damaged();
        std::uint64_t value = 0;
        for (int k = 7; k >= 0; --k) value = value << 8 | static_cast<unsigned char>(bytes[k]);
        bytes.remove_prefix(8);
        return value;
    };
    attached_.clear();
    // Observers are free to change between a run and its resumption.
    if (next() != this->points()) return;
    attached_.resize(this->points());
    for (Point& point : attached_) {
        for (int k = 0; k < Dim; ++k) point.offset[k] = std::bit_cast<double>(next());
        const std::uint64_t anchors = next();
        for (std::uint64_t k = 0; k < anchors; ++k) {
            const std::uint64_t body = next();
            const std::uint64_t id = next();
            if (body >= this->bodies().size()) throw damaged();
            point.anchors.push_back({static_cast<std::uint32_t>(body),
                                     static_cast<std::int64_t>(id), unknown,
                                     std::bit_cast<double>(next())});
        }
    }
    if (!bytes.empty()) throw damaged();
}

template <int Dim>
void MaterialWeights<Dim>::transfer(Archive& archive) {
    std::string text = archive.loading() || attached_.empty() ? "" : encodeBase64(encoded());
    archive.value("attachment", text);
    if (!archive.loading() || text.empty()) return;
    const std::optional<std::string> bytes = decodeBase64(text);
    decode(bytes.value_or(""));
}

template class MaterialWeights<2>;
template class MaterialWeights<3>;

}  // namespace sphinx::io
