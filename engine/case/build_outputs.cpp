// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build_outputs.h"

namespace sphinx::model {

template <int Dim>
Outputs<Dim>::Outputs(const OutputTools<Dim>&, bool) {}
template <int Dim>
void Outputs<Dim>::addTo(loop::Plan& plan) const {
    plan.outputs = entries_;
}

template class Outputs<2>;
template class Outputs<3>;

}  // namespace sphinx::model
