// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/elastic_solid.h"

#include <optional>

namespace sphinx::materials {

/// What the isotropic laws have in common. Of the constants exactly one pair is given.
struct IsotropicParameters {
    double density = 0;                    ///< rho0, mass/length^3
    double damping = 0;                    ///< eta of (16), mass/(length time)
    std::optional<double> youngs_modulus;  ///< E, pressure
    std::optional<double> poisson_ratio;   ///< nu
    std::optional<double> bulk_modulus;    ///< K, pressure
    std::optional<double> shear_modulus;   ///< G, pressure
    std::optional<double> lame_lambda;     ///< lambda, pressure
    std::optional<double> lame_mu;         ///< mu, pressure

    /// What is wrong with the constants, or empty.
    std::string violation() const;
    double lambda() const;
    double mu() const;
};

/// An isotropic solid with Lame's constants, K = lambda + 2/3 mu and G = mu.
class IsotropicSolid : public ElasticSolid {
 public:
    using Parameters = IsotropicParameters;

    explicit IsotropicSolid(const IsotropicParameters& p)
        : ElasticSolid(p.density, p.damping), lambda_(p.lambda()), mu_(p.mu()) {}

    double lambda() const { return lambda_; }
    double mu() const { return mu_; }
    double longitudinalModulus() const override { return bulkModulus() + 4. / 3 * mu_; }
    double bulkModulus() const override { return lambda_ + 2. / 3 * mu_; }
    double shearModulus() const final { return mu_; }

 private:
    double lambda_;
    double mu_;
};

}  // namespace sphinx::materials
