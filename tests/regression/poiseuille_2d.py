# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Start-up of plane Poiseuille flow against its closed form."""

import channel

channel.main("poiseuille_2d", "poiseuille_unit.csv", channel.poiseuille, "Start-up of plane Poiseuille flow, spacing 1/20")
