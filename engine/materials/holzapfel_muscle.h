// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/expressions/expression.h"
#include "materials/elastic_solid.h"
#include "materials/strain.h"

#include <optional>
#include <string>
#include <vector>

namespace sphinx::materials {

/// The names are those of the guide's (14).
struct HolzapfelMuscleParameters {
    double density = 0;                        ///< rho0, mass/length^3
    double damping = 0;                        ///< eta of (16), mass/(length time)
    double lame_lambda = 0;                    ///< lambda, pressure
    double a = 0, a_f = 0, a_s = 0, a_fs = 0;  ///< pressure
    double b = 0, b_f = 0, b_s = 0, b_fs = 0;
    /// One per dimension, of the reference position; any length. An empty sheet is perpendicular to
    /// the fibre (2D only).
    std::vector<input::FieldExpression> fibre, sheet;

    using Violation = MaterialViolation;
    /// The directions at a place of the reference configuration, of unit length, the sheet
    /// perpendicular to the fibre: what is written may be off by 1e-3, for rounded numbers.
    template <int Dim>
    std::optional<Violation> directions(const Vec<Dim>& place, Fibres<Dim>& fibres) const;
    /// What is wrong with the directions whatever the place.
    std::optional<Violation> violation() const;
};

/// Orthotropic muscle (Holzapfel & Ogden 2009, doi:10.1098/rsta.2009.0091), guide (14), (15), with
/// the constants that make W = 0 at rest:
///   W = a/2b (exp(b psi) - 1) + lambda/2 (ln J)^2 + sum_{i=f,s} a_i/2b_i (exp(b_i (I_ii - 1)^2) -
///   1)
///       + a_fs/2b_fs (exp(b_fs I_fs^2) - 1),    psi = I_1 - 3 - 2 ln J.
/// The shear modulus of its isotropic part is a: linearised, S = lambda tr(E) I + 2 a E.
class HolzapfelMuscle final : public ElasticSolid {
 public:
    static constexpr bool uses_fibres = true;
    using Parameters = HolzapfelMuscleParameters;

    explicit HolzapfelMuscle(const Parameters& p);

    const Parameters& parameters() const { return p_; }
    bool hasFibres() const override { return true; }
    double longitudinalModulus() const override { return longitudinal_modulus_; }
    double bulkModulus() const override { return bulk_modulus_; }
    double shearModulus() const override { return shear_modulus_; }

    template <int Dim, class Number = double>
    MatOf<Dim, Number> stress(const MatOf<Dim, Number>& C, const Fibres<Dim, Number>& d) const {
        const State<Dim, Number> s(p_, C, d);
        const MatOf<Dim, Number> cross = d.fibre * d.sheet.transpose();
        return s.a * s.volume.identity_less + p_.lame_lambda * s.volume.log_j * s.volume.inverse +
               2 * s.a_f * s.i_f * d.fibre * d.fibre.transpose() +
               2 * s.a_s * s.i_s * d.sheet * d.sheet.transpose() +
               s.a_fs * s.i_fs * (cross + cross.transpose());
    }
    template <int Dim>
    double energy(const Mat<Dim>& C, const Fibres<Dim>& d) const {
        const State<Dim, double> s(p_, C, d);
        const double log_j = s.volume.log_j;
        return 0.5 *
               (p_.a * grown(p_.b, s.psi) + p_.lame_lambda * log_j * log_j +
                p_.a_f * grown(p_.b_f, s.i_f * s.i_f) + p_.a_s * grown(p_.b_s, s.i_s * s.i_s) +
                p_.a_fs * grown(p_.b_fs, s.i_fs * s.i_fs));
    }
    /// The isotropic part is that of NeoHookean with mu = a exp(b psi), plus
    /// 2 b mu (m.(F - F^-T)N)^2; fibre and sheet share N: (N.f)^2 + (N.s)^2 <= 1.
    template <int Dim, class Number = double>
    Number tangentModulus(const MatOf<Dim, Number>& C, const Fibres<Dim, Number>& d) const {
        using std::abs;
        using std::max;
        using Matrix = MatOf<Dim, Number>;
        const State<Dim, Number> s(p_, C, d);
        const Matrix I = Matrix::Identity();
        const Number volumetric = max(Number(0), p_.lame_lambda * (1 - s.volume.log_j) + s.a);
        const Matrix stretch = C - I - s.volume.identity_less;  // (F - F^-T)^T (F - F^-T)
        const Number along = alongModulus(s.a_f, p_.b_f, s.i_f);
        const Number across = alongModulus(s.a_s, p_.b_s, s.i_s);
        MatOf<2, Number> pair;  // of F f and F s
        pair << 1 + s.i_f, s.i_fs, s.i_fs, 1 + s.i_s;
        const Number shear = s.a_fs * (1 + 2 * p_.b_fs * s.i_fs * s.i_fs);
        return s.a + volumetric * largestEigenvalueBound<Dim, Number>(s.volume.inverse) +
               2 * p_.b * s.a * largestEigenvalueBound<Dim, Number>(stretch) + max(along, across) +
               shear * largestEigenvalueBound<2, Number>(pair) + s.a_fs * abs(s.i_fs);
    }

 private:
    /// (exp(b x) - 1)/b, also for b = 0.
    static double grown(double b, double x) { return b == 0 ? x : std::expm1(b * x) / b; }
    /// Tangent and pull of one family of fibres with I = 1 + i.
    template <class Number>
    static Number alongModulus(const Number& a, double b, const Number& i) {
        using std::max;
        return 4 * a * (1 + 2 * b * i * i) * (1 + i) + max(Number(0), 2 * a * i);
    }

    /// Invariants and the factors a exp(...) of one deformation.
    template <int Dim, class Number>
    struct State {
        VolumeChange<Dim, Number> volume;
        Number psi, i_f, i_s, i_fs;  ///< psi, I_ff - 1, I_ss - 1, I_fs
        Number a, a_f, a_s, a_fs;

        State(const Parameters& p, const MatOf<Dim, Number>& C, const Fibres<Dim, Number>& d)
            : volume(C) {
            using std::exp;
            const MatOf<Dim, Number> strain = C - MatOf<Dim, Number>::Identity();
            const VecOf<Dim, Number> along = strain * d.fibre;
            psi = strain.trace() - 2 * volume.log_j;
            i_f = d.fibre.dot(along);
            i_s = d.sheet.dot(strain * d.sheet);
            i_fs = d.sheet.dot(along);  // fibre and sheet are perpendicular
            a = p.a * exp(p.b * psi);
            a_f = p.a_f * exp(p.b_f * i_f * i_f);
            a_s = p.a_s * exp(p.b_s * i_s * i_s);
            a_fs = p.a_fs * exp(p.b_fs * i_fs * i_fs);
        }
    };

    Parameters p_;
    double longitudinal_modulus_, bulk_modulus_, shear_modulus_;
};

}  // namespace sphinx::materials
