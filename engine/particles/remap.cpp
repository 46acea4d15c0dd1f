// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/remap.h"

#include <cassert>

namespace sphinx::particles {

Index Remap::to(std::size_t i) const {
    if (!order_) return i < carried_ ? static_cast<Index>(i) : none;
    if (places_.empty()) {
        places_.assign(before_, none);
        for (std::size_t k = 0; k < carried_; ++k) places_[(*order_)[k]] = static_cast<Index>(k);
    }
    return places_[i];
}

RemapListeners::~RemapListeners() { assert(all_.empty() && "particles went before a listener"); }

void RemapListeners::tell(const Remap& remap) const {
    for (const RemapSubscription* subscription : all_) subscription->act_(remap);
}

RemapSubscription::RemapSubscription(RemapListeners& listeners,
                                     std::function<void(const Remap&)> act)
    : listeners_(&listeners), act_(std::move(act)) {
    listeners.all_.push_back(this);
}

RemapSubscription::~RemapSubscription() { std::erase(listeners_->all_, this); }

}  // namespace sphinx::particles
