// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/shares.h"
#include "core/sum_all.h"
#include "dynamics/words.h"
#include "input/types/values.h"

#include <type_traits>

namespace sphinx::dynamics {

/// Particles that a method acts on: those of a part ("gate.base"), or all of a body ("gate").
/// OfBody: const Body<Dim> for one who only looks (ConstPart).
template <int Dim, class OfBody = Body<Dim>>
class Part {
    template <class T>
    using Like = std::conditional_t<std::is_const_v<OfBody>, const T, T>;

 public:
    /// `name`: a checked reference.
    Part(Like<World<Dim>>& world, const input::Name& name) {
        const std::size_t dot = name.text.find('.');
        body_ = world.find(name.text.substr(0, dot));
        if (dot == std::string::npos) return;
        for (Like<bodies::BodyPart<Dim>>& part : body_->parts)
            if (part.name == name.text.substr(dot + 1)) part_ = &part;
    }

    OfBody& body() const { return *body_; }
    /// nullptr where it is all of a body.
    const bodies::BodyPart<Dim>* named() const { return part_; }
    std::size_t size() const { return part_ ? part_->particles.size() : body_->size(); }
    /// Index in the body of the n-th particle.
    std::size_t operator[](std::size_t n) const { return part_ ? part_->particles[n] : n; }
    /// findShares() makes images of its particles (ElasticRole::isImage). A whole body has none.
    void mirror() const {
        if (part_) body_->elastic().clamps.push_back(part_);
    }
    /// Those that follow others because of this part; ascending.
    std::vector<Index> images() const {
        std::vector<Index> found;
        if (!part_) return found;
        for (std::size_t i = 0; i < body_->size(); ++i)
            if (bodies::outside(*body_, *part_, i) < bodies::ElasticRole<Dim>::real_share)
                found.push_back(static_cast<Index>(i));
        return found;
    }
    /// Where its particles are at the start; of the body where it is all of it.
    const sphinx::geometry::Shape<Dim>* shape() const {
        return part_ ? part_->shape.get() : body_->shape.get();
    }
    /// Of all its particles.
    double mass() const {
        const auto& mass = body_->particles.scalar(fields::mass);
        return sumAll(size(), [&](std::size_t n) { return mass[(*this)[n]]; });
    }

 private:
    OfBody* body_;
    Like<bodies::BodyPart<Dim>>* part_ = nullptr;
};

template <int Dim>
using ConstPart = Part<Dim, const Body<Dim>>;

}  // namespace sphinx::dynamics
