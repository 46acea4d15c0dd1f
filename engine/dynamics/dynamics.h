// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/archive.h"
#include "core/clock.h"
#include "input/declaration/access.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sphinx::dynamics {

/// One entry of `dynamics`: its actions, which the declaration binds to member functions, run when
/// lines of the loop call them. Constructors ask for fields and relations; they change no body.
class Method {
 public:
    virtual ~Method() = default;

    /// Once, when all methods are made: tells its body what the body has to know at all times,
    /// whether or not a line is under way (gravity, that a part is clamped). There may be no
    /// particles yet.
    virtual void announce() {}
    /// Once, when the particles are there and before anything runs: builds what follows from the
    /// initial configuration, such as its lists. What names particles by their places is built
    /// again by the method itself when ParticleSet::arrangement() has changed.
    virtual void prepare() {}
    /// Particles that one call works on, for the profile's ns per particle.
    virtual std::size_t workSize() const = 0;
    /// Of an iterative solver, in all calls of this process; for the profile.
    virtual std::int64_t iterations() const { return 0; }
    /// The window of a line that has called it is over (`until`): takes back what it has left for
    /// others and what would otherwise stay as if it still acted.
    virtual void rest() {}
    /// State besides particle fields.
    virtual void transfer(Archive&) {}
};

/// What a line of the loop calls: an action of a method, bound to the class that has it. An
/// indirect call a line, never one a particle.
using ActionCall = void (*)(Method&, const Clock&);

/// A method that a layer's `dt` may name.
class TimeStepMethod {
 public:
    virtual ~TimeStepMethod() = default;
    /// Largest stable step at the current state; time, positive.
    virtual double estimate() = 0;
    virtual std::size_t workSize() const = 0;
};

using input::AccessMode;
using input::changes;

/// What an action does to a field of a body of the case.
struct FieldAccess {
    AccessMode mode = AccessMode::read;
    std::string body;
    std::string field;    ///< a name of particles/fields.h, of a span, or one of those below
    bool result = false;  ///< outputs alone may read it
};

/// Pseudo fields for the check of the loop. Lists of a body go stale when its positions are
/// written; `neighbors` wants them to exist, `fresh_neighbors` to be fresh as well.
namespace pseudo_field {
inline constexpr std::string_view neighbors = "neighbors";
inline constexpr std::string_view fresh_neighbors = "fresh_neighbors";
}  // namespace pseudo_field

/// What a fluid has felt and a method hands on to solids: a pseudo field that the fluid's method
/// writes and the other reads. It goes stale when `stale_by` of the fluid is written: what solids
/// then got would not be minus what the fluid has felt.
struct FeltLoad {
    std::string_view field;
    std::string_view what;  ///< in messages
    std::string_view stale_by;
};
inline constexpr std::array felt_loads{
    FeltLoad{"fresh_viscous_load", "viscous force", "velocity"},
};

inline bool isPseudoField(std::string_view field) {
    return field == pseudo_field::neighbors || field == pseudo_field::fresh_neighbors ||
           std::ranges::any_of(felt_loads,
                               [&](const FeltLoad& load) { return load.field == field; });
}

}  // namespace sphinx::dynamics
