// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/exact_sum.h"
#include "core/sum_all.h"
#include "dynamics/fluid/gradient_sums.h"
#include "dynamics/fluid/solid_load.h"
#include "dynamics/fluid/stress_divergence.h"
#include "dynamics/fluid/terms/conformation.h"
#include "dynamics/fluid/velocity_gradient.h"
#include "dynamics/methods.h"
#include "dynamics/pair_loop.h"
#include "materials/oldroyd_b_fluid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::fluid {
namespace {

/// Stress of the polymers in an Oldroyd-B fluid, tau = eta_p/lambda (c - 1), guide (20): each
/// particle carries the conformation c, which the velocity gradient at the particle
/// (VelocityGradient) stretches and which relaxes (relaxedConformation() in terms/conformation.h).
/// c is what is stepped, and not tau or log c: in a step it is deformed as the fluid is, by a
/// congruence, which keeps it positive at any Weissenberg number without eigenvalues to take, and
/// turns it where the fluid turns. (Log c, Fattal & Kupferman 2004,
/// doi:10.1016/j.jnnfm.2004.08.008, is for grids, where c is advected by polynomials of place; a
/// particle takes its c along.) In 2D the flow is plane: c_zz stays 1.
///
/// dv_i/dt = 1/m_i sum_j (tau_i B_i + tau_j B_j) . e_ij W' V_i V_j with the c of the end of the
/// step: velocity and stress are stepped by turns, which without solvent and relaxation loses no
/// energy.
///
/// The particles of a wall have the stress of the fluid, continued linearly: for the pair of i with
/// a wall particle j tau_j = tau_i + (r_j - r_i) . grad tau_i and B_j = B_i, the gradient over the
/// fluid's own particles, B-corrected. (With tau_j = tau_i the outermost row misses a part of the
/// force that does not shrink with the spacing, and the solvent has to bear it.)
struct PolymerStressParameters {
    input::Name body;
};

template <int Dim>
class PolymerStress final : public SolidLoad<Dim> {
 public:
    PolymerStress(Context<Dim>& context, const PolymerStressParameters& p);

    void run(const Clock& clock);
    Load<Dim> loadOn(const Body<Dim>& solid, const NeighborList<Dim>& list,
                     const Vec<Dim>& about) const override;
    void addForces(const Body<Dim>& solid, const NeighborList<Dim>& list,
                   Field<Vec<Dim>>& force) const override;

 private:
    using SolidLoad<Dim>::body_;
    /// What a fluid particle has of the stress at walls, times B_i: twice tau_i, and its gradient.
    struct AtWall {
        Mat<Dim> twice = Mat<Dim>::Zero();
        Mat<Dim> along[Dim];
        AtWall() { std::fill_n(along, Dim, Mat<Dim>::Zero()); }
    };
    static constexpr int moments = Dim == 2 ? 1 : 3;

    Mat<Dim> stress(std::size_t i) const {
        return modulus_ * (conformation_[i] - Mat<Dim>::Identity());
    }
    /// Of the present conformation and places, unless it is known.
    void findStress() const;
    void findGradients() const;
    /// Force on fluid particle i from a wall, and its moment about the particle.
    void wallForce(const typename Surroundings<Dim>::Wall& wall, const NeighborList<Dim>& list,
                   std::size_t i, Vec<Dim>& force, std::array<double, moments>* lever) const;
    /// (twice + along . r_ji) . e_ij W', of eight pairs of one fluid particle.
    static void traction(const AtWall& at, const Pairs<Dim>& pair, Lanes r, Lanes (&f)[Dim]);

    double lambda_;
    double modulus_;
    double cell_;
    mutable VelocityGradient<Dim> velocity_gradient_;
    Field<Vec<Dim>>& external_;
    Field<double>& mass_;
    Field<double>& volume_;
    Field<Mat<Dim>>& conformation_;

    // Made of the state whenever that has changed.
    mutable std::uint64_t version_ = ~std::uint64_t{0};
    mutable double largest_ = 0;                 // number in corrected_
    mutable AlignedVector<Mat<Dim>> corrected_;  // tau_i B_i
    mutable std::vector<AtWall> at_wall_;        // zero where there is none
    mutable OwnGradients<Dim> gradients_;
    StressDivergence<Dim> divergence_;
};

template <int Dim>
PolymerStress<Dim>::PolymerStress(Context<Dim>& context, const PolymerStressParameters& p)
    : SolidLoad<Dim>(context, bodyOf(context, p.body), LoadKind::polymer),
      lambda_(materials::asOldroydB(*body_->fluid().material)->relaxationTime()),
      modulus_(materials::asOldroydB(*body_->fluid().material)->modulus()),
      cell_(std::pow(body_->spacing, Dim)),
      velocity_gradient_(context, *body_, true),
      external_(body_->particles.vector(fields::external_acceleration)),
      mass_(body_->particles.scalar(fields::mass)),
      volume_(body_->particles.scalar(fields::volume)),
      conformation_(body_->particles.matrix(fields::conformation)) {}

template <int Dim>
void PolymerStress<Dim>::run(const Clock& clock) {
    this->actedAt(clock.time);
    velocity_gradient_.find();
    parallelFor(body_->size(), [&](std::size_t i) {
        conformation_[i] = relaxedConformation<Dim>(
            conformation_[i], velocity_gradient_.gradient()[i], clock.dt, lambda_);
    });
    version_ = ~std::uint64_t{0};
    findStress();
    divergence_.find(velocity_gradient_.around().own(), corrected_, volume_, body_->spacing);
    const auto& walls = velocity_gradient_.around().walls();
    parallelFor(body_->size(), [&](std::size_t i) {
        Vec<Dim> force = divergence_.force()[i];
        for (const auto& wall : walls) wallForce(wall, wall.list(), i, force, nullptr);
        external_[i] += force / mass_[i];
    });
}

template <int Dim>
void PolymerStress<Dim>::findStress() const {
    if (version_ == body_->version && corrected_.size() == body_->size()) return;
    // The velocity gradient is that of the present state, too, when run() asks.
    if (version_ != ~std::uint64_t{0} || corrected_.size() != body_->size())
        velocity_gradient_.find();
    version_ = body_->version;
    const auto& correction = velocity_gradient_.correction();
    corrected_.resize(body_->size());
    parallelFor(body_->size(), [&](std::size_t i) { corrected_[i] = stress(i) * correction[i]; });
    largest_ = maxAll(body_->size(), 0.0,
                      [&](std::size_t i) { return corrected_[i].cwiseAbs().maxCoeff(); });
    if (velocity_gradient_.around().walls().empty()) return;
    at_wall_.assign(body_->size(), AtWall());
    if (!(largest_ > 0)) return;
    findGradients();
}

template <int Dim>
void PolymerStress<Dim>::findGradients() const {
    const auto& at_walls = velocity_gradient_.around().atOthers();
    gradients_.begin(velocity_gradient_.around().own(), body_->size(), volume_, cell_);
    for (int a = 0; a < Dim; ++a)
        for (int b = 0; b <= a; ++b) {
            const auto& slope = gradients_.find(largest_, [&](Index i) { return stress(i)(a, b); });
            parallelFor(at_walls.size(), [&](std::size_t k) {
                AtWall& at = at_wall_[at_walls[k]];
                for (int c = 0; c < Dim; ++c)
                    at.along[c](a, b) = at.along[c](b, a) = slope[at_walls[k]][c];
            });
        }
    parallelFor(at_walls.size(), [&](std::size_t k) {
        AtWall& at = at_wall_[at_walls[k]];
        const Mat<Dim>& correction = velocity_gradient_.correction()[at_walls[k]];
        at.twice = 2 * corrected_[at_walls[k]];
        for (int c = 0; c < Dim; ++c) at.along[c] = (at.along[c] * correction).eval();
    });
}

template <int Dim>
void PolymerStress<Dim>::traction(const AtWall& at, const Pairs<Dim>& pair, Lanes r,
                                  Lanes (&f)[Dim]) {
    const Lanes scale = r * pair.inverse_dW;  // r_j - r_i by the gradient
    for (int a = 0; a < Dim; ++a) {
        Lanes row[Dim];
        for (int b = 0; b < Dim; ++b) {
            Lanes slope[Dim];
            for (int c = 0; c < Dim; ++c) slope[c] = lanes(at.along[c](a, b));
            row[b] = at.twice(a, b) + scale * dot<Dim>(slope, pair.gradient);
        }
        f[a] = dot<Dim>(row, pair.gradient);
    }
}

template <int Dim>
void PolymerStress<Dim>::wallForce(const typename Surroundings<Dim>::Wall& wall,
                                   const NeighborList<Dim>& list, std::size_t i, Vec<Dim>& force,
                                   std::array<double, moments>* lever) const {
    if (list.ranges[i].count == 0 || !(largest_ > 0)) return;
    using Vector = VecOf<Dim, Wide>;
    const double unit = list.gradient_unit;
    // sum_j abs(W') V_j is about 1/spacing.
    const double bound = 100 * largest_ * cell_ / (body_->spacing * unit);
    const SumGrid grid(bound);
    ExactSums<Dim> sum(grid);
    ExactSums<moments> turned(SumGrid(bound * list.cutoff));
    Distances<Dim> distances(list, i);
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        const Lanes r = distances.next();
        Lanes f[Dim];
        traction(at_wall_[i], pair, r, f);
        const Lanes V = volume_[i] * gatherLanes(wall.fields.volume->data(), pair.index);
        for (int a = 0; a < Dim; ++a) sum[a].addProduct(f[a], V);
        if (!lever) return;
        Vector d, e;
        for (int c = 0; c < Dim; ++c) {
            d[c] = f[c];
            e[c] = pair.gradient[c] * pair.inverse_dW;
        }
        const auto moment = momentOf<Dim, Wide>(e, d);
        for (int c = 0; c < moments; ++c) turned[c].addProduct(V * r, moment[c].at);
    });
    for (int a = 0; a < Dim; ++a) force[a] += unit * sum[a].value();
    if (lever)
        for (int c = 0; c < moments; ++c) (*lever)[c] += unit * turned[c].value();
}

template <int Dim>
Load<Dim> PolymerStress<Dim>::loadOn(const Body<Dim>& solid, const NeighborList<Dim>& list,
                                     const Vec<Dim>& about) const {
    const auto* wall = velocity_gradient_.around().wall(solid);
    if (!wall) return {};
    findStress();
    const auto& position = body_->particles.position();
    return sumAll(body_->size(), [&](std::size_t i) {
        Load<Dim> own;
        if (list.ranges[i].count == 0) return own;
        Vec<Dim> force = Vec<Dim>::Zero();
        std::array<double, moments> lever{};
        wallForce(*wall, list, i, force, &lever);
        // What the wall gets acts at its particles.
        own.add(position[i] - about, -force);
        for (int c = 0; c < moments; ++c) own.moment[c] -= lever[c];
        return own;
    });
}

template <int Dim>
void PolymerStress<Dim>::addForces(const Body<Dim>& solid, const NeighborList<Dim>& list,
                                   Field<Vec<Dim>>& force) const {
    const auto* wall = velocity_gradient_.around().wall(solid);
    if (!wall || !(largest_ > 0)) return;
    const double unit = list.gradient_unit;
    const SumGrid grid(100 * largest_ * cell_ / (body_->spacing * unit));
    parallelFor(list.ranges.size(), [&](std::size_t j) {
        if (list.ranges[j].count == 0) return;
        ExactSums<Dim> sum(grid);
        Distances<Dim> distances(list, j);
        forEachPair(list, j, [&](const Pairs<Dim>& pair) {
            const Lanes r = distances.next();
            const Pairs<Dim> seen{pair.reversed(), pair.index};
            Lanes all[Dim] = {};
            for (int k = 0; k < lane_count; ++k) {
                Lanes f[Dim];
                traction(at_wall_[pair.index[k]], seen, r, f);
                for (int a = 0; a < Dim; ++a) all[a][k] = f[a][k];
            }
            const Lanes V = (*wall->fields.volume)[j] * gatherLanes(volume_.data(), pair.index);
            for (int a = 0; a < Dim; ++a) sum[a].addProduct(-all[a], V);
        });
        for (int a = 0; a < Dim; ++a) force[j][a] += unit * sum[a].value();
    });
}

/// Polymers are in the fluid that the method acts on, and no polymers are forgotten.
void checkMaterial(const input::Component& method, WrittenCase& written) {
    const input::Name& body = method.as<PolymerStressParameters>().body;
    const auto material = written.materials.find(body.text);
    if (material == written.materials.end() ||
        material->second->declaration->hasTrait("viscoelastic"))
        return;
    written.diagnostics.error(
        body.place, fmt::format("there are no polymers in {}: its material is a {}, not an "
                                "oldroyd_b_fluid",
                                body.text, material->second->declaration->name()));
}
template <int Dim>
void checkEvolved(BuiltCase<Dim>& built) {
    for (const auto& [body, material] : built.materials) {
        if (!material->declaration->hasTrait("viscoelastic")) continue;
        const bool evolved = std::ranges::any_of(built.called, [&](const auto* method) {
            const auto* p = method->template find<PolymerStressParameters>();
            return p && p->body.text == body;
        });
        if (!evolved)
            built.diagnostics.error(
                built.places.at(body),
                fmt::format("nothing moves the polymers in {}: the loop calls no "
                            "fluid.polymer_stress for it",
                            body));
    }
}

}  // namespace

void declarePolymerStress(input::Registry& registry) {
    using P = PolymerStressParameters;
    auto& d = declareMethod<PolymerStress, P>(registry, "fluid.polymer_stress");
    d.summary("Stress of the polymers in an Oldroyd-B fluid, and how they stretch and relax");
    d.formula(
        "dc_i/dt = L_i c_i + c_i L_i^T - (c_i - 1)/lambda; tau_i = eta_p/lambda (c_i - 1); dv_i/dt "
        "= 1/m_i sum_j (tau_i B_i + tau_j B_j) . e_ij W' V_i V_j; no-slip walls have the stress "
        "of the fluid, continued linearly");
    d.cite("guide", "(20)").cite("Oldroyd 1950").cite("Randles & Libersky 1996");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid of an oldroyd_b_fluid");
    d.trait("sums_over_itself");
    d.rule(checkMaterial);
    d.caseRule([](auto& built) { checkEvolved(built); });
    d.action("once in each step of its layer, with fresh neighbors")
        .reads("body", {"velocity", "mass", "volume", "position", "conformation", "neighbors"})
        .reads("neighbors.solid", {"normal", "depth", "volume"})
        .reads("neighbors.driven", {"velocity"})
        .reads("neighbors.responding", {"average_velocity"})
        .writes("body", {"conformation"})
        .accumulates("body", {"external_acceleration"});
}

}  // namespace sphinx::dynamics::fluid
