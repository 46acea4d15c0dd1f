// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sphinx::bodies {

/// What a body is to others; what each of them knows: roles.h.
enum class Role {
    observer,
    fluid,
    wall,  ///< rigid: stands still or moves as prescribed
    elastic,
};

}  // namespace sphinx::bodies
