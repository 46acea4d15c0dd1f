// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/solid/deformation.h"

#include "../scene/scene.h"
#include "dynamics/solid/internal_energy.h"

#include <catch2/catch.hpp>

#include <Eigen/LU>
#include <deque>
#include <numbers>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

namespace {

constexpr double exact = 1e-10;

/// Disordered, and its deformation can be asked for: one body, or the same cut in the middle into
/// two that are bonded.
template <int Dim>
struct Patch {
    Scene<Dim> scene;
    std::vector<Body<Dim>*> bodies;
    std::deque<solid::Deformation<Dim>> deformations;

    explicit Patch(bool bonded, bool hourglass_control = true, double damping = 0) {
        const int n = Dim == 2 ? 10 : 6;
        std::vector<Vec<Dim>> left, right;
        for (const Vec<Dim>& x : scene.lattice(n, 0.2))
            (bonded && x[0] > 0.5 * spacing * n ? right : left).push_back(x);
        bodies.push_back(&scene.elastic("left", left, {.damping = damping}));
        if (bonded) {
            bodies.push_back(&scene.elastic("right", right, {.damping = damping}));
            bodies[0]->bonded = {bodies[1]};
            bodies[1]->bonded = {bodies[0]};
        }
        for (Body<Dim>* body : bodies)
            deformations.emplace_back(scene.context, *body, hourglass_control);
        for (auto& deformation : deformations) deformation.announce();
        for (auto& deformation : deformations) deformation.prepare();
    }
    /// Particles at place(R) with the velocity velocity(R); F and its rate from there.
    template <class Place, class Velocity>
    void set(Place&& place, Velocity&& velocity) {
        each([&](Body<Dim>& body, std::size_t i) {
            const Vec<Dim>& R = body.particles.vector(fields::initial_position)[i];
            body.particles.position()[i] = place(R);
            body.particles.vector(fields::velocity)[i] = velocity(R);
        });
        for (auto& deformation : deformations) deformation.initialize();
    }
    void findStress() {
        for (auto& deformation : deformations) deformation.firstHalf({});
    }
    template <class F>
    void each(F&& f) {
        for (Body<Dim>* body : bodies)
            for (std::size_t i = 0; i < body->size(); ++i) f(*body, i);
    }
    double energy() {
        double sum = 0;
        for (Body<Dim>* body : bodies) sum += solid::internalEnergy(*body, scene.relations);
        return sum;
    }
    Vec<Dim> force(std::size_t b, std::size_t i) {
        const Group group = groupOf(i / lane_count, bodies[b]->size());
        return bodies[b]->particles.scalar(fields::volume)[i] *
               lane(deformations[b].stressDivergence(group), i % lane_count);
    }
    double volume() {
        double sum = 0;
        each([&](Body<Dim>& body, std::size_t i) {
            sum += body.particles.scalar(fields::volume)[i];
        });
        return sum;
    }
};

template <int Dim>
Vec<Dim> atRest(const Vec<Dim>&) {
    return Vec<Dim>::Zero();
}

/// Largest entry.
template <int Dim>
double size(const Mat<Dim>& m) {
    return m.cwiseAbs().maxCoeff();
}

/// S of the law at that F.
template <int Dim>
Mat<Dim> stressAt(const Body<Dim>& body, const Mat<Dim>& F) {
    const auto& law = dynamic_cast<const materials::SaintVenantKirchhoff&>(*body.material());
    return law.stress<Dim>(Mat<Dim>(F.transpose() * F), {});
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("F of an affine map is exact where neighbors are irregular", "",
                       ((int Dim), Dim), 2, 3) {
    const bool bonded = GENERATE(false, true);
    Patch<Dim> patch(bonded);
    for (int k = 0; k < 20; ++k) {
        const Mat<Dim> A = Mat<Dim>::Identity() + patch.scene.random.template matrix<Dim>(0.3);
        const Mat<Dim> rate = patch.scene.random.template matrix<Dim>(5);
        const Vec<Dim> shift = patch.scene.random.template vector<Dim>(3);
        patch.set([&](const Vec<Dim>& R) -> Vec<Dim> { return A * R + shift; },
                  [&](const Vec<Dim>& R) -> Vec<Dim> { return rate * R - shift; });
        double off = 0;
        double rate_off = 0;
        double uncorrected_off = 0;
        patch.each([&](Body<Dim>& body, std::size_t i) {
            const Mat<Dim>& F = body.particles.matrix(fields::deformation_gradient)[i];
            const Mat<Dim>& B = body.particles.matrix(fields::correction_matrix)[i];
            off = std::max(off, size<Dim>(F - A));
            rate_off = std::max(
                rate_off, size<Dim>(body.particles.matrix(fields::deformation_rate)[i] - rate));
            uncorrected_off = std::max(uncorrected_off, size<Dim>(F * B.inverse() - A));
        });
        CHECK(off < exact);
        CHECK(rate_off < exact);
        CHECK(uncorrected_off > 0.2);  // at the surface half of the neighbors are missing

        // The second half finds the same rate, and F moves with it.
        for (auto& deformation : patch.deformations) deformation.secondHalf(0.01);
        patch.each([&](Body<Dim>& body, std::size_t i) {
            const Mat<Dim>& F = body.particles.matrix(fields::deformation_gradient)[i];
            CHECK(size<Dim>(F - A - 0.005 * rate) < exact);
        });
    }
}

TEMPLATE_TEST_CASE_SIG("a body that is only turned has no stress, force or energy", "",
                       ((int Dim), Dim), 2, 3) {
    const bool bonded = GENERATE(false, true);
    const bool control = GENERATE(false, true);
    Patch<Dim> patch(bonded, control, 3);
    Random& random = patch.scene.random;
    for (int degrees = 0; degrees <= 360; degrees += 15) {
        const Mat<Dim> Q = rotation<Dim>(degrees * std::numbers::pi / 180, random);
        const Mat<Dim> part = random.template matrix<Dim>(2);
        const Mat<Dim> spin = part - part.transpose();
        const Vec<Dim> shift = random.template vector<Dim>(1);
        patch.set([&](const Vec<Dim>& R) -> Vec<Dim> { return Q * R + shift; },
                  [&](const Vec<Dim>& R) -> Vec<Dim> { return spin * Q * R + shift; });
        patch.findStress();
        double stress = 0;
        double uncorrected = 0;
        patch.each([&](Body<Dim>& body, std::size_t i) {
            const Mat<Dim>& F = body.particles.matrix(fields::deformation_gradient)[i];
            const Mat<Dim>& B = body.particles.matrix(fields::correction_matrix)[i];
            // T = P B^T, and the part that the hourglass control adds
            const Mat<Dim>& T = body.particles.matrix(fields::corrected_stress)[i];
            const Mat<Dim> P = (T + body.elastic().hourglass_modulus * F) * B.transpose().inverse();
            stress = std::max(stress, size<Dim>(P));
            uncorrected = std::max(uncorrected, size<Dim>(stressAt<Dim>(body, F * B.inverse())));
        });
        double force = 0;
        for (std::size_t b = 0; b < patch.bodies.size(); ++b)
            for (std::size_t i = 0; i < patch.bodies[b]->size(); ++i)
                force = std::max(force, patch.force(b, i).norm());
        CHECK(stress / youngs_modulus < exact);
        CHECK(force / (youngs_modulus * std::pow(spacing, Dim - 1)) < exact);
        CHECK(patch.energy() / (youngs_modulus * patch.volume()) < 1e-20);
        CHECK(uncorrected / youngs_modulus > 0.1);
    }
}

TEMPLATE_TEST_CASE_SIG("stress and density of an affine map", "", ((int Dim), Dim), 2, 3) {
    const bool bonded = GENERATE(false, true);
    Patch<Dim> patch(bonded);
    for (int k = 0; k < 5; ++k) {
        const Mat<Dim> A = Mat<Dim>::Identity() + patch.scene.random.template matrix<Dim>(0.2);
        patch.set([&](const Vec<Dim>& R) -> Vec<Dim> { return A * R; }, atRest<Dim>);
        patch.findStress();
        const Mat<Dim> P = A * stressAt<Dim>(*patch.bodies[0], A);
        patch.each([&](Body<Dim>& body, std::size_t i) {
            const Mat<Dim>& B = body.particles.matrix(fields::correction_matrix)[i];
            const Mat<Dim> T = body.particles.matrix(fields::corrected_stress)[i];
            const Mat<Dim> expected = P * B.transpose() - body.elastic().hourglass_modulus * A;
            CHECK(size<Dim>(T - expected) / youngs_modulus < exact);
            CHECK(body.particles.scalar(fields::density)[i] ==
                  Approx(density / A.determinant()).epsilon(exact));
        });
        // Per volume: W of the uniform state, without anything that the control would add.
        const auto& law =
            dynamic_cast<const materials::SaintVenantKirchhoff&>(*patch.bodies[0]->material());
        const double W = law.energy<Dim>(A.transpose() * A, {});
        CHECK(patch.energy() == Approx(W * patch.volume()).epsilon(exact));
    }
}

TEMPLATE_TEST_CASE_SIG("the forces are minus the derivatives of the energy", "", ((int Dim), Dim),
                       2, 3) {
    const bool bonded = GENERATE(false, true);
    const bool control = GENERATE(false, true);
    Patch<Dim> patch(bonded, control);
    Random& random = patch.scene.random;
    patch.set(
        [&](const Vec<Dim>& R) -> Vec<Dim> {
            return R + random.template vector<Dim>(0.05 * spacing) + 0.1 * R[0] * R;
        },
        atRest<Dim>);
    patch.findStress();
    const double step = 1e-4 * spacing;
    const auto energyAt = [&](Body<Dim>& body, std::size_t i, int c, double by) {
        double& x = body.particles.position()[i][c];
        const double before = x;
        x += by;
        for (auto& deformation : patch.deformations) deformation.initialize();
        const double energy = patch.energy();
        x = before;
        return energy;
    };
    double largest = 0;
    for (std::size_t b = 0; b < patch.bodies.size(); ++b)
        for (std::size_t i = 0; i < patch.bodies[b]->size(); ++i)
            largest = std::max(largest, patch.force(b, i).norm());
    REQUIRE(largest > 0.01 * youngs_modulus * std::pow(spacing, Dim - 1));
    for (std::size_t b = 0; b < patch.bodies.size(); ++b) {
        Body<Dim>& body = *patch.bodies[b];
        for (std::size_t i = 0; i < body.size(); i += 7) {
            const Vec<Dim> force = patch.force(b, i);
            for (int c = 0; c < Dim; ++c) {
                const double slope =
                    (energyAt(body, i, c, step) - energyAt(body, i, c, -step)) / (2 * step);
                CHECK(std::abs(force[c] + slope) < 1e-6 * largest);
            }
        }
    }
}

TEMPLATE_TEST_CASE_SIG("normals turn with the body and stay normal to its surface", "",
                       ((int Dim), Dim), 2, 3) {
    Patch<Dim> patch(false);
    Body<Dim>& body = *patch.bodies[0];
    Random& random = patch.scene.random;
    auto& normal = body.particles.vector(fields::normal);
    auto& initial = body.particles.vector(fields::initial_normal);
    for (std::size_t i = 0; i < body.size(); ++i)
        initial[i] = random.template vector<Dim>(1).normalized();
    const auto update = patch.scene.method("type: solid.update_normals, body: " + body.name);

    const Mat<Dim> Q = rotation<Dim>(2.5, random);
    const Mat<Dim> A = Q * (Mat<Dim>::Identity() + random.template matrix<Dim>(0.3));
    for (const Mat<Dim>& F : {Q, A}) {
        patch.set([&](const Vec<Dim>& R) -> Vec<Dim> { return F * R; }, atRest<Dim>);
        update.run({});
        for (std::size_t i = 0; i < body.size(); ++i) {
            CHECK(normal[i].norm() == Approx(1).epsilon(1e-14));
            CHECK(normal[i].dot(F * initial[i]) > 0);
            if (F == Q) CHECK((normal[i] - Q * initial[i]).norm() < exact);
            // A line in the surface at the start lies in the surface that it has become.
            Vec<Dim> line = random.template vector<Dim>(1);
            line -= line.dot(initial[i]) * initial[i];
            CHECK(std::abs(normal[i].dot(F * line)) < exact);
        }
    }
}

TEST_CASE("the damping of the material can be left out") {
    const auto stressAt = [](double eta, bool acts) {
        Patch<2> patch(false, true, eta);
        patch.set([](const Vec<2>& R) -> Vec<2> { return 1.1 * R; },
                  [](const Vec<2>& R) -> Vec<2> {
                      return {R[1], 3 * R[0]};
                  });
        patch.deformations[0].firstHalf({}, acts);
        return patch.bodies[0]->particles.matrix(fields::corrected_stress)[7];
    };
    const Mat<2> undamped = stressAt(0, true);
    CHECK(stressAt(20, false) == undamped);
    CHECK((stressAt(20, true) - undamped).norm() > 1);
}
