# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Start-up of plane Couette flow against its closed form."""

import channel

channel.main("couette_2d", "couette_unit.csv", channel.couette, "Start-up of plane Couette flow, spacing 1/20")
