// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace sphinx::io::hdf5 {

/// Checksum of metadata that the HDF5 format prescribes: "lookup3" (hashlittle with initial value
/// 0) by B. Jenkins, 2006, http://burtleburtle.net/bob/c/lookup3.c.
std::uint32_t metadataChecksum(std::string_view bytes);

}  // namespace sphinx::io::hdf5
