// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "particles/fields.h"
#include "particles/remap.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace sphinx::particles {

/// The particles of one body: a structure of arrays. `id` and `position` always exist, other fields
/// from the moment that someone requires them. A Field reference stays valid for the life of the
/// set; its data() may move when the number of particles grows.
template <int Dim>
class ParticleSet {
 public:
    ParticleSet();

    /// Own particles: those that this process steps.
    std::size_t size() const { return size_; }
    /// Own particles and, behind them, copies of those that other processes own: what arrays and
    /// neighbor lists reach. A run is one process today, so there are no copies.
    std::size_t held() const { return size_; }

    /// Appends n particles: ids continue, and every field has its initial value
    /// (FieldInfo::initial). `give`, called with the place of the first one, writes those that are
    /// given; without it they are zero.
    void append(std::size_t n, const std::function<void(std::size_t first)>& give = {});
    /// Drops the listed particles (ascending indices); the others keep their order.
    void remove(const std::vector<Index>& particles);
    /// Reorders all fields: new[k] = old[order[k]].
    void permute(const AlignedVector<Index>& order);
    /// Has exactly n new particles from now on, and the id counter; for reading a restart, which
    /// then writes ids and fields.
    void restore(std::size_t n, std::int64_t next_id);
    std::int64_t nextId() const { return next_id_; }
    /// Counts what gives particles other places in memory: append, remove, permute, restore.
    std::uint64_t arrangement() const { return arrangement_; }
    /// Whoever keeps indices or values of particles beside the fields listens to these.
    RemapListeners& remaps() { return remaps_; }

    /// The field, created with its initial value if it is not there yet. Asserts that rank and type
    /// agree.
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
    const Field<std::int64_t>& id() const { return *id_; }
    Field<Vec<Dim>>& position() { return *position_; }
    const Field<Vec<Dim>>& position() const { return *position_; }

    std::vector<const FieldBase*> all() const;
    std::size_t bytes() const;

 private:
    template <class T>
    Field<T>& typed(const FieldInfo& info, Rank rank);
    void begin(FieldBase& field, std::size_t first);
    void tell(const Remap& remap);

    std::size_t size_ = 0;
    std::int64_t next_id_ = 0;
    std::uint64_t arrangement_ = 0;
    std::vector<std::unique_ptr<FieldBase>> fields_;
    Field<std::int64_t>* id_ = nullptr;
    Field<Vec<Dim>>* position_ = nullptr;
    RemapListeners remaps_;
};

extern template class ParticleSet<2>;
extern template class ParticleSet<3>;

}  // namespace sphinx::particles
