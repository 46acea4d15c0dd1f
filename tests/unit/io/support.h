// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../temporary_folder.h"
#include "bodies/body.h"
#include "core/output.h"
#include "core/read_file.h"
#include "io/file/file.h"
#include "io/xml/archive.h"

#include <memory>
#include <string>
#include <vector>

namespace sphinx::test {

inline constexpr particles::FieldInfo strain{"strain", particles::Rank::matrix, unit::none,
                                             "a matrix, for tests"};

/// State of an output as a restart keeps it.
class SavedState {
 public:
    explicit SavedState(Output& output) {
        io::XmlSaveArchive archive;
        output.transfer(archive);
        xml_ = "<state>" + archive.xml() + "</state>";
    }
    void restore(Output& output) const {
        const TemporaryFolder folder;
        io::writeFileAtomically(folder / "state.xml", xml_);
        io::XmlReader reader(folder / "state.xml");
        io::XmlElement element;
        reader.next(element);
        io::XmlLoadArchive archive(reader, folder / "state.xml");
        output.transfer(archive);
    }

 private:
    std::string xml_;
};

/// Particles with velocity, pressure, mass and strain, all zero but mass.
template <int Dim>
std::unique_ptr<bodies::Body<Dim>> makeBody(const std::string& name, std::size_t particles) {
    auto body = std::make_unique<bodies::Body<Dim>>();
    body->name = name;
    body->particles.vector(fields::velocity);
    body->particles.scalar(fields::pressure);
    body->particles.scalar(fields::mass);
    body->particles.matrix(strain);
    body->particles.append(particles);
    for (std::size_t i = 0; i < particles; ++i) body->particles.scalar(fields::mass)[i] = 0.5;
    return body;
}

/// Values that a reader can compute from id and frame (tests/regression/readers/samples.py).
template <int Dim>
void setValues(bodies::Body<Dim>& body, int frame) {
    particles::ParticleSet<Dim>& particles = body.particles;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double id = static_cast<double>(particles.id()[i]);
        for (int k = 0; k < Dim; ++k) {
            particles.position()[i][k] = id / 7 + k + 0.25 * frame;
            particles.vector(fields::velocity)[i][k] = id / 3 - k * frame;
            for (int j = 0; j < Dim; ++j)
                particles.matrix(strain)[i](k, j) = id + 10 * k + j + 100 * frame;
        }
        particles.scalar(fields::pressure)[i] = 1 / (id + 1) + frame;
    }
}

}  // namespace sphinx::test
