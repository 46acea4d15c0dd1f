// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace sphinx::io {

/// Types of numbers in binary files.
enum class NumberType { float64, float32, int64 };

inline std::size_t bytesOf(NumberType type) { return type == NumberType::float32 ? 4 : 8; }

}  // namespace sphinx::io
