// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/field.h"

#include "core/parallel.h"

namespace sphinx {
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

template class Field<double>;
template class Field<std::int64_t>;
template class Field<Vec<2>>;
template class Field<Vec<3>>;
template class Field<Mat<2>>;
template class Field<Mat<3>>;

}  // namespace sphinx
