// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/implicit_viscosity.h"

#include "core/errors.h"
#include "core/sum_all.h"
#include "dynamics/fluid/largest.h"
#include "dynamics/fluid/viscous_bound.h"
#include "dynamics/fluid/viscous_load.h"
#include "dynamics/methods.h"
#include "dynamics/pair_loop.h"
#include "particles/side_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sphinx::dynamics::fluid {
namespace {

/// Fluid at rest needs no better: the rms of z is no less than the tolerance times that part of c0.
constexpr double least_speed = 1e-6;

template <int Dim>
class ImplicitViscosity final : public ViscousLoad<Dim> {
 public:
    ImplicitViscosity(Context<Dim>& context, const ImplicitViscosityParameters& p)
        : ViscousLoad<Dim>(context, p.force()),
          tolerance_(p.tolerance),
          most_iterations_(p.most_iterations),
          solved_(body_->particles, [this](std::size_t i) { return velocity_[i]; }) {}

    void announce() override {
        const ViscousBound bound = viscousBound<Dim>(*body_, form_, this->wallBodies());
        auto& viscous = body_->fluid().viscous;
        viscous.implicit = true;
        viscous.implicit_walls += body_->fluid().material->viscosity() * bound.walls;
    }
    void run(const Clock& clock) {
        this->actedAt(clock.time);
        if (body_->size() == 0) return;
        withForm(form_, [&]<ViscousForm F>() {
            findWalls<F>();
            withPrecision(around_.own().precision(), [&]<class Real>() { solve<F, Real>(clock); });
        });
        ++body_->fluid().kicks;
    }
    std::int64_t iterations() const override { return iterations_; }
    void transfer(Archive& archive) override {
        ViscousLoad<Dim>::transfer(archive);
        solved_.transfer(archive, "velocity");
    }

 private:
    using Base = ViscousLoad<Dim>;
    using Base::around_, Base::body_, Base::cell_, Base::factor_, Base::form_, Base::largest_,
        Base::mass_, Base::nearest_, Base::records_, Base::sums_, Base::velocity_, Base::volume_;

    const Vec<Dim>* felt() const override {
        return std::isfinite(this->lastTime()) ? solved_.data() : velocity_.data();
    }
    template <ViscousForm F>
    void findWalls();
    /// f(group, F(v)/m); of walls only what depends on v where they are taken to stand still.
    template <ViscousForm F, class Real, class Function>
    void accelerations(const Vec<Dim>* v, double largest, bool walls_move, Function&& f);
    template <ViscousForm F, class Real>
    void solve(const Clock& clock);
    [[noreturn]] void fail(const Clock& clock, int iterations, double left) const;

    double tolerance_;
    int most_iterations_;
    sphinx::particles::SideArray<Vec<Dim>>
        solved_;  // x: of the last solution, whose force was felt
    std::int64_t iterations_ = 0;
    // Filled anew in each call. The sum over the walls of particle i is drag_[i] v + push_[i].
    AlignedVector<Mat<Dim>> drag_;
    AlignedVector<Vec<Dim>> push_;
    AlignedVector<Vec<Dim>> residual_;      // z, and the residual of the linear system by m
    AlignedVector<Vec<Dim>> direction_;     // p
    AlignedVector<Vec<Dim>> of_direction_;  // p - dt F(p)/m
};

template <int Dim>
double product(const Vec<Dim>& a, const Vec<Dim>& b) {
    double sum = a[0] * b[0];
    for (int c = 1; c < Dim; ++c) sum += a[c] * b[c];
    return sum;
}

template <int Dim>
template <ViscousForm F>
void ImplicitViscosity<Dim>::findWalls() {
    const std::vector<Index>& particles = around_.atOthers();
    drag_.resize(body_->size());
    push_.resize(body_->size());
    // Of a velocity of 1, where speeds are below a tenth of c0, and times larger than elsewhere
    // where a particle has come near a wall.
    const double per_speed = 100 * std::pow(body_->spacing, Dim - 2);
    parallelFor(particles.size(), [&](std::size_t k) {
        const Index i = particles[k];
        drag_[i].setZero();
        push_[i].setZero();
        for (const auto& wall : around_.walls()) {
            const NeighborList<Dim>& list = wall.list();
            if (list.ranges[i].count == 0) continue;
            const double unit = list.gradient_unit;
            ExactSums<Dim * Dim> columns(SumGrid(per_speed / unit));
            ExactSums<Dim> push(SumGrid(largest_ / unit));
            forEachWallParticle<Dim>(
                wall.fields, list, i, nearest_,
                [&](const Pairs<Dim>& pair, Lanes continued, const Lanes(&v_j)[Dim], Lanes r,
                    Lanes V_j) {
                    const Lanes V = volume_[i] * V_j;
                    for (int c = 0; c < Dim; ++c) {
                        Lanes along[Dim] = {};
                        along[c] = continued;
                        const Lanes f = viscousFactor<F, Dim, Lanes>(pair, along, r, V);
                        const auto& direction = viscousDirection<F, Dim, Lanes>(pair, along);
                        for (int row = 0; row < Dim; ++row)
                            columns[Dim * c + row].addProduct(f, direction[row]);
                    }
                    Lanes v_ij[Dim];
                    for (int c = 0; c < Dim; ++c) v_ij[c] = continued * -v_j[c];
                    addPairs<F, Dim>(pair, v_ij, r, V, push);
                });
            for (int c = 0; c < Dim; ++c) {
                for (int row = 0; row < Dim; ++row)
                    drag_[i](row, c) += unit * columns[Dim * c + row].value();
                push_[i][c] += unit * push[c].value();
            }
        }
    });
}

template <int Dim>
template <ViscousForm F, class Real, class Function>
void ImplicitViscosity<Dim>::accelerations(const Vec<Dim>* v, double largest, bool walls_move,
                                           Function&& f) {
    const PairTiles<Dim>& tiles = around_.own();
    const VelocitySteps steps(largest > 0 ? largest : 1);
    records_.template fill<Real>(tiles, [&](TileRecord<Dim, Real>& record, Index i) {
        for (int c = 0; c < Dim; ++c) record.v[c] = steps.of<Real>(v[i][c]);
        record.V = static_cast<Real>(volume_[i] / cell_);
    });
    addOwnPairs<F, false, true, Real>(tiles, records_, sums_);
    const auto addWalls = [&](Index i, std::array<double, Dim>& force) {
        for (int row = 0; row < Dim; ++row) {
            double sum = 0;
            for (int c = 0; c < Dim; ++c) sum += drag_[i](row, c) * v[i][c];
            force[row] += walls_move ? sum + push_[i][row] : sum;
        }
    };
    sums_.forEach(tiles, body_->size(), unitOfOwnPairs<Dim>(tiles, steps.speed(), cell_),
                  around_.atOthers(), addWalls,
                  [&](const Group& group, const VecOf<Dim, Wide>& force) {
                      const Wide factor = factor_ / load(mass_, group);
                      f(group, VecOf<Dim, Wide>(factor * force));
                  });
}

/// Largest norm of the vectors value(group).
template <int Dim, class Value>
double largestNorm(std::size_t n, Value&& value) {
    return std::sqrt(largestOf(n, [&](const Group& group) -> Wide {
        return VecOf<Dim, Wide>(value(group)).squaredNorm();
    }));
}

template <int Dim>
template <ViscousForm F, class Real>
void ImplicitViscosity<Dim>::solve(const Clock& clock) {
    const std::size_t n = body_->size();
    const double dt = clock.dt;
    records_.follow(around_.own());
    for (auto* vectors : {&residual_, &direction_, &of_direction_}) vectors->resize(n);
    Vec<Dim>* x = solved_.data();
    Vec<Dim>* z = residual_.data();
    Vec<Dim>* p = direction_.data();
    Vec<Dim>* q = of_direction_.data();

    double largest = largestNorm<Dim>(n, [&](const Group& group) { return load(x, group); });
    accelerations<F, Real>(x, largest, true, [&](const Group& group, const VecOf<Dim, Wide>& a) {
        store(VecOf<Dim, Wide>(load(velocity_, group) + dt * a - load(x, group)), z, group);
    });
    const auto sums = sumAll(n, [&](std::size_t i) {
        return std::array{mass_[i] * product<Dim>(z[i], z[i]),
                          mass_[i] * product<Dim>(velocity_[i], velocity_[i]), mass_[i]};
    });
    const double least = least_speed * body_->fluid().material->soundSpeed();
    const double enough = tolerance_ * tolerance_ * std::max(sums[1], least * least * sums[2]);
    double squared = sums[0];
    // What stopped being a number did so before: who looks at the state after a step says where.
    if (!std::isfinite(sums[0] + sums[1])) return;
    if (squared > enough)
        largest = largestNorm<Dim>(n, [&](const Group& group) {
            const VecOf<Dim, Wide> first = load(z, group);
            store(first, p, group);
            return first;
        });
    for (int k = 0; !(squared <= enough); ++k, ++iterations_) {
        if (k == most_iterations_) fail(clock, k, std::sqrt(squared / sums[2]));
        accelerations<F, Real>(p, largest, false,
                               [&](const Group& group, const VecOf<Dim, Wide>& a) {
                                   store(VecOf<Dim, Wide>(load(p, group) - dt * a), q, group);
                               });
        const double curvature =
            sumAll(n, [&](std::size_t i) { return mass_[i] * product<Dim>(p[i], q[i]); });
        if (!(curvature > 0)) fail(clock, k, std::sqrt(squared / sums[2]));
        const double step = squared / curvature;
        const double next = sumAll(n, [&](std::size_t i) {
            x[i] += step * p[i];
            z[i] -= step * q[i];
            return mass_[i] * product<Dim>(z[i], z[i]);
        });
        const double ratio = next / squared;
        squared = next;
        largest = largestNorm<Dim>(n, [&](const Group& group) {
            const VecOf<Dim, Wide> turned = load(z, group) + ratio * load(p, group);
            store(turned, p, group);
            return turned;
        });
    }
    parallelFor(n, [&](std::size_t i) { velocity_[i] = x[i] + z[i]; });
}

template <int Dim>
void ImplicitViscosity<Dim>::fail(const Clock& clock, int iterations, double left) const {
    throw PhysicsError(fmt::format(
        "fluid.implicit_viscosity of {} does not converge at time {:.9g}: after {} iterations "
        "velocities are off by {:.3g} (rms); a smaller step of its layer, or 'resolution: "
        "{{precision: double}}' helps",
        body_->name, clock.time, iterations, left));
}

/// A viscosity that follows the shear rate is not held over a step without care, and of two methods
/// that apply it one is too many.
void checkOnlyOne(const input::Component& method, WrittenCase& written) {
    const std::string& body = method.as<ImplicitViscosityParameters>().body.text;
    if (!written.calls(method)) return;
    for (const input::Component* other : written.called) {
        const auto* p = other->find<ViscousForceParameters>();
        if (p && p->body.text == body)
            written.diagnostics.error(
                method.place, fmt::format("{} and {} both apply the viscosity of {}: call one of "
                                          "them in the loop",
                                          other->name, method.name, body));
    }
}
void checkNewtonian(const input::Component& method, WrittenCase& written) {
    const input::Name& body = method.as<ImplicitViscosityParameters>().body;
    if (written.hasMaterial(body.text, "generalised_newtonian"))
        written.diagnostics.error(
            body.place, fmt::format("the viscosity of {} depends on the shear rate, which "
                                    "fluid.implicit_viscosity does not solve for: "
                                    "fluid.viscous_force does",
                                    written.materials.at(body.text)->name));
}
/// Bodies of a mechanism answer the fluid as a whole, which is not solved for.
void checkCarried(const input::Component& method, WrittenCase& written) {
    const auto& p = method.as<ImplicitViscosityParameters>();
    if (p.wall == WallSlip::free_slip) return;
    for (const std::string& carried : written.carried)
        if (written.sees(p.body.text, carried))
            written.diagnostics.error(
                method.place,
                fmt::format("{} is carried by a mechanism, whose motion {} does not solve for: "
                            "with it fluid.viscous_force applies the viscosity",
                            carried, method.name));
}
/// Nor is the friction with another liquid.
template <int Dim>
void checkAlone(const input::Component& method, BuiltCase<Dim>& built) {
    const input::Name& name = method.as<ImplicitViscosityParameters>().body;
    const Body<Dim>& body = *built.world.find(name.text);
    for (const Body<Dim>* other : body.sees)
        if (other != &body && other->isFluid())
            built.diagnostics.error(
                name.place, fmt::format("{} sees {}, and the friction of two fluids is not solved "
                                        "for by {}: fluid.viscous_force knows it",
                                        body.name, other->name, method.name));
}

}  // namespace

void declareImplicitViscosity(input::Registry& registry) {
    using P = ImplicitViscosityParameters;
    auto& d = declareMethod<ImplicitViscosity, P>(registry, "fluid.implicit_viscosity");
    d.summary(
        "Viscosity in large steps: the viscous force at the velocities at the end of the step, "
        "between the halves of fluid.pressure_relaxation");
    d.formula(
        "v = v* + dt F(v)/m with the force F of fluid.viscous_force, by conjugate gradients from "
        "the last solution on, until rms(v* + dt F(v)/m - v) <= tolerance max(rms(v*), 1e-6 c0)");
    d.cite("Morris, Fox & Zhu 1997", "(laplacian; velocity inside walls)");
    d.cite("guide", "(35)").cite("Hestenes & Stiefel 1952");
    d.required("body", &P::body, input::bodyReference({"fluid"}),
               "fluid; its material gives the viscosity");
    d.optional("wall", &P::wall, wallSlips(), "condition at solids");
    d.optional("form", &P::form, viscousForms(), "sum over pairs");
    d.optional("tolerance", &P::tolerance, input::number(unit::none).atLeast(1e-9).atMost(0.01),
               "when a solution is good enough; what is left acts in the next step");
    d.optional("most_iterations", &P::most_iterations, input::integer().atLeast(1),
               "after which the run ends with the last good state");
    d.trait("sums_over_itself");
    d.rule(checkOnlyOne);
    d.rule(checkNewtonian);
    d.rule(checkCarried);
    d.worldRule([](const auto& method, auto& built) { checkAlone(method, built); });
    d.action()
        .reads("body", {"velocity", "mass", "volume", "neighbors"})
        .reads("neighbors.solid", {"normal", "depth", "volume"})
        .reads("neighbors.driven", {"velocity"})
        .reads("neighbors.responding", {"average_velocity"})
        .within("body", "step")
        .throughout("it takes the limit by viscosity from the time steps")
        .writes("body", {"velocity", "fresh_viscous_load"});
}

}  // namespace sphinx::dynamics::fluid
