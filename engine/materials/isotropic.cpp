// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "materials/isotropic.h"

#include <fmt/format.h>

namespace sphinx::materials {

std::string IsotropicParameters::violation() const {
    int count = 0;
    std::string given;
    const auto list = [&](const std::optional<double>& constant, const char* name) {
        if (!constant) return;
        if (count++ > 0) given += ", ";
        given += name;
    };
    list(youngs_modulus, "youngs_modulus");
    list(poisson_ratio, "poisson_ratio");
    list(bulk_modulus, "bulk_modulus");
    list(shear_modulus, "shear_modulus");
    list(lame_lambda, "lame_lambda");
    list(lame_mu, "lame_mu");
    const bool pair = (youngs_modulus && poisson_ratio) || (bulk_modulus && shear_modulus) ||
                      (lame_lambda && lame_mu);
    if (count != 2 || !pair)
        return "the elastic constants must be one pair: youngs_modulus and poisson_ratio, "
               "bulk_modulus and shear_modulus, or lame_lambda and lame_mu; given: " +
               (count > 0 ? given : "none");
    if (lame_lambda && !(*lame_lambda + 2. / 3 * *lame_mu > 0))
        return fmt::format("the bulk modulus lame_lambda + 2/3 lame_mu is {:g} but must be above 0",
                           *lame_lambda + 2. / 3 * *lame_mu);
    return {};
}

double IsotropicParameters::lambda() const {
    if (youngs_modulus)
        return *youngs_modulus * *poisson_ratio / ((1 + *poisson_ratio) * (1 - 2 * *poisson_ratio));
    return bulk_modulus ? *bulk_modulus - 2. / 3 * *shear_modulus : *lame_lambda;
}

double IsotropicParameters::mu() const {
    if (youngs_modulus) return *youngs_modulus / (2 * (1 + *poisson_ratio));
    return bulk_modulus ? *shear_modulus : *lame_mu;
}

}  // namespace sphinx::materials
