// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"

namespace sphinx::dynamics::solid {

struct UpdateNormalsParameters {
    input::Name body;
};

/// Normals that turn with an elastic body: n = F^-T N / abs(F^-T N) (Nanson's formula), N at the
/// start.
template <int Dim>
class UpdateNormals final : public Method {
 public:
    explicit UpdateNormals(Body<Dim>& body);
    void run(const Clock& clock);
    std::size_t workSize() const override { return body_->size(); }

 private:
    Body<Dim>* body_;
    Field<Vec<Dim>>& normal_;
    Field<Vec<Dim>>& initial_normal_;
    Field<Mat<Dim>>& gradient_;
};

/// Registers solid.update_normals.
void declareUpdateNormals(input::Registry& registry);

}  // namespace sphinx::dynamics::solid
