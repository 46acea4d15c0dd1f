// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/wide.h"
#include "materials/material.h"

namespace sphinx::materials {

/// Unit directions of the muscle at a particle in the reference configuration, perpendicular to
/// each other: fibre f0 and sheet s0 of the guide's (13).
template <int Dim, class Number = double>
struct Fibres {
    VecOf<Dim, Number> fibre = VecOf<Dim, Number>::Zero();
    VecOf<Dim, Number> sheet = VecOf<Dim, Number>::Zero();
};

/// Hyperelastic solid in the total-Lagrangian form. In 2D it is in plane strain, C_33 = 1.
/// What depends on the deformation are members of the final classes, reached through withLaw()
/// of elastic_laws.h:
///
///     static constexpr bool uses_fibres = true;  // else `fibres` below is ignored: pass {}
///     template <int Dim, class Number = double>
///     MatOf<Dim, Number> stress(const MatOf<Dim, Number>& C, const Fibres<Dim, Number>&) const;
///     template <int Dim> double energy(const Mat<Dim>& C, const Fibres<Dim>& fibres) const;
///     template <int Dim, class Number = double>
///     Truth<Number> admissible(const MatOf<Dim, Number>& C) const;
///     template <int Dim, class Number = double>
///     Number tangentModulus(const MatOf<Dim, Number>& C, const Fibres<Dim, Number>&) const;
///
/// Number is double, or Wide for eight particles at a time.
/// C = F^T F must be exactly symmetric with det C > 0.
/// stress: second Piola-Kirchhoff stress S = 2 dW/dC, symmetric, pressure; of the elastic part
///   alone, the damping (16) is the business of the method.
/// energy: W per reference volume, pressure; 0 at rest.
/// admissible: false where the law has no stress (a finite extensibility that is exceeded); what
///   the other members give there means nothing.
/// tangentModulus: an upper estimate, over all directions N of propagation and m of motion, of
///   m.Q(N).m with the acoustic tensor of the reference coordinates
///   Q_ij = F_iA F_jB (dS/dE)_ACBD N_C N_D + delta_ij N.S.N (pressure, above 0), so that
///   sqrt(modulus/rho0) bounds the speed of sound against the particles' reference spacing.
class ElasticSolid : public Material {
 public:
    static constexpr bool uses_fibres = false;

    /// rho0 in mass/length^3; eta in mass/(length time).
    ElasticSolid(double density, double damping) : density_(density), damping_(damping) {}

    double density() const override { return density_; }
    /// eta of the Kelvin-Voigt stress S^D = eta/2 (dF/dt^T F + F^T dF/dt), guide (16).
    double damping() const { return damping_; }
    /// That of laws without a limit.
    template <int Dim, class Number = double>
    Truth<Number> admissible(const MatOf<Dim, Number>&) const {
        return always<Number>();
    }
    /// True when the law asks for the directions of each particle.
    virtual bool hasFibres() const { return false; }

    /// Largest longitudinal modulus at rest, rho0 c_P^2; lambda + 2 mu when isotropic.
    virtual double longitudinalModulus() const = 0;
    /// Bulk and shear modulus at rest; of an anisotropic solid the averages after Voigt.
    virtual double bulkModulus() const = 0;
    virtual double shearModulus() const = 0;

 private:
    double density_;
    double damping_;
};

}  // namespace sphinx::materials
