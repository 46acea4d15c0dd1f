// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/contact/surface.h"

#include <span>

namespace sphinx::dynamics::contact {

/// Which points of one surface may be within reach of which of another, or of the same, in both
/// directions. The lists are longer than the reach by a margin and hold until the surfaces have
/// used it up, so that most steps look for nothing; where nothing is near, the margin is what lies
/// between the two.
template <int Dim>
class Search {
 public:
    /// The reach is that of points, which may be at a distance from their particles. Within one
    /// body, points whose particles are nearer than that and two spacings in the reference
    /// configuration are left out.
    Search(const Domain<Dim>& domain, const Surface<Dim>& a, const Surface<Dim>& b, double reach);

    /// The neighbors of points of one surface.
    class Lists {
     public:
        /// Points with neighbors; ascending.
        const std::vector<Index>& active() const { return active_; }
        /// Of the other surface, ascending: at least those within reach.
        std::span<const Index> of(std::size_t n) const {
            return {neighbors_.data() + first_[n], count_[n]};
        }
        /// Where they stand among all; each point has room for whole vectors.
        std::size_t first(std::size_t n) const { return first_[n]; }
        std::size_t size() const { return neighbors_.size(); }

     private:
        friend class Search;
        void assign(const std::vector<std::vector<Index>>& found);

        std::vector<Index> active_;
        std::vector<std::size_t> first_;
        std::vector<std::uint32_t> count_;
        std::vector<Index> neighbors_;  // filled up to whole vectors
    };

    /// Once the surfaces have moved.
    void update();
    const Lists& ofA() const { return a_to_b_; }
    /// Of a surface with itself the same.
    const Lists& ofB() const { return self() ? a_to_b_ : b_to_a_; }

 private:
    /// A surface as it was when the lists were made.
    struct Seen {
        const Surface<Dim>* surface;
        std::uint64_t version = ~std::uint64_t{0};
        std::uint64_t looked_at = ~std::uint64_t{0};  ///< version when somebody last looked
        std::vector<Vec<Dim>> places{};
    };
    bool self() const { return a_.surface == b_.surface; }
    /// Whether both surfaces still have all that may be near in the lists.
    bool holds();
    double moved(const Seen& seen) const;
    /// Of an elastic body a bound of the speed of its points for some steps; of another 0.
    double fastest(const Surface<Dim>& surface) const;
    /// What has no such bound has not moved since somebody looked.
    bool isBounded(const Seen& seen) const {
        return seen.surface->body().isElastic() || seen.looked_at == seen.surface->version();
    }
    void build();
    /// How far apart the boxes around both are; 0 where the domain has images.
    double between() const;

    const Domain<Dim>* domain_;
    Seen a_, b_;
    double reach_;
    double relative_margin_;
    double margin_ = -1;  // no lists yet
    int age_ = 0;         // of the lists, in steps
    // Until both may have moved that far, nobody looks.
    double left_ = -1;
    double fastest_ = 0;
    Lists a_to_b_, b_to_a_;
};

}  // namespace sphinx::dynamics::contact
