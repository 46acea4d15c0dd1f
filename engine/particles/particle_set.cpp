// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/particle_set.h"

#include <cassert>

namespace sphinx::particles {

template <int Dim>
ParticleSet<Dim>::ParticleSet() {
    id_ = &integer(fields::id);
    position_ = &vector(fields::position);
}

template <int Dim>
void ParticleSet<Dim>::tell(const Remap& remap) {
    ++arrangement_;
    remaps_.tell(remap);
}

template <int Dim>
void ParticleSet<Dim>::begin(FieldBase& field, std::size_t first) {
    const FieldInfo* other = field.info().initial.other;
    field.begin(first, other ? &require(*other) : nullptr);
}

template <int Dim>
void ParticleSet<Dim>::append(std::size_t n, const std::function<void(std::size_t)>& give) {
    const std::size_t old = size_;
    size_ += n;
    for (auto& field : fields_) field->resize(size_);
    for (std::size_t i = old; i < size_; ++i) (*id_)[i] = next_id_++;
    if (give) give(old);
    for (auto& field : fields_) begin(*field, old);
    tell(Remap(old, old, size_));
}

template <int Dim>
void ParticleSet<Dim>::remove(const std::vector<Index>& particles) {
    if (particles.empty()) return;
    AlignedVector<Index> kept;
    kept.reserve(size_);
    auto next = particles.begin();
    for (std::size_t i = 0; i < size_; ++i) {
        if (next != particles.end() && *next == i)
            ++next;
        else
            kept.push_back(static_cast<Index>(i));
    }
    assert(next == particles.end() && "the particles to remove are not in order");
    const std::size_t old = size_;
    size_ = kept.size();
    for (auto& field : fields_) field->keep(kept);
    tell(Remap(kept, old, size_));
}

template <int Dim>
void ParticleSet<Dim>::permute(const AlignedVector<Index>& order) {
    assert(order.size() == size_);
    for (auto& field : fields_) field->permute(order);
    tell(Remap(order, size_, size_));
}

template <int Dim>
void ParticleSet<Dim>::restore(std::size_t n, std::int64_t next_id) {
    const std::size_t old = size_;
    size_ = n;
    next_id_ = next_id;
    for (auto& field : fields_) field->resize(0);
    for (auto& field : fields_) field->resize(size_);
    for (auto& field : fields_) begin(*field, 0);
    tell(Remap(std::size_t{0}, old, size_));
}

template <int Dim>
FieldBase* ParticleSet<Dim>::find(std::string_view name) {
    for (const auto& field : fields_)
        if (field->info().name == name) return field.get();
    return nullptr;
}
template <int Dim>
const FieldBase* ParticleSet<Dim>::find(std::string_view name) const {
    for (const auto& field : fields_)
        if (field->info().name == name) return field.get();
    return nullptr;
}

template <int Dim>
std::vector<const FieldBase*> ParticleSet<Dim>::all() const {
    std::vector<const FieldBase*> fields;
    for (const auto& field : fields_) fields.push_back(field.get());
    return fields;
}

template <int Dim>
template <class T>
Field<T>& ParticleSet<Dim>::typed(const FieldInfo& info, [[maybe_unused]] Rank rank) {
    assert(info.rank == rank);
    if (FieldBase* existing = find(info.name)) return static_cast<Field<T>&>(*existing);
    auto field = std::make_unique<Field<T>>(info);
    field->resize(size_);
    begin(*field, 0);
    Field<T>& result = *field;
    fields_.push_back(std::move(field));
    return result;
}

template <int Dim>
Field<double>& ParticleSet<Dim>::scalar(const FieldInfo& info) {
    return typed<double>(info, Rank::scalar);
}
template <int Dim>
Field<Vec<Dim>>& ParticleSet<Dim>::vector(const FieldInfo& info) {
    return typed<Vec<Dim>>(info, Rank::vector);
}
template <int Dim>
Field<Mat<Dim>>& ParticleSet<Dim>::matrix(const FieldInfo& info) {
    return typed<Mat<Dim>>(info, Rank::matrix);
}
template <int Dim>
Field<std::int64_t>& ParticleSet<Dim>::integer(const FieldInfo& info) {
    return typed<std::int64_t>(info, Rank::integer);
}

template <int Dim>
const FieldBase& ParticleSet<Dim>::require(const FieldInfo& info) const {
    const FieldBase* field = find(info.name);
    assert(field && field->info().rank == info.rank);
    return *field;
}
template <int Dim>
const Field<double>& ParticleSet<Dim>::scalar(const FieldInfo& info) const {
    assert(info.rank == Rank::scalar);
    return static_cast<const Field<double>&>(require(info));
}
template <int Dim>
const Field<Vec<Dim>>& ParticleSet<Dim>::vector(const FieldInfo& info) const {
    assert(info.rank == Rank::vector);
    return static_cast<const Field<Vec<Dim>>&>(require(info));
}
template <int Dim>
const Field<Mat<Dim>>& ParticleSet<Dim>::matrix(const FieldInfo& info) const {
    assert(info.rank == Rank::matrix);
    return static_cast<const Field<Mat<Dim>>&>(require(info));
}

template <int Dim>
FieldBase& ParticleSet<Dim>::require(const FieldInfo& info) {
    switch (info.rank) {
        case Rank::scalar: return scalar(info);
        case Rank::vector: return vector(info);
        case Rank::matrix: return matrix(info);
        case Rank::integer: break;
    }
    return integer(info);
}

template <int Dim>
std::size_t ParticleSet<Dim>::bytes() const {
    std::size_t sum = 0;
    for (const auto& field : fields_) sum += field->bytes();
    return sum;
}

template class ParticleSet<2>;
template class ParticleSet<3>;

}  // namespace sphinx::particles
