// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"
#include "core/archive.h"
#include "io/file/file.h"
#include "io/file/provenance.h"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sphinx::io {

/// Version of the restart format (schemas/restart.xsd, schemas/CHANGES.md).
inline constexpr std::int64_t restart_format = 2;

/// What a restart says about itself.
struct RestartHeader {
    std::string program;  ///< version of the program that wrote it
    std::string commit;   ///< and its commit
    std::string case_name;
    std::string digest;            ///< of the part of the case that the physics depends on
    std::string case_text;         ///< the resolved case
    std::string instruction_set;   ///< a run on another one may give other bits
    Provenance build_and_machine;  ///< compiler, flags, processor, threads; written, not read
    int dimension = 2;
    double time = 0;  ///< case units
    std::int64_t steps = 0;
};

enum class RestartEncoding {
    zlib,  ///< values as base64 of deflated bytes
    text,  ///< shortest decimals that read back as the same bits
};

/// A body and its state fields: id and position always, the others by name.
template <int Dim>
struct RestartBody {
    bodies::Body<Dim>* body = nullptr;
    std::vector<std::string> fields;
};

/// Small state for both directions.
using StateTransfer = std::function<void(Archive&)>;

/// Writes a restart: complete or not at all. Particle data go to the file in pieces of 65536
/// values, each with a checksum, particles by ascending id; the end carries a checksum of the whole
/// file.
template <int Dim>
void writeRestart(const Path& path, const RestartHeader& header, const StateTransfer& state,
                  const std::vector<RestartBody<Dim>>& bodies, RestartEncoding encoding);
/// The same with a state that was taken before.
template <int Dim>
void writeRestart(const Path& path, const RestartHeader& header, const std::string& state_text,
                  const std::vector<RestartBody<Dim>>& bodies, RestartEncoding encoding);

/// The fields of a body as a restart has them, in memory of their own.
struct TakenField {
    particles::FieldInfo info;
    int components = 1;
    AlignedVector<char> values;  ///< 8 bytes each, particles by ascending id
};
struct TakenBody {
    std::string name;
    std::size_t particles = 0;
    std::int64_t next_id = 0;
    std::vector<TakenField> fields;  ///< id, position, then the others
};
template <int Dim>
TakenBody takeBody(const RestartBody<Dim>& body);
/// The same with bodies that were taken before, too.
void writeRestart(const Path& path, const RestartHeader& header, const std::string& state_text,
                  const std::vector<TakenBody>& bodies, RestartEncoding encoding);

/// What a restart says of the state.
std::string stateText(const StateTransfer& state);
/// NAME_STEPS.xml
std::string restartName(const RestartHeader& header);

/// Throws FileError with one line that says why, unless the file is exactly as it was written.
void verifyRestart(const Path& path);

/// Header of a verified restart. Throws FileError.
RestartHeader readRestartHeader(const Path& path);

/// Verifies the file, then brings bodies (number of particles, ids, fields) and state to what it
/// holds. Bodies and fields of the file that are not asked for are ignored. Throws FileError.
template <int Dim>
void readRestart(const Path& path, const StateTransfer& state,
                 const std::vector<RestartBody<Dim>>& bodies);

struct RestartSearch {
    Path found;                                         ///< empty: none
    std::vector<std::pair<Path, std::string>> skipped;  ///< newer ones, and why
};
/// The restart with the most steps, in a folder, that is not damaged.
RestartSearch findNewestValid(const Path& folder);

/// Number of steps in the name of a restart file, or -1.
std::int64_t restartSteps(const Path& path);

/// The last bytes of a restart whose other bytes have this checksum.
std::string restartEnd(std::uint32_t checksum);

}  // namespace sphinx::io
