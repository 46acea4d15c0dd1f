// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rings.h"

#include <string>
#include <string_view>

namespace sphinx::geometry {

/// True when the text starts like well-known text (a word that names a geometry).
bool looksLikeWkt(std::string_view text);

/// The region of a POLYGON or MULTIPOLYGON in well-known text (OGC 06-103r4), two coordinates a
/// point. Polygons that touch or overlap are joined. Throws ShapeError with `path` and the line.
Rings readWkt(const std::string& path, std::string_view text);

}  // namespace sphinx::geometry
