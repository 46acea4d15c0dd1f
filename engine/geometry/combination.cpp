// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "geometry/combination.h"

namespace sphinx::geometry {

Combination::Combination(Rule rule, std::vector<ShapePointer<3>> parts)
    : rule_(rule), parts_(std::move(parts)), bounds_(parts_.front()->bounds()) {
    for (const ShapePointer<3>& part : parts_) {
        const Box<3> box = part->bounds();
        if (rule_ == Rule::any) bounds_.include(box);
        if (rule_ == Rule::all) {
            bounds_.lower = bounds_.lower.cwiseMax(box.lower);
            bounds_.upper = bounds_.upper.cwiseMin(box.upper);
        }
    }
}

Combination::Decision Combination::decide(const Vec<3>& point) const {
    Decision decision{0, parts_[0]->signedDistance(point)};
    for (std::size_t i = 1; i < parts_.size(); ++i) {
        const double distance = sign(i) * parts_[i]->signedDistance(point);
        const bool better =
            rule_ == Rule::any ? distance < decision.distance : distance > decision.distance;
        if (better) decision = {i, distance};
    }
    return decision;
}

Vec<3> Combination::normal(const Vec<3>& point) const {
    const std::size_t part = decide(point).part;
    return sign(part) * parts_[part]->normal(point);
}

ShapePointer<3> Combination::transformed(const Similarity<3>& map) const {
    std::vector<ShapePointer<3>> parts;
    for (const ShapePointer<3>& part : parts_) parts.push_back(composable(part).transformed(map));
    return std::make_shared<Combination>(rule_, std::move(parts));
}

// max(a, -b) - by = max(a - by, -(b + by)), and alike for the others: what is taken away shrinks
// while the rest grows.
ShapePointer<3> Combination::grown(double by) const {
    std::vector<ShapePointer<3>> parts;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        ShapePointer<3> part = composable(parts_[i]).grown(sign(i) * by);
        if (part) {
            parts.push_back(std::move(part));
        } else if (rule_ == Rule::all || (rule_ == Rule::first_not_rest && i == 0)) {
            return nullptr;
        }
    }
    if (parts.empty()) return nullptr;
    auto result = std::make_shared<Combination>(rule_, std::move(parts));
    return result->empty() ? nullptr : result;
}

}  // namespace sphinx::geometry
