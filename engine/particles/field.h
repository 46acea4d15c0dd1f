// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/types.h"
#include "core/unit.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace sphinx::particles {

enum class Rank { scalar, vector, matrix, integer };

struct FieldInfo;

/// What a new particle has in a field.
struct InitialValue {
    enum class Kind {
        none,   ///< nothing: it has to be written before it is read (in memory it is zero)
        given,  ///< what the one says who makes the particle: addParticles() fills in all of them
        zero,   ///< zero, which means something
        constant,  ///< `value`, in every component
        identity,  ///< of matrices
        same,      ///< the value of another field
    };
    Kind kind = Kind::none;
    const FieldInfo* other = nullptr;  ///< for Kind::same: of the same rank, its own is `given`
    double value = 0;                  ///< for Kind::constant; not of rank integer
};

namespace initial_value {
inline constexpr InitialValue none{};
inline constexpr InitialValue given{InitialValue::Kind::given};
inline constexpr InitialValue zero{InitialValue::Kind::zero};
constexpr InitialValue constant(double value) {
    return {InitialValue::Kind::constant, nullptr, value};
}
inline constexpr InitialValue identity{InitialValue::Kind::identity};
constexpr InitialValue sameAs(const FieldInfo& other) { return {InitialValue::Kind::same, &other}; }
}  // namespace initial_value

enum class FieldKind {
    state,    ///< the run goes on from it
    derived,  ///< follows from the state, and is computed for outputs only
};

/// What a field is: declared once in particles/fields.h, read by methods, outputs and restart.
struct FieldInfo {
    std::string_view name;  ///< as in case files and results
    Rank rank = Rank::scalar;
    Dimension unit{};
    std::string_view doc;
    InitialValue initial = initial_value::none;
    FieldKind kind = FieldKind::state;

    bool hasInitialValue() const { return initial.kind != InitialValue::Kind::none; }
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

    /// What is added is zero.
    virtual void resize(std::size_t n) = 0;
    /// Gives the particles from `first` on their initial value where it is not zero. `other`: the
    /// field named by it, with its values.
    virtual void begin(std::size_t first, const FieldBase* other) = 0;
    virtual void setZero() = 0;
    /// new[k] = old[order[k]]
    virtual void permute(const AlignedVector<Index>& order) = 0;
    /// The same for an ascending choice of the particles; the others go.
    virtual void keep(const AlignedVector<Index>& kept) = 0;
    virtual std::size_t bytes() const = 0;

 private:
    const FieldInfo* info_;
};

/// T is double, Vec<Dim>, Mat<Dim> or std::int64_t.
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
    void begin(std::size_t first, const FieldBase* other) override;
    void setZero() override;
    void permute(const AlignedVector<Index>& order) override;
    void keep(const AlignedVector<Index>& kept) override;
    std::size_t bytes() const override {
        return (values_.capacity() + spare_.capacity()) * sizeof(T);
    }

 private:
    AlignedVector<T> values_;
    AlignedVector<T> spare_;  // permuted into, then swapped: sorting allocates once
};

}  // namespace sphinx::particles
