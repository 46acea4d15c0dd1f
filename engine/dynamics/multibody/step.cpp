// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/multibody/step.h"

#include "core/errors.h"
#include "core/log.h"
#include "dynamics/methods.h"
#include "dynamics/multibody/components.h"
#include "dynamics/multibody/description.h"
#include "dynamics/multibody/linear_algebra.h"
#include "dynamics/multibody/moved_part.h"

#include <fmt/format.h>
#include <map>

namespace sphinx::dynamics::multibody {
namespace {

/// Step of the rigid bodies of `multibody`: what acts on their particles goes to the mechanism,
/// which gives their motion back. Guide 1.2.
template <int Dim>
class Step final : public Method, public MechanismOwner {
 public:
    Step(Context<Dim>& context, const StepParameters&);
    void prepare() override;
    void run(const Clock& clock);
    void transfer(Archive& archive) override;
    std::size_t workSize() const override;
    const MultibodyParameters& parameters() const override { return *context_->multibody; }
    const Mechanism* mechanism() const override { return mechanism_.get(); }

 private:
    struct Moved {
        std::size_t body;
        MovedPart<Dim> part;
    };

    Context<Dim>* context_;
    std::vector<Moved> moved_;
    std::unique_ptr<Mechanism> mechanism_;  // once prepared
    // Of a restart, until the mechanism is there.
    std::vector<double> state_, work_;
    double time_ = 0;
};

template <int Dim>
Step<Dim>::Step(Context<Dim>& context, const StepParameters&)
    : context_(&context), time_(context.start_time) {
    const auto& bodies = context.multibody->bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        for (const input::Name& name : bodies[b].second.particles)
            moved_.push_back({b, MovedPart<Dim>(context.world, name)});
}

template <int Dim>
void Step<Dim>::prepare() {
    input::Diagnostics diagnostics;
    MechanismDescription description =
        describe<Dim>(*context_->multibody, context_->world, diagnostics);
    diagnostics.throwIfErrors();
    keepLinearAlgebraToOneThread();
    try {
        mechanism_ = std::make_unique<Mechanism>(std::move(description), time_, state_);
        if (!state_.empty()) mechanism_->setWork(work_);
    } catch (const MechanismError& e) {
        throw PhysicsError(fmt::format("the mechanism cannot be assembled: {}", e.what()));
    }
    for (Moved& moved : moved_) {
        moved.part.prepare();
        if (auto* wall = std::get_if<bodies::WallRole>(&moved.part.body().role))
            wall->carried_mass = mechanism_->description().bodies[moved.body].mass;
        if (state_.empty())
            moved.part.place(mechanism_->description().bodies[moved.body],
                             mechanism_->motion(static_cast<int>(moved.body)));
    }
}

template <int Dim>
void Step<Dim>::run(const Clock& clock) {
    if (clock.is_start) return;
    Mechanism& mechanism = *mechanism_;
    const std::vector<RigidBody>& bodies = mechanism.description().bodies;
    std::vector<BodyMotion> before(bodies.size());
    std::vector<BodyLoad> loads(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b)
        before[b] = mechanism.motion(static_cast<int>(b));
    for (Moved& moved : moved_)
        moved.part.addLoad(bodies[moved.body], before[moved.body], loads[moved.body]);
    try {
        mechanism.step(clock.time, clock.dt, loads);
    } catch (const MechanismError& e) {
        throw PhysicsError(fmt::format("the mechanism cannot go on at time {}: {}",
                                       context_->world.quantityText(clock.time, unit::time),
                                       e.what()));
    }
    for (Moved& moved : moved_)
        moved.part.follow(bodies[moved.body], before[moved.body],
                          mechanism.motion(static_cast<int>(moved.body)), clock);
    time_ = clock.time + clock.dt;
}

template <int Dim>
void Step<Dim>::transfer(Archive& archive) {
    if (mechanism_) {
        state_ = mechanism_->state();
        work_ = mechanism_->work();
    }
    archive.value("time", time_);
    archive.value("state", state_);
    archive.value("work", work_);
    std::string used = linearAlgebra();
    archive.value("linear_algebra", used);
    if (used != linearAlgebra())
        log::warning(
            fmt::format("the restart was written with the linear algebra of {}, this system "
                        "has {}: the last bits of the mechanism may differ",
                        used, linearAlgebra()));
}

template <int Dim>
std::size_t Step<Dim>::workSize() const {
    std::size_t size = 0;
    for (const Moved& moved : moved_) size += moved.part.size();
    return size;
}

/// The step has a mechanism, which can be assembled.
template <int Dim>
void checkMechanism(const input::Component& method, BuiltCase<Dim>& built) {
    if (!built.calls(method)) return;
    const MechanismDescription description =
        describe<Dim>(*built.multibody, built.world, built.diagnostics);
    if (built.diagnostics.hasErrors()) return;
    try {
        Mechanism(description, built.start_time);
    } catch (const MechanismError& e) {
        built.diagnostics.error(method.place,
                                fmt::format("the mechanism cannot be assembled: {}", e.what()));
    }
}

void requireBlock(const input::Component& method, WrittenCase& written) {
    if (!written.multibody)
        written.diagnostics.error(method.place, "a multibody.step needs the block 'multibody'");
}

/// Whether two names are of the same particles, or one is the body of the other's part.
bool overlap(const std::string& a, const std::string& b) {
    const auto within = [](const std::string& part, const std::string& body) {
        return part == body || part.substr(0, part.find('.')) == body;
    };
    return within(a, b) || within(b, a);
}

/// Particles that a mechanism moves follow nothing else.
void checkAlone(const input::Component& method, WrittenCase& written) {
    if (!written.multibody || !written.calls(method)) return;
    for (const auto& [body, p] : written.multibody->bodies)
        for (const input::Name& moved : p.particles)
            for (const input::Component* other : written.called) {
                if (!other->declaration->name().starts_with("constraint.")) continue;
                for (const input::Name& held : other->references("part"))
                    if (overlap(moved.text, held.text))
                        written.diagnostics.error(
                            other->placeOf("part"),
                            fmt::format("{} is carried by {} of multibody: a {} cannot move it as "
                                        "well",
                                        held.text, body.text, other->declaration->name()));
            }
}

/// What particles of a mechanism weigh is said once, by multibody.gravity: a force.gravity does
/// nothing where it has them all, and else must be the same on those that it has not.
void checkGravity(const input::Component& method, WrittenCase& written) {
    if (!written.multibody || !written.calls(method)) return;
    const Vector own =
        written.multibody->gravity ? vectorOf(*written.multibody->gravity) : Vector(Vector::Zero());
    std::map<std::string, Vector> total;
    for (const input::Component* other : written.called) {
        if (!other->declaration->hasTrait("uniform_gravity")) continue;
        const std::string body = other->references("body").front().text;
        total.try_emplace(body, Vector::Zero()).first->second +=
            vectorOf(*other->value<input::Coordinates>("acceleration"));
    }
    for (const input::Component* other : written.called) {
        if (!other->declaration->hasTrait("uniform_gravity")) continue;
        const std::string body = other->references("body").front().text;
        for (const auto& [carrier, p] : written.multibody->bodies)
            for (const input::Name& moved : p.particles)
                if (moved.text == body) {
                    written.diagnostics.error(
                        other->placeOf("body"),
                        fmt::format("{} is carried by {} of multibody: multibody.gravity alone is "
                                    "its weight",
                                    body, carrier.text));
                } else if (overlap(moved.text, body) && total.at(body) != own) {
                    written.diagnostics.error(
                        other->placeOf("acceleration"),
                        fmt::format("{} is carried by {} of multibody and weighs by "
                                    "multibody.gravity, which {}: the rest of {} needs the same",
                                    moved.text, carrier.text,
                                    written.multibody->gravity ? "is another" : "is missing",
                                    body));
                }
    }
}

}  // namespace

void declareStep(input::Registry& registry) {
    using P = StepParameters;
    auto& d = declareMethod<Step, P>(registry, "multibody.step");
    d.summary("Step of the rigid bodies and joints of the block multibody");
    d.formula(
        "the equations of motion of the mechanism, under gravity, its springs and motors and what "
        "acts on the particles of its bodies, by a Runge-Kutta method");
    d.cite("guide", "1.2").cite("Sherman, Seth & Delp 2011");
    d.optional("parts", &P::parts, input::list(input::partReference({"elastic", "rigid"})),
               "what it moves; filled in: the particles of all bodies of multibody");
    d.rule(requireBlock);
    d.rule(checkAlone);
    d.rule(checkGravity);
    d.worldRule([](const auto& method, auto& built) { checkMechanism(method, built); });
    d.action(
         "rigid bodies: between the halves of their fluid's pressure relaxation; with parts of "
         "elastic bodies: between the halves of their step")
        .reads("parts", {"initial_position", "position", "mass", "volume"})
        .mayRead("parts", {"pressure_force", "viscous_force", "contact_force",
                           "radiation_impedance", "average_velocity", "slip"})
        .mayRead("parts.elastic", {"acceleration", "velocity"})
        .mayRead("parts.rigid", {"initial_normal", "normal", "contact_couple"})
        .writes("parts", {"position", "velocity"})
        .writes("parts.rigid", {"acceleration"})
        .mayWrite("parts", {"slip"})
        .mayWrite("parts.rigid", {"normal"});
}

}  // namespace sphinx::dynamics::multibody
