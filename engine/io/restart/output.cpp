// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/restart/output.h"

#include <algorithm>
#include <memory>

namespace sphinx::io {

template <int Dim>
RestartOutput<Dim>::RestartOutput(RestartParameters parameters,
                                  std::vector<RestartBody<Dim>> bodies, StateTransfer state)
    : parameters_(std::move(parameters)), bodies_(std::move(bodies)), state_(std::move(state)) {
    parameters_.header.dimension = Dim;
}

template <int Dim>
std::vector<OutputFile> RestartOutput<Dim>::files() const {
    return {{"restart/" + parameters_.header.case_name + "_*.xml"}};
}

template <int Dim>
FileWork RestartOutput<Dim>::take(const Clock& clock) {
    RestartHeader header = parameters_.header;
    header.time = clock.time;
    header.steps = clock.steps;
    auto bodies = std::make_shared<std::vector<TakenBody>>();
    std::size_t bytes = 0;
    for (const RestartBody<Dim>& body : bodies_) {
        bodies->push_back(takeBody(body));
        for (const TakenField& field : bodies->back().fields) bytes += field.values.size();
    }
    return {[this, header, text = stateText(state_), bodies] { writeTaken(header, text, *bodies); },
            bytes};
}

template <int Dim>
void RestartOutput<Dim>::writeTaken(const RestartHeader& header, const std::string& state_text,
                                    const std::vector<TakenBody>& bodies) const {
    makeSubfolder(parameters_.folder);
    writeRestart(parameters_.folder / restartName(header), header, state_text, bodies,
                 parameters_.encoding);
    std::vector<Path> written = existing();
    for (std::size_t k = static_cast<std::size_t>(parameters_.keep); k < written.size(); ++k)
        removeFile(written[k]);
}

template <int Dim>
void RestartOutput<Dim>::resume(const Clock& clock) {
    for (const Path& path : existing())
        if (restartSteps(path) > clock.steps) removeFile(path);
    std::error_code error;
    std::vector<Path> unfinished;
    for (const auto& entry : std::filesystem::directory_iterator(parameters_.folder, error))
        if (entry.path() == temporaryName(entry.path().parent_path() / entry.path().stem()) &&
            restartSteps(entry.path().stem()) >= 0)
            unfinished.push_back(entry.path());
    for (const Path& path : unfinished) removeFile(path);
}

/// Restarts of this case in the folder, newest first.
template <int Dim>
std::vector<Path> RestartOutput<Dim>::existing() const {
    std::vector<Path> result;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(parameters_.folder, error)) {
        const std::int64_t steps = restartSteps(entry.path());
        const std::string name =
            parameters_.header.case_name + "_" + std::to_string(steps) + ".xml";
        if (steps >= 0 && entry.path().filename() == name) result.push_back(entry.path());
    }
    std::sort(result.begin(), result.end(),
              [](const Path& a, const Path& b) { return restartSteps(a) > restartSteps(b); });
    return result;
}

template class RestartOutput<2>;
template class RestartOutput<3>;

}  // namespace sphinx::io
