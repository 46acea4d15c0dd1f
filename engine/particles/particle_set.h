// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "particles/fields.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace sphinx {

/// The particles of one body: a structure of arrays. `id` and `position` always exist, other fields
/// from the moment that someone requires them. A Field reference stays valid for the life of the
/// set; its data() may move when the number of particles grows.
template <int Dim>
class ParticleSet {
 public:
    ParticleSet();

    std::size_t size() const { return size_; }

    /// Appends n particles: ids continue, every other field is zero.
    void append(std::size_t n);
    /// Drops the listed particles (ascending indices); the others keep their order.
    void remove(const std::vector<Index>& particles);
    /// Reorders all fields: new[k] = old[order[k]].
    void permute(const AlignedVector<Index>& order);
    /// Makes room for exactly n particles and the id counter; for reading a restart.
    void restore(std::size_t n, std::int64_t next_id);
    std::int64_t nextId() const { return next_id_; }
    /// Counts what gives particles other places in memory: append, remove, permute, restore.
    std::uint64_t arrangement() const { return arrangement_; }

    /// The field, created (zero) if it is not there yet. Asserts that rank and type agree.
    Field<double>& scalar(const FieldInfo& info);
    Field<Vec<Dim>>& vector(const FieldInfo& info);
    Field<Mat<Dim>>& matrix(const FieldInfo& info);
    Field<std::int64_t>& integer(const FieldInfo& info);
    /// The same, whatever its rank.
    FieldBase& require(const FieldInfo& info);
    /// The field if it exists, else nullptr.
    FieldBase* find(std::string_view name);
    const FieldBase* find(std::string_view name) const;
    /// A field that exists. Asserts so, and that the rank agrees.
    const Field<double>& scalar(const FieldInfo& info) const;
    const Field<Vec<Dim>>& vector(const FieldInfo& info) const;
    const Field<Mat<Dim>>& matrix(const FieldInfo& info) const;
    const FieldBase& require(const FieldInfo& info) const;

    Field<std::int64_t>& id() { return *id_; }
    Field<Vec<Dim>>& position() { return *position_; }
    const Field<Vec<Dim>>& position() const { return *position_; }

    std::vector<const FieldBase*> all() const;
    std::size_t bytes() const;

 private:
    template <class T>
    Field<T>& typed(const FieldInfo& info, Rank rank);

    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
    std::int64_t next_id_ = 0;
    std::uint64_t arrangement_ = 0;
    std::vector<std::unique_ptr<FieldBase>> fields_;
    Field<std::int64_t>* id_ = nullptr;
    Field<Vec<Dim>>* position_ = nullptr;
};

extern template class ParticleSet<2>;
extern template class ParticleSet<3>;

}  // namespace sphinx
