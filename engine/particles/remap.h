// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/types.h"

#include <functional>
#include <vector>

namespace sphinx::particles {

/// Where the particles of a set went when some came, went or changed places in memory.
class Remap {
 public:
    static constexpr Index none = ~Index{0};

    /// The particles order[0], order[1], ... come first, in that order; all others but they are
    /// gone; those behind them, up to `after`, are new. `order` is read as long as this lives.
    Remap(const AlignedVector<Index>& order, std::size_t before, std::size_t after)
        : order_(&order), carried_(order.size()), before_(before), after_(after) {}
    /// The first `carried` particles stay where they are.
    Remap(std::size_t carried, std::size_t before, std::size_t after)
        : carried_(carried), before_(before), after_(after) {}

    std::size_t before() const { return before_; }  ///< number of particles
    std::size_t after() const { return after_; }
    /// Particles that are still there; new ones stand behind them.
    std::size_t carried() const { return carried_; }
    /// Whether those stand where they stood.
    bool inPlace() const { return !order_; }

    /// Old place of the particle that is at k now; none: it is new.
    Index from(std::size_t k) const {
        if (k >= carried_) return none;
        return order_ ? (*order_)[k] : static_cast<Index>(k);
    }
    /// New place of the particle that was at i; none: it is gone.
    Index to(std::size_t i) const;

 private:
    const AlignedVector<Index>* order_ = nullptr;
    std::size_t carried_;
    std::size_t before_;
    std::size_t after_;
    mutable std::vector<Index> places_;  // old to new, made when first asked for
};

class RemapSubscription;

/// Those who hear of the remaps of one set of particles.
class RemapListeners {
 public:
    RemapListeners() = default;
    RemapListeners(const RemapListeners&) = delete;
    RemapListeners& operator=(const RemapListeners&) = delete;
    ~RemapListeners();

    void tell(const Remap& remap) const;

 private:
    friend class RemapSubscription;
    std::vector<RemapSubscription*> all_;
};

/// Calls `act` after every remap, for as long as it lives; the set lives longer. At that time the
/// fields stand at their new places, and new particles have their initial values.
class RemapSubscription {
 public:
    RemapSubscription(RemapListeners& listeners, std::function<void(const Remap&)> act);
    ~RemapSubscription();
    RemapSubscription(const RemapSubscription&) = delete;
    RemapSubscription& operator=(const RemapSubscription&) = delete;

 private:
    friend class RemapListeners;
    RemapListeners* listeners_;
    std::function<void(const Remap&)> act_;
};

}  // namespace sphinx::particles
