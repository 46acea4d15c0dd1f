// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "core/clock.h"
#include "dynamics/solid/neighbor_order.h"
#include "loop/flow/facts.h"

#include <map>
#include <string>
#include <vector>

namespace sphinx::run {

/// Looks at the particles after every outermost step: stops a run in which a number stopped being
/// one or neighbors in an elastic body change places, and warns once per body of speeds and
/// densities that the method is not made for.
template <int Dim>
class Health {
 public:
    Health(bodies::World<Dim>& world, neighbors::Relations<Dim>& relations,
           const loop::LoopFacts& facts);

    /// Throws PhysicsError that names particles, position, method and time.
    void check(const Clock& clock);

 private:
    /// Where a body was some steps ago: a number that is none soon spoils the position as well.
    struct Last {
        std::vector<std::int64_t> ids;
        std::vector<Vec<Dim>> positions;
    };

    void remember();
    void checkSpeed(const bodies::Body<Dim>& body, const Clock& clock);
    /// Ids of the particles whose value of the field is not finite.
    static std::vector<std::int64_t> spoilt(const bodies::Body<Dim>& body,
                                            const particles::FieldInfo& info);
    /// Where particles were when they were looked at last: ", last seen at (1, 2)," or, of several,
    /// in what box. Empty for particles that were not there.
    std::string lastPlace(const bodies::Body<Dim>& body,
                          const std::vector<std::int64_t>& ids) const;
    [[noreturn]] void fail(const bodies::Body<Dim>& body, const Clock& clock) const;

    const bodies::World<Dim>& world_;
    std::vector<dynamics::solid::NeighborOrder<Dim>> orders_;  // of the elastic bodies
    std::map<std::string, Last> last_;
    std::map<std::pair<std::string, std::string>, std::string> last_writer_;  // by body and field
    std::map<std::string, bool> warned_speed_;
    std::map<std::string, bool> warned_density_;
};

}  // namespace sphinx::run
