// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/types.h"
#include "core/unit.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace sphinx {

enum class Rank { scalar, vector, matrix, integer };

/// What a field is: declared once in particles/fields.h, read by methods, outputs and restart.
struct FieldInfo {
    std::string_view name;  ///< as in case files and results
    Rank rank = Rank::scalar;
    Dimension unit{};
    std::string_view doc;
};

/// Values of one field for all particles of a body, without its type. Flat: components of one
/// particle stand together (matrix: column by column, Eigen's order).
class FieldBase {
 public:
    explicit FieldBase(const FieldInfo& info) : info_(&info) {}
    virtual ~FieldBase() = default;

    const FieldInfo& info() const { return *info_; }
    virtual int components() const = 0;
    /// For rank integer: the 64-bit ids; else nullptr.
    virtual std::int64_t* integers() { return nullptr; }
    virtual const std::int64_t* integers() const { return nullptr; }
    /// For every other rank: components() doubles per particle; else nullptr.
    virtual double* numbers() { return nullptr; }
    virtual const double* numbers() const { return nullptr; }

    virtual void resize(std::size_t n) = 0;
    virtual void setZero() = 0;
    /// new[k] = old[order[k]]
    virtual void permute(const AlignedVector<Index>& order) = 0;
    /// Moves particle `from` to place `to`.
    virtual void copy(std::size_t from, std::size_t to) = 0;
    virtual std::size_t bytes() const = 0;

 private:
    const FieldInfo* info_;
};

/// T is double, Vec<Dim>, Mat<Dim> or std::int64_t. New particles start at zero.
template <class T>
class Field final : public FieldBase {
 public:
    using FieldBase::FieldBase;

    T* data() { return values_.data(); }
    const T* data() const { return values_.data(); }
    T& operator[](std::size_t i) { return values_[i]; }
    const T& operator[](std::size_t i) const { return values_[i]; }
    std::size_t size() const { return values_.size(); }

    int components() const override { return static_cast<int>(sizeof(T) / 8); }
    std::int64_t* integers() override;
    const std::int64_t* integers() const override;
    double* numbers() override;
    const double* numbers() const override;
    void resize(std::size_t n) override;
    void setZero() override;
    void permute(const AlignedVector<Index>& order) override;
    void copy(std::size_t from, std::size_t to) override { values_[to] = values_[from]; }
    std::size_t bytes() const override {
        return (values_.capacity() + spare_.capacity()) * sizeof(T);
    }

 private:
    AlignedVector<T> values_;
    AlignedVector<T> spare_;  // permuted into, then swapped: sorting allocates once
};

}  // namespace sphinx
