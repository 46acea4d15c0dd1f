// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <vector>

namespace sphinx::geometry {

/// Binary tree of boxes around items of the plane, for any distribution of them: finds the items
/// near a box or nearest to a point in logarithmic time. Knows nothing of the items but their box
/// and their number.
class BoxTree {
 public:
    BoxTree() = default;
    explicit BoxTree(const std::vector<Box<2>>& boxes);

    /// visit(item) for every item whose box meets `box`, boundaries included; and perhaps others.
    template <class Visit>
    void forOverlapping(const Box<2>& box, Visit&& visit) const;

    /// Calls distance(item), a squared distance to `point`, for the items that may be nearest.
    /// It returns the smallest found so far, which bounds the rest of the search.
    template <class Distance>
    void nearest(const Vec<2>& point, Distance&& distance) const;

 private:
    struct Node {
        Box<2> box;
        std::uint32_t first, last;  ///< items of a leaf in order_; first == last in an inner node
        std::uint32_t next;  ///< node after this subtree; the children are this + 1 and its next
    };
    static constexpr std::size_t leaf_size = 4;

    void build(const std::vector<Box<2>>& boxes, std::size_t first, std::size_t last);
    static double squaredDistance(const Box<2>& box, const Vec<2>& p) {
        return (p - p.cwiseMax(box.lower).cwiseMin(box.upper)).squaredNorm();
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

template <class Visit>
void BoxTree::forOverlapping(const Box<2>& box, Visit&& visit) const {
    for (std::size_t n = 0; n < nodes_.size();) {
        const Node& node = nodes_[n];
        if (node.box.lower.x() > box.upper.x() || node.box.upper.x() < box.lower.x() ||
            node.box.lower.y() > box.upper.y() || node.box.upper.y() < box.lower.y()) {
            n = node.next;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.last; ++i) visit(order_[i]);
        ++n;
    }
}

template <class Distance>
void BoxTree::nearest(const Vec<2>& point, Distance&& distance) const {
    struct Entry {
        std::uint32_t node;
        double bound;
    };
    // Median splits keep the depth below 32, and a level leaves one entry behind.
    Entry stack[64];
    int size = 0;
    if (!nodes_.empty()) stack[size++] = {0, 0};
    double smallest = std::numeric_limits<double>::infinity();
    while (size > 0) {
        const Entry entry = stack[--size];
        if (entry.bound >= smallest) continue;
        const Node& node = nodes_[entry.node];
        for (std::uint32_t i = node.first; i < node.last; ++i) smallest = distance(order_[i]);
        if (node.first != node.last) continue;
        Entry near{entry.node + 1, squaredDistance(nodes_[entry.node + 1].box, point)};
        const std::uint32_t second = nodes_[entry.node + 1].next;
        Entry far{second, squaredDistance(nodes_[second].box, point)};
        if (far.bound < near.bound) std::swap(near, far);
        stack[size++] = far;
        stack[size++] = near;
    }
}

}  // namespace sphinx::geometry
