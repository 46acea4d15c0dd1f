// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/field.h"

#include "core/parallel.h"

#include <algorithm>

namespace sphinx::particles {
namespace {

template <class T>
T zero() {
    if constexpr (std::is_arithmetic_v<T>)
        return T{0};
    else
        return T::Zero();
}

/// Of const values or others.
template <class T, class Values>
auto numbersOf(Values& values) {
    if constexpr (std::is_same_v<T, double>)
        return values.data();
    else if constexpr (std::is_same_v<T, std::int64_t>)
        return nullptr;
    else
        return values.empty() ? nullptr : values.data()->data();
}

template <class T>
constexpr bool isSquare = false;
template <int Dim>
constexpr bool isSquare<Mat<Dim>> = true;

}  // namespace

template <class T>
std::int64_t* Field<T>::integers() {
    if constexpr (std::is_same_v<T, std::int64_t>)
        return values_.data();
    else
        return nullptr;
}
template <class T>
const std::int64_t* Field<T>::integers() const {
    if constexpr (std::is_same_v<T, std::int64_t>)
        return values_.data();
    else
        return nullptr;
}

template <class T>
double* Field<T>::numbers() {
    return numbersOf<T>(values_);
}
template <class T>
const double* Field<T>::numbers() const {
    return numbersOf<T>(values_);
}

template <class T>
void Field<T>::resize(std::size_t n) {
    const std::size_t old = values_.size();
    values_.resize(n);
    for (std::size_t i = old; i < n; ++i) values_[i] = zero<T>();
}

template <class T>
void Field<T>::begin(std::size_t first, const FieldBase* other) {
    if (info().initial.kind == InitialValue::Kind::same) {
        const auto& same = static_cast<const Field<T>&>(*other);
        std::copy(same.values_.begin() + static_cast<std::ptrdiff_t>(first), same.values_.end(),
                  values_.begin() + static_cast<std::ptrdiff_t>(first));
    }
    if constexpr (!std::is_integral_v<T>)
        if (info().initial.kind == InitialValue::Kind::constant)
            std::fill(numbers() + first * static_cast<std::size_t>(components()),
                      numbers() + values_.size() * static_cast<std::size_t>(components()),
                      info().initial.value);
    if constexpr (isSquare<T>)
        if (info().initial.kind == InitialValue::Kind::identity)
            for (std::size_t i = first; i < values_.size(); ++i) values_[i].setIdentity();
}

template <class T>
void Field<T>::setZero() {
    parallelRanges(values_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) values_[i] = zero<T>();
    });
}

template <class T>
void Field<T>::permute(const AlignedVector<Index>& order) {
    spare_.resize(values_.size());
    parallelRanges(order.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) spare_[k] = values_[order[k]];
    });
    values_.swap(spare_);
}

template <class T>
void Field<T>::keep(const AlignedVector<Index>& kept) {
    for (std::size_t k = 0; k < kept.size(); ++k) values_[k] = values_[kept[k]];
    values_.resize(kept.size());
}

template class Field<double>;
template class Field<std::int64_t>;
template class Field<Vec<2>>;
template class Field<Vec<3>>;
template class Field<Mat<2>>;
template class Field<Mat<3>>;

}  // namespace sphinx::particles
