// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"

namespace sphinx::dynamics::neighbors {

struct UpdateParameters {
    std::vector<input::Name> bodies;
};

/// Brings particles that left a periodic domain back on the other side, treats lost particles as
/// the domain says, and rebuilds every list with one of the bodies on either side.
template <int Dim>
class Update final : public Method {
 public:
    Update(Context<Dim>& context, std::vector<Body<Dim>*> bodies);

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

/// Registers neighbors.update.
void declareUpdate(input::Registry& registry);

}  // namespace sphinx::dynamics::neighbors
