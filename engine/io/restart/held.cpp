// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/restart/held.h"

#include "core/parallel.h"

#include <algorithm>
#include <utility>

namespace sphinx::io {
namespace {

constexpr double part_of_time = 0.005;
constexpr double free_seconds = 0.02;

template <class T>
void copyRecords(const T* from, T* to, std::size_t particles, std::size_t components) {
    parallelRanges(
        particles,
        [&](std::size_t begin, std::size_t end) {
            std::copy(from + components * begin, from + components * end, to + components * begin);
        },
        std::size_t{1} << 14);
}

void copyValues(const particles::FieldBase& from, particles::FieldBase& to, std::size_t particles) {
    const auto components = static_cast<std::size_t>(from.components());
    if (from.integers())
        copyRecords(from.integers(), to.integers(), particles, components);
    else
        copyRecords(from.numbers(), to.numbers(), particles, components);
}

}  // namespace

template <int Dim>
HeldRestart<Dim>::HeldRestart(Path folder, RestartHeader header,
                              std::vector<RestartBody<Dim>> bodies, StateTransfer state)
    : folder_(std::move(folder)),
      header_(std::move(header)),
      bodies_(std::move(bodies)),
      state_(std::move(state)) {
    for (const RestartBody<Dim>& from : bodies_) {
        own_.push_back(std::make_unique<bodies::Body<Dim>>());
        own_.back()->name = from.body->name;
        copies_.push_back({own_.back().get(), from.fields});
    }
}

template <int Dim>
void HeldRestart<Dim>::copy(const RestartBody<Dim>& from, RestartBody<Dim>& to) {
    const particles::ParticleSet<Dim>& source = from.body->particles;
    particles::ParticleSet<Dim>& target = to.body->particles;
    for (const std::string& name : from.fields) target.require(source.find(name)->info());
    if (target.size() != source.size() || target.nextId() != source.nextId())
        target.restore(source.size(), source.nextId());
    copyValues(source.id(), target.id(), source.size());
    copyValues(source.position(), target.position(), source.size());
    for (const std::string& name : from.fields)
        copyValues(*source.find(name), *target.find(name), source.size());
}

template <int Dim>
void HeldRestart<Dim>::hold(const Clock& clock) {
    if (holds_ && spent_ + cost_ > free_seconds + part_of_time * running_.seconds()) return;
    const Timer timer;
    state_text_ = stateText(state_);
    for (std::size_t k = 0; k < bodies_.size(); ++k) copy(bodies_[k], copies_[k]);
    header_.time = clock.time;
    header_.steps = clock.steps;
    holds_ = true;
    cost_ = timer.seconds();
    spent_ += cost_;
}

template <int Dim>
std::optional<double> HeldRestart<Dim>::write() const {
    if (!holds_) return {};
    if (const Path newest = findNewestValid(folder_).found; !newest.empty())
        if (const RestartHeader there = readRestartHeader(newest); there.steps >= header_.steps)
            return there.time;
    makeSubfolder(folder_);
    writeRestart(folder_ / restartName(header_), header_, state_text_, copies_,
                 RestartEncoding::zlib);
    return header_.time;
}

template class HeldRestart<2>;
template class HeldRestart<3>;

}  // namespace sphinx::io
