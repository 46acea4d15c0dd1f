// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../scene/stepper.h"
#include "core/parallel.h"

#include <catch2/catch.hpp>

#include <cstring>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

namespace {

/// Positions and deformation gradients after some steps of a body that is several ranges of a loop
/// large.
template <int Dim>
std::vector<double> moved(int threads) {
    setThreadCount(threads);
    Scene<Dim> scene;
    Body<Dim>& body =
        scene.elastic("block", scene.lattice(Dim == 2 ? 40 : 12, 0.2), {.damping = 0.01});
    ParticleSet<Dim>& p = body.particles;
    for (std::size_t i = 0; i < body.size(); ++i)
        p.vector(fields::velocity)[i] = scene.random.template vector<Dim>(1);
    Stepper<Dim> stepper(scene, body);
    for (int step = 0; step < 5; ++step) stepper.step(1e-4, {});
    setThreadCount(1);
    const double* x = p.position()[0].data();
    const double* F = p.matrix(fields::deformation_gradient)[0].data();
    std::vector<double> state(x, x + Dim * body.size());
    state.insert(state.end(), F, F + Dim * Dim * body.size());
    return state;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("threads move an elastic body by the same bits", "", ((int Dim), Dim), 2,
                       3) {
    const std::vector<double> one = moved<Dim>(1);
    for (const int threads : {2, 5}) {
        const std::vector<double> many = moved<Dim>(threads);
        CHECK(std::memcmp(one.data(), many.data(), sizeof(double) * one.size()) == 0);
    }
}
