// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/output.h"
#include "io/restart/restart.h"

namespace sphinx::io {

/// What a case says of its restarts.
struct RestartSettings {
    int keep = 2;  ///< newest files that stay; at least 1
    RestartEncoding encoding = RestartEncoding::zlib;
};

struct RestartParameters : RestartSettings {
    Path folder;           ///< made at the first write
    RestartHeader header;  ///< time and steps are filled in
};

/// Writes NAME_STEP.xml (NAME of the case) and removes what is older than the newest `keep`.
template <int Dim>
class RestartOutput final : public Output {
 public:
    /// `state` saves everything but the particle fields.
    RestartOutput(RestartParameters parameters, std::vector<RestartBody<Dim>> bodies,
                  StateTransfer state);

    std::vector<OutputFile> files() const override;
    FileWork take(const Clock& clock) override;
    /// Removes restarts of later steps than the resumed one, and unfinished ones.
    void resume(const Clock& clock) override;

 private:
    void writeTaken(const RestartHeader& header, const std::string& state_text,
                    const std::vector<TakenBody>& bodies) const;
    std::vector<Path> existing() const;

    RestartParameters parameters_;
    std::vector<RestartBody<Dim>> bodies_;
    StateTransfer state_;
};

}  // namespace sphinx::io
