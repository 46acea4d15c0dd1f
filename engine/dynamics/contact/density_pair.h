// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/contact/pair.h"

namespace sphinx::dynamics::contact {

/// Contact as guide (36) and (37) have it, in the signs that push apart and slow down. A particle
/// has a contact density from the particles of the other body in reach of the kernel, as they
/// stand now, and from it a pressure:
///   rho_i^c = m_i sum_j W_ij,   p_i^c = c0^2 rho_i^c = K V_i sum_j W_ij,
///   f_ij = (p_i^c + p_j^c) V_i V_j abs(W') e_ij
///          - 2 (d + 2) mu^c V_i V_j abs(W') (v_ij . e_ij)/r_ij e_ij.
/// Bodies then push each other from a kernel's reach on: they rest about a spacing apart.
template <int Dim>
class DensityPair final : public Pair<Dim> {
 public:
    /// law.stiffness: K over the spacing.
    DensityPair(const Domain<Dim>& domain, Surface<Dim>& a, Surface<Dim>& b, const PairLaw& law);

    void act(double dt) override;

 private:
    struct Side {
        Surface<Dim>* from;
        Surface<Dim>* to;
        const typename Search<Dim>::Lists* lists;
        std::vector<double> pressure;  // of all points
    };
    void findPressure(Side& side) const;
    void push(Side& side, const Side& other) const;

    const Kernel<Dim>* kernel_;
    double modulus_;
    std::vector<Side> sides_;  // two, or one of a surface with itself
};

}  // namespace sphinx::dynamics::contact
