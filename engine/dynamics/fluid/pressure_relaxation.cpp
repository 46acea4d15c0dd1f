// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/pressure_relaxation.h"

#include "core/parallel.h"
#include "dynamics/pair_loop.h"

namespace sphinx::fluid {
namespace {

/// Eight wall particles as a fluid particle meets them.
template <int Dim>
struct WallLanes {
    Lanes n[Dim];       // unit, from the wall to the fluid
    Lanes closing;      // -(v_i - v_w) . n
    Lanes V;
};

template <int Dim>
Lanes dot(const Lanes a[Dim], const Lanes b[Dim]) {
    Lanes sum = a[0] * b[0];
    for (int c = 1; c < Dim; ++c) sum += a[c] * b[c];
    return sum;
}

template <int Dim>
void gatherVector(const Vec<Dim>* values, const std::uint32_t* index, Lanes out[Dim]) {
    for (int k = 0; k < lane_count; ++k)
        for (int c = 0; c < Dim; ++c) out[c][k] = values[index[k]][c];
}

template <class F>
void withRiemann(Riemann riemann, F&& f) {
    switch (riemann) {
        case Riemann::none: return f.template operator()<Riemann::none>();
        case Riemann::dissipative: return f.template operator()<Riemann::dissipative>();
        case Riemann::low_dissipation: return f.template operator()<Riemann::low_dissipation>();
    }
}

}  // namespace

template <int Dim>
PressureRelaxation<Dim>::PressureRelaxation(Context<Dim>& context, Body<Dim>& body,
                                            Riemann riemann)
    : body_(&body),
      domain_(&context.world.domain),
      fluid_(&dynamic_cast<const WeaklyCompressibleFluid&>(*body.material)),
      riemann_(riemann),
      constants_{fluid_->density(), fluid_->soundSpeed()},
      position_(body.particles.position()),
      velocity_(body.particles.vector(fields::velocity)),
      external_(body.particles.vector(fields::external_acceleration)),
      mass_(body.particles.scalar(fields::mass)),
      volume_(body.particles.scalar(fields::volume)),
      density_(body.particles.scalar(fields::density)),
      density_rate_(body.particles.scalar(fields::density_rate)),
      pressure_(body.particles.scalar(fields::pressure)) {
    for (Body<Dim>* other : body.sees) {
        Relation<Dim>& relation = context.relations.relation(body, *other);
        if (other == &body) {
            self_ = &relation;
        } else {
            relation.list.keep_distance = true;
            ParticleSet<Dim>& p = other->particles;
            walls_.push_back({&relation, &p.vector(fields::velocity),
                              &p.vector(fields::acceleration), &p.vector(fields::normal),
                              &p.scalar(fields::volume)});
        }
    }
}

template <int Dim>
void PressureRelaxation<Dim>::run(int action, const Clock& clock) {
    if (action == 0)
        firstHalf(clock.dt);
    else
        secondHalf(clock.dt);
}

template <int Dim>
void PressureRelaxation<Dim>::firstHalf(double dt) {
    before_.resize(body_->size());
    after_.resize(body_->size());
    predict(dt);
    withRiemann(riemann_, [&]<Riemann R>() { momentum<R>(dt); });
}

template <int Dim>
void PressureRelaxation<Dim>::secondHalf(double dt) {
    withRiemann(riemann_, [&]<Riemann R>() { continuity<R>(dt); });
    ++body_->version;
}

template <int Dim>
void PressureRelaxation<Dim>::predict(double dt) {
    const double half = 0.5 * dt;
    const auto all = [&](auto&& pressure) {
        parallelRanges(body_->size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const double rho = density_[i] + half * density_rate_[i];
                const double p = pressure(rho);
                const double V = mass_[i] / rho;
                density_[i] = rho;
                pressure_[i] = p;
                volume_[i] = V;
                position_[i] += half * velocity_[i];
                PairState<Dim>& state = before_[i];
                for (int c = 0; c < Dim; ++c) state.v[c] = velocity_[i][c];
                state.p = p;
                state.V = V;
            }
        });
    };
    if (fluid_->equationOfState() == EquationOfState::linear) {
        const double c2 = fluid_->soundSpeed() * fluid_->soundSpeed();
        const double rho0 = fluid_->density();
        all([=](double rho) { return c2 * (rho - rho0); });
    } else {
        all([this](double rho) { return fluid_->pressure(rho); });
    }
}

namespace {

/// The wall's side of eight pairs.
template <int Dim, class Wall>
WallLanes<Dim> wallSide(const Wall& wall, const Pairs<Dim>& pair, const Vec<Dim>& v) {
    WallLanes<Dim> w;
    Lanes vw[Dim];
    gatherVector<Dim>(wall.velocity->data(), pair.index, vw);
    gatherVector<Dim>(wall.normal->data(), pair.index, w.n);
    w.V = gatherLanes(wall.volume->data(), pair.index);
    // e_ij points from the wall to the fluid and gradient = -abs(W') e_ij.
    const Lanes side = dot<Dim>(w.n, pair.gradient);
    const Lanes sign = side > 0.0 ? lanes(-1) : lanes(1);
    w.closing = Lanes{};
    for (int c = 0; c < Dim; ++c) {
        w.n[c] *= sign;
        w.closing -= (v[c] - vw[c]) * w.n[c];
    }
    return w;
}

/// Pressure of the ghost less that of the fluid, g_i being the fluid particle's acceleration.
template <int Dim, class Wall>
Lanes ghostPressure(const Wall& wall, const Pairs<Dim>& pair, const float* distance,
                    const Vec<Dim>& g, double rho) {
    Lanes aw[Dim];
    gatherVector<Dim>(wall.acceleration->data(), pair.index, aw);
    Lanes pull = {};  // (g_i - a_w) . (-e_ij)
    for (int c = 0; c < Dim; ++c) pull += (g[c] - aw[c]) * pair.gradient[c];
    return rho * loadLanes(distance) * maxLanes(pull * pair.inverse_dW, Lanes{});
}

/// Adds sum_j 2 p*_ij e_ij W' V_j over the wall particles j near the fluid particle i.
template <Riemann R, int Dim, class Wall>
inline void addWallPressure(const Wall& wall, const NeighborList<Dim>& list, std::size_t i,
                            const RiemannConstants& constants, const Vec<Dim>& v, const Vec<Dim>& g,
                            double p, double rho, Lanes sum[Dim]) {
    const float* distance = list.distancesOf(i);
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        const WallLanes<Dim> w = wallSide<Dim>(wall, pair, v);
        const Lanes ghost = ghostPressure<Dim>(wall, pair, distance, g, rho);
        // The ghost moves with the mirrored normal velocity: closing at twice the speed.
        const Lanes p2 = 2.0 * p + ghost + pressureJump<R>(constants, 2.0 * w.closing);
        const Lanes f = p2 * w.V;
        for (int c = 0; c < Dim; ++c) sum[c] += f * pair.gradient[c];
        distance += lane_count;
    });
}

}  // namespace

template <int Dim>
template <Riemann R>
void PressureRelaxation<Dim>::momentum(double dt) {
    const NeighborList<Dim>& self = self_->list;
    const PairState<Dim>* state = before_.data();
    // Along a periodic axis there is no hydrostatic pressure.
    Vec<Dim> gravity = body_->gravity;
    for (int c = 0; c < Dim; ++c)
        if (domain_->periodic[c]) gravity[c] = 0;
    const Vec<Dim> weight = constants_.rho0 * gravity;
    parallelRanges(body_->size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const PairState<Dim>& si = state[i];
            Lanes sum[Dim] = {};
            forEachPair(self, i, [&](const Pairs<Dim>& pair) {
                const PairLanes<Dim> sj = gather(state, pair.index);
                Lanes approach = {};  // v_ij . e_ij W' > 0 where the particles close in
                for (int c = 0; c < Dim; ++c) approach += (si.v[c] - sj.v[c]) * pair.gradient[c];
                const Lanes p2 =
                    si.p + sj.p + pressureJump<R>(constants_, approach * pair.inverse_dW);
                const Lanes f = p2 * sj.V;
                for (int c = 0; c < Dim; ++c) sum[c] += f * pair.gradient[c];
            });
            const Vec<Dim> v = velocity_[i];
            const Vec<Dim> g = external_[i];
            for (const Wall& wall : walls_) {
                addWallPressure<R>(wall, wall.relation->list, i, constants_, v, g, si.p,
                                   density_[i], sum);
            }
            PairState<Dim>& next = after_[i];
            const double factor = -dt * si.V / mass_[i];
            for (int c = 0; c < Dim; ++c) {
                const double vc = v[c] + factor * sumLanes(sum[c]) + dt * g[c];
                velocity_[i][c] = vc;
                next.v[c] = vc;
            }
            next.p = si.p - weight.dot(position_[i]);
            next.V = si.V;
        }
    });
}

template <int Dim>
Vec<Dim> PressureRelaxation<Dim>::forceOn(const Body<Dim>& solid,
                                          const NeighborList<Dim>& list) const {
    Vec<Dim> force = Vec<Dim>::Zero();
    for (const Wall& wall : walls_) {
        if (wall.relation->to != &solid) continue;
        withRiemann(riemann_, [&]<Riemann R>() {
            force = parallelReduce(
                body_->size(), force,
                [&](std::size_t begin, std::size_t end) {
                    Vec<Dim> part = Vec<Dim>::Zero();
                    for (std::size_t i = begin; i < end; ++i) {
                        if (list.ranges[i].count == 0) continue;
                        Lanes sum[Dim] = {};
                        addWallPressure<R>(wall, list, i, constants_, velocity_[i], external_[i],
                                           pressure_[i], density_[i], sum);
                        for (int c = 0; c < Dim; ++c) part[c] += volume_[i] * sumLanes(sum[c]);
                    }
                    return part;
                },
                [](const Vec<Dim>& a, const Vec<Dim>& b) -> Vec<Dim> { return a + b; });
        });
    }
    return force;
}

template <int Dim>
template <Riemann R>
void PressureRelaxation<Dim>::continuity(double dt) {
    const NeighborList<Dim>& self = self_->list;
    const PairState<Dim>* state = after_.data();
    const double half = 0.5 * dt;
    parallelRanges(body_->size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const PairState<Dim>& si = state[i];
            Lanes sum = {};
            forEachPair(self, i, [&](const Pairs<Dim>& pair) {
                const PairLanes<Dim> sj = gather(state, pair.index);
                Lanes term = -pair.dW * velocityJump<R>(constants_, si.p - sj.p);
                for (int c = 0; c < Dim; ++c) term += (si.v[c] - sj.v[c]) * pair.gradient[c];
                sum += term * sj.V;
            });
            const Vec<Dim> v = velocity_[i];
            for (const Wall& wall : walls_) {
                const NeighborList<Dim>& list = wall.relation->list;
                forEachPair(list, i, [&](const Pairs<Dim>& pair) {
                    // The ghost has the fluid's own pressure above the hydrostatic.
                    const WallLanes<Dim> w = wallSide<Dim>(wall, pair, v);
                    sum -= 2.0 * w.closing * dot<Dim>(w.n, pair.gradient) * w.V;
                });
            }
            const double rate = density_[i] * sumLanes(sum);
            density_rate_[i] = rate;
            density_[i] += half * rate;
            position_[i] += half * v;
        }
    });
}

void declarePressureRelaxation(input::Registry& registry) {
    using P = PressureRelaxationParameters;
    auto& d = registry.declare<P>(input::Kind::dynamics, "fluid.pressure_relaxation");
    d.summary("Acoustic step of a weakly compressible fluid in two halves around the momentum sum");
    d.formula(
        "guide (51), (56)-(58) as drift-kick-drift; m_i dv_i/dt = -2 sum_j p*_ij e_ij W' V_i V_j, "
        "drho_i/dt = 2 rho_i sum_j (v_i - v*_ij) . e_ij W' V_j");
    d.citation("Zhang, Hu & Adams 2017, doi:10.1016/j.jcp.2017.01.027");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid that is stepped");
    d.optional("riemann", &P::riemann,
               input::choice<Riemann>({
                   {"none", Riemann::none, "averages: no dissipation"},
                   {"dissipative", Riemann::dissipative, "linearised Riemann problem"},
                   {"low_dissipation", Riemann::low_dissipation, "the same with the limiter"},
               }),
               "how pressure and velocity between two particles are found");
    d.action("first_half", "density, pressure and position to the half step; velocity by a whole step")
        .reads("body", {"velocity", "mass", "density", "density_rate", "position",
                        "external_acceleration", "neighbors"})
        .reads("neighbors.solid", {"velocity", "acceleration", "normal", "volume"})
        .writes("body", {"density", "pressure", "volume", "position", "velocity"});
    d.action("second_half", "rate of change of the density; density and position to the full step")
        .reads("body", {"velocity", "pressure", "volume", "density", "position",
                        "external_acceleration", "neighbors"})
        .reads("neighbors.solid", {"velocity", "acceleration", "normal", "volume"})
        .writes("body", {"density_rate", "density", "position"});
    d.builder(factory<Method, P>([]<int Dim>(const P& p, Context<Dim>& context) {
        return std::make_unique<PressureRelaxation<Dim>>(context, bodyOf(context, p.body),
                                                         p.riemann);
    }));
}

template class PressureRelaxation<2>;
template class PressureRelaxation<3>;

}  // namespace sphinx::fluid
