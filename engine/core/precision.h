// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sphinx {

/// Of the numbers in which the terms of pairs are computed.
enum class Precision {
    single,  ///< float, of exact differences of places
    full,    ///< double
};

/// f<float>() or f<double>().
template <class F>
decltype(auto) withPrecision(Precision precision, F&& f) {
    if (precision == Precision::single) return f.template operator()<float>();
    return f.template operator()<double>();
}

}  // namespace sphinx
