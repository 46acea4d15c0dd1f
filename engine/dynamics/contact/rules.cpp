// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact/rules.h"

#include "dynamics/contact/force.h"

#include <fmt/format.h>

namespace sphinx::dynamics::contact {
namespace {

using Sight = WrittenCase::Sight;

/// The line of topology by which the two are in contact, in either direction; null: none.
const Sight* contactOf(const WrittenCase& written, std::string_view a, std::string_view b) {
    const auto is = [&](const Sight& s) {
        return s.contact &&
               ((s.body.text == a && s.seen.text == b) || (s.body.text == b && s.seen.text == a));
    };
    const auto found = std::ranges::find_if(written.topology, is);
    return found == written.topology.end() ? nullptr : &*found;
}

/// Whether a contact.force of the loop has that pair; `but` is left out.
bool isComputed(const WrittenCase& written, std::string_view a, std::string_view b,
                const input::Component* but = nullptr) {
    return std::ranges::any_of(written.called, [&](const input::Component* method) {
        const auto* p = method->find<ForceParameters>();
        if (!p || method == but) return false;
        return std::ranges::any_of(p->with, [&](const input::Name& other) {
            return (p->body.text == a && other.text == b) || (p->body.text == b && other.text == a);
        });
    });
}

/// How far `a` and `b` are apart where they are nearest, length; and a particle of `a` there.
struct Nearest {
    double gap = std::numeric_limits<double>::infinity();
    std::size_t particle = 0;
};

template <int Dim>
Nearest nearest(const Body<Dim>& a, const Body<Dim>& b, const std::vector<bool>& held = {}) {
    Nearest found;
    if (!a.shape || !b.shape) return found;
    const double far = 2 * std::max(a.spacing, b.spacing);
    const Box<Dim> box = b.shape->bounds();
    const auto& position = a.particles.position();
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec<Dim>& x = position[i];
        if (!held.empty() && held[i]) continue;
        if (((x - box.lower).array() < -far).any() || ((x - box.upper).array() > far).any())
            continue;
        const double depth = -a.shape->signedDistance(x);
        if (depth > a.spacing) continue;
        const double gap = b.shape->signedDistance(x) - depth;
        if (gap < found.gap) found = {gap, i};
    }
    return found;
}

/// Particles that a constraint or a mechanism holds within an elastic body.
template <int Dim>
std::vector<bool> heldParticles(const BuiltCase<Dim>& built, const Body<Dim>& body) {
    std::vector<bool> held(body.size(), false);
    const auto hold = [&](const std::string& part) {
        if (part == body.name) held.assign(body.size(), true);
        for (const bodies::BodyPart<Dim>& one : body.parts)
            if (part == body.name + "." + one.name)
                for (const Index i : one.particles) held[i] = true;
    };
    if (!body.isElastic()) return held;
    for (const input::Component* method : built.called)
        if (method->declaration->name().starts_with("constraint."))
            for (const input::Name& part : method->references("part")) hold(part.text);
    for (const std::string& part : built.moved) hold(part);
    return held;
}

/// A gate or a plate in a fluid that bends, and is mounted beside others.
template <int Dim>
bool isMounted(const BuiltCase<Dim>& built, const Body<Dim>& body, const std::vector<bool>& held) {
    return std::ranges::find(held, true) != held.end() &&
           std::ranges::any_of(built.world.bodies, [&](const auto& other) {
               return other->isFluid() && built.sees(other->name, body.name);
           });
}

}  // namespace

void checkPairs(const input::Component& method, WrittenCase& written) {
    const auto& p = method.as<ForceParameters>();
    const std::string& body = p.body.text;
    input::Diagnostics& out = written.diagnostics;
    if (p.with.empty())
        out.error(
            p.body.place,
            fmt::format("{0} touches nothing: the topology of {0} has no {{contact: NAME}}", body));
    for (const input::Name& other : p.with) {
        const Sight* sight = contactOf(written, body, other.text);
        const bool elastic = written.isElastic(body) || written.isElastic(other.text);
        if (!sight)
            out.error(other.place, fmt::format("the topology of {} lacks {{contact: {}}}", body,
                                               other.text == body ? "self" : other.text));
        else if (written.bonded(body, other.text))
            out.error(sight->seen.place,
                      fmt::format("{} and {} are bonded: one piece has no contact within", body,
                                  other.text));
        else if (!written.responds(body) && !written.responds(other.text))
            out.error(sight->seen.place,
                      fmt::format("{} and {} are rigid and no body of multibody carries them: "
                                  "contact moves nothing",
                                  body, other.text));
        else if (other.text == body && !elastic)
            out.error(sight->seen.place,
                      fmt::format("{} is rigid: it does not touch itself", body));
        else if (!elastic && !p.modulus)
            out.error(method.place, fmt::format("{} and {} are both rigid: the stiffness of their "
                                                "contact has to be given as 'modulus'",
                                                body, other.text));
        if (elastic && p.restitution < 1)
            out.error(method.placeOf("restitution"),
                      "restitution is between rigid bodies: of elastic ones the material says what "
                      "is lost");
        if (isComputed(written, body, other.text, &method) && written.calls(method))
            out.error(method.place, fmt::format("two methods compute the contact of {} and {}",
                                                body, other.text));
    }
    if (!written.isElastic(body) || p.modulus)
        if (written.responds(body)) warnUnbounded(method, written, "contact.time_step");
}

template <int Dim>
void checkShapes(const input::Component& method, BuiltCase<Dim>& built) {
    const auto& p = method.as<ForceParameters>();
    const Body<Dim>& body = *built.world.find(p.body.text);
    for (const input::Name& name : p.with) {
        const Body<Dim>& other = *built.world.find(name.text);
        for (const Body<Dim>* one : {&body, &other})
            if (!one->shape)
                built.diagnostics.error(p.body.place,
                                        fmt::format("{} has no shape that tells its surface: its "
                                                    "particles are given one by one",
                                                    one->name));
    }
}

template <int Dim>
void checkContacts(BuiltCase<Dim>& built) {
    for (const Sight& sight : built.topology) {
        if (!sight.contact) continue;
        if (!isComputed(built, sight.body.text, sight.seen.text))
            built.diagnostics.error(
                sight.seen.place,
                fmt::format("nothing computes the contact of {} and {}: the loop calls no "
                            "contact.force for them",
                            sight.body.text, sight.seen.text));
    }
    // Solids side by side, of which one can come nearer.
    const auto& bodies = built.world.bodies;
    for (std::size_t k = 0; k < bodies.size(); ++k)
        for (std::size_t m = 0; m < k; ++m) {
            const bool first = bodies[k]->responds();
            const Body<Dim>& a = *bodies[first ? k : m];
            const Body<Dim>& b = *bodies[first ? m : k];
            if (!a.isSolid() || !b.isSolid() || !a.responds()) continue;
            if (built.bonded(a.name, b.name) || contactOf(built, a.name, b.name)) continue;
            const std::vector<bool> held = heldParticles(built, a);
            if (isMounted(built, a, held)) continue;
            const Nearest near = nearest(a, b, held);
            // Parts of a linkage are drawn over each other.
            if (std::abs(near.gap) > 0.25 * std::max(a.spacing, b.spacing)) continue;
            built.diagnostics.warning(
                built.places.find(a.name)->second,
                fmt::format("{0} and {1} meet at {2}, and nothing keeps them apart: the topology "
                            "of {0} lacks {{contact: {1}}}",
                            a.name, b.name,
                            built.world.placeText(a.particles.position()[near.particle])));
        }
}

template void checkShapes<2>(const input::Component&, BuiltCase<2>&);
template void checkShapes<3>(const input::Component&, BuiltCase<3>&);
template void checkContacts<2>(BuiltCase<2>&);
template void checkContacts<3>(BuiltCase<3>&);

}  // namespace sphinx::dynamics::contact
