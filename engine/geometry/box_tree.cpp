// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "geometry/box_tree.h"

#include <algorithm>
#include <numeric>

namespace sphinx::geometry {

BoxTree::BoxTree(const std::vector<Box<2>>& boxes) : order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!boxes.empty()) build(boxes, 0, boxes.size());
}

void BoxTree::build(const std::vector<Box<2>>& boxes, std::size_t first, std::size_t last) {
    const std::size_t self = nodes_.size();
    nodes_.emplace_back();
    Box<2> around;
    for (std::size_t i = first; i < last; ++i) around.include(boxes[order_[i]]);
    nodes_[self].box = around;
    if (last - first <= leaf_size) {
        nodes_[self].first = static_cast<std::uint32_t>(first);
        nodes_[self].last = static_cast<std::uint32_t>(last);
    } else {
        nodes_[self].first = nodes_[self].last = 0;
        const int axis = around.size().x() >= around.size().y() ? 0 : 1;
        const std::size_t middle = first + (last - first) / 2;
        const auto at = [&](std::size_t i) {
            return order_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t a, std::uint32_t b) {
            const double ca = boxes[a].lower[axis] + boxes[a].upper[axis];
            const double cb = boxes[b].lower[axis] + boxes[b].upper[axis];
            return ca != cb ? ca < cb : a < b;
        });
        build(boxes, first, middle);
        build(boxes, middle, last);
    }
    nodes_[self].next = static_cast<std::uint32_t>(nodes_.size());
}

}  // namespace sphinx::geometry
