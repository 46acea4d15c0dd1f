// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/errors.h"
#include "core/log.h"
#include "core/parallel.h"
#include "dynamics/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace sphinx::dynamics::neighbors {
namespace {

/// Brings particles that left a periodic domain back on the other side, treats lost particles as
/// the domain says, and rebuilds every list with one of the bodies on either side.
struct UpdateParameters {
    std::vector<input::Name> bodies;
};

/// The body and all that are bonded to it, directly (Body::piece) or through others.
template <int Dim>
std::vector<Body<Dim>*> pieceOf(Body<Dim>& body) {
    std::vector<Body<Dim>*> piece{&body};
    for (std::size_t k = 0; k < piece.size(); ++k)
        for (Body<Dim>* other : piece[k]->bonded)
            if (std::ranges::find(piece, other) == piece.end()) piece.push_back(other);
    return piece;
}

template <int Dim>
class Update final : public Method {
 public:
    Update(Context<Dim>& context, const UpdateParameters& p);
    void run(const Clock& clock);
    std::size_t workSize() const override;

 private:
    /// Bodies that cross a periodic side particle by particle, or as a whole.
    struct Crossing {
        std::vector<Body<Dim>*> bodies;
        bool whole = false;
    };
    void wrap(const Crossing& crossing) const;
    void findLost(Body<Dim>& body, const Clock& clock);
    void tellRemoved(const std::string& message);

    Context<Dim>* context_;
    std::vector<Body<Dim>*> bodies_;
    std::vector<Crossing> crossings_;
    std::size_t removed_ = 0;  ///< in this run
    std::size_t next_count_ = 10;
};

template <int Dim>
Update<Dim>::Update(Context<Dim>& context, const UpdateParameters& p) : context_(&context) {
    for (const input::Name& name : p.bodies) bodies_.push_back(&bodyOf(context, name));
    for (Body<Dim>* body : bodies_) {
        const auto holdsBody = [&](const Crossing& crossing) {
            return std::ranges::find(crossing.bodies, body) != crossing.bodies.end();
        };
        if (std::ranges::any_of(crossings_, holdsBody)) continue;
        if (body->isElastic())
            crossings_.push_back({pieceOf(*body), true});
        else
            crossings_.push_back({{body}, false});
    }
}

template <int Dim>
std::size_t Update<Dim>::workSize() const {
    std::size_t n = 0;
    for (const Body<Dim>* body : bodies_) n += body->size();
    return n;
}

template <int Dim>
void Update<Dim>::run(const Clock& clock) {
    for (const Crossing& crossing : crossings_) wrap(crossing);
    for (Body<Dim>* body : bodies_) findLost(*body, clock);
    context_->relations.update(bodies_);
}

template <int Dim>
void Update<Dim>::wrap(const Crossing& crossing) const {
    const Domain<Dim>& domain = context_->world.domain;
    for (int k = 0; k < Dim; ++k) {
        if (!domain.periodic[k]) continue;
        const double lower = domain.bounds.lower[k];
        const double upper = domain.bounds.upper[k];
        const double period = upper - lower;
        const auto inside = [&](double x) {
            if (x < lower) x += period;
            return x >= upper ? x - period : x;  // the sum may round to the upper side
        };
        // Lists of the reference configuration know no images, so an elastic body goes where its
        // first particle goes. None is further from that than a period: other lists find it.
        double step = 0;
        if (crossing.whole) {
            const double first = crossing.bodies.front()->particles.position()[0][k];
            step = first < lower ? period : first >= upper ? -period : 0;
            if (step == 0) continue;
        }
        for (Body<Dim>* body : crossing.bodies) {
            auto& position = body->particles.position();
            const std::size_t wrapped = countLocal(body->size(), [&](std::size_t i) {
                double& x = position[i][k];
                const double before = x;
                x = crossing.whole ? x + step : inside(x);
                return x != before;
            });
            // Grids and lists of the places before are stale.
            if (wrapped > 0) ++body->version;
        }
    }
}

template <int Dim>
void Update<Dim>::findLost(Body<Dim>& body, const Clock& clock) {
    const World<Dim>& world = context_->world;
    const Domain<Dim>& domain = world.domain;
    // A wall goes where its motion is prescribed.
    if (body.isWall()) return;
    auto& position = body.particles.position();
    Box<Dim> bounds = domain.bounds;
    if (body.isElastic()) {
        // It may reach across a periodic side.
        for (int k = 0; k < Dim; ++k) {
            if (!domain.periodic[k]) continue;
            bounds.lower[k] = -std::numeric_limits<double>::max();
            bounds.upper[k] = std::numeric_limits<double>::max();
        }
    }
    const auto outside = [&](std::size_t i) { return !bounds.contains(position[i]); };
    if (countLocal(body.size(), outside) == 0) return;

    std::vector<Index> particles;
    for (std::size_t i = 0; i < body.size(); ++i)
        if (outside(i)) particles.push_back(static_cast<Index>(i));
    // Told by their numbers, wherever they stand in memory.
    std::vector<Index> by_id = particles;
    const auto& ids = body.particles.id();
    std::ranges::sort(by_id, {}, [&](Index i) { return ids[i]; });
    for (const Index i : by_id) {
        const Vec<Dim>& x = position[i];
        const auto id = ids[i];
        const std::string place = world.placeText(x);
        const std::string time = world.quantityText(clock.time, unit::time);
        if (!x.allFinite())
            throw PhysicsError(fmt::format("position of particle {} of {} is {} at time {}", id,
                                           body.name, place, time));
        const std::string message = fmt::format(
            "particle {} of {} left the domain at {}, time {}: it reaches from {} to {}", id,
            body.name, place, time, world.placeText(domain.bounds.lower),
            world.placeText(domain.bounds.upper));
        // Lists of the reference configuration and parts of a solid know its particles by place.
        if (!body.isFluid()) throw PhysicsError(message);
        if (domain.lost == bodies::LostParticles::stop)
            throw PhysicsError(message + " (lost_particles: remove would go on without it)");
        tellRemoved(message);
    }
    body.particles.remove(particles);
    ++body.version;
}

/// Every particle in the log, but not thousands of a spray on the terminal: there the first ones,
/// then their number at powers of ten.
template <int Dim>
void Update<Dim>::tellRemoved(const std::string& message) {
    constexpr std::size_t told_singly = 3;
    const std::string line = "removed: " + message;
    if (++removed_ <= told_singly)
        log::info(line);
    else
        log::fileOnly(line);
    if (removed_ == next_count_) {
        log::info(
            fmt::format("removed: {} particles so far; the log has the place of each", removed_));
        next_count_ *= 10;
    }
}

}  // namespace

void declareUpdate(input::Registry& registry) {
    using P = UpdateParameters;
    auto& d = declareMethod<Update, P>(registry, "neighbors.update");
    d.summary("Rebuilds every neighbor list with one of the bodies on either side");
    d.required("bodies", &P::bodies, input::list(input::bodyReference({"fluid", "solid"})),
               "bodies that have moved");
    d.trait("removes");
    d.action().reads("bodies", {"position"}).writes("bodies", {"neighbors"});
}

}  // namespace sphinx::dynamics::neighbors
