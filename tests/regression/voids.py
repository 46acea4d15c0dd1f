# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Whether the particles of a flow leave voids."""

import numpy as np


def grid(cells):
    """Points in the middle of the cells of the unit square."""
    axis = (np.arange(cells) + 0.5) / cells
    return np.stack(np.meshgrid(axis, axis), -1).reshape(-1, 2)


def largest_hole(points, position):
    """Distance from its nearest particle of the point that is farthest from any, in a unit square that is periodic both ways."""
    worst = 0.0
    for chunk in np.array_split(points, max(1, len(points) * len(position) // 4_000_000)):
        d = np.abs(chunk[:, None] - position[None, :, :2])
        d = np.minimum(d, 1 - d)
        worst = max(worst, np.sqrt((d**2).sum(-1).min(1).max()))
    return worst
