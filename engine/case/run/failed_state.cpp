// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/run/failed_state.h"

namespace sphinx::run {

template <int Dim>
void writeFailedState(const bodies::World<Dim>& world, const Clock& clock,
                      const io::FrameParameters& parameters) {
    io::makeSubfolder(parameters.folder);
    std::vector<io::BodyFrames<Dim>> frames;
    for (const auto& body : world.bodies) {
        if (body->isObserver()) continue;
        io::BodyFrames<Dim> entry{body.get(), {}};
        for (const auto& field : body->particles.all())
            if (field->info().name != fields::position.name)
                entry.fields.emplace_back(field->info().name);
        frames.push_back(entry);
    }
    io::VtuOutput<Dim> output(parameters, frames);
    output.write(clock);
    output.sync();
}

template void writeFailedState(const bodies::World<2>&, const Clock&, const io::FrameParameters&);
template void writeFailedState(const bodies::World<3>&, const Clock&, const io::FrameParameters&);

}  // namespace sphinx::run
