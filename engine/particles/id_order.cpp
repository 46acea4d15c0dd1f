// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/id_order.h"

#include "core/parallel.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace sphinx::particles {

template <int Dim>
IdOrder::IdOrder(const ParticleSet<Dim>& particles) : size_(particles.size()) {
    const std::int64_t* ids = particles.id().data();
    if (std::is_sorted(ids, ids + size_)) return;
    places_.resize(size_);
    std::iota(places_.begin(), places_.end(), Index{0});
    std::sort(places_.begin(), places_.end(), [&](Index a, Index b) { return ids[a] < ids[b]; });
}

std::string_view IdOrder::bytes(const FieldBase& field, AlignedVector<char>& buffer) const {
    if (size_ == 0) return {};
    const auto* values = field.info().rank == Rank::integer
                             ? reinterpret_cast<const char*>(field.integers())
                             : reinterpret_cast<const char*>(field.numbers());
    const std::size_t record = 8 * static_cast<std::size_t>(field.components());
    if (places_.empty()) return {values, record * size_};
    buffer.resize(record * size_);
    parallelFor(size_, [&](std::size_t k) {
        std::memcpy(buffer.data() + record * k, values + record * places_[k], record);
    });
    return {buffer.data(), buffer.size()};
}

AlignedVector<char> IdOrder::copy(const FieldBase& field) const {
    AlignedVector<char> buffer;
    const std::string_view values = bytes(field, buffer);
    if (values.data() != buffer.data()) buffer.assign(values.begin(), values.end());
    return buffer;
}

template IdOrder::IdOrder(const ParticleSet<2>&);
template IdOrder::IdOrder(const ParticleSet<3>&);

}  // namespace sphinx::particles
