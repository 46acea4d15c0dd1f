// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "materials/linear_elastic.h"

#include <fmt/format.h>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace sphinx::materials {
namespace {

std::array<std::optional<double>, 9> engineeringConstants(const LinearElasticParameters& p) {
    return {p.youngs_modulus_1, p.youngs_modulus_2, p.youngs_modulus_3,
            p.poisson_ratio_12, p.poisson_ratio_13, p.poisson_ratio_23,
            p.shear_modulus_12, p.shear_modulus_13, p.shear_modulus_23};
}

/// In the axes 1, 2, 3 of the material.
Stiffness tensorInAxes(const LinearElasticParameters& p) {
    Stiffness tensor = Stiffness::Zero();
    if (!p.stiffness.empty()) {
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                tensor(i, j) =
                    p.stiffness[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        return tensor;
    }
    Mat<3> compliance =
        Vec<3>(1 / *p.youngs_modulus_1, 1 / *p.youngs_modulus_2, 1 / *p.youngs_modulus_3)
            .asDiagonal();
    compliance(0, 1) = compliance(1, 0) = -*p.poisson_ratio_12 / *p.youngs_modulus_1;
    compliance(0, 2) = compliance(2, 0) = -*p.poisson_ratio_13 / *p.youngs_modulus_1;
    compliance(1, 2) = compliance(2, 1) = -*p.poisson_ratio_23 / *p.youngs_modulus_2;
    const Mat<3> axial = compliance.inverse();
    tensor.topLeftCorner<3, 3>() = (axial + axial.transpose()) / 2;
    tensor.diagonal().tail<3>() << *p.shear_modulus_23, *p.shear_modulus_13, *p.shear_modulus_12;
    return tensor;
}

Vec<3> inSpace(const input::Coordinates& axis) { return Vec<3>(axis.values.data()); }

/// The axes of the material as columns. In 2D axis 3 is that of the plane's normal.
Mat<3> axes(const LinearElasticParameters& p) {
    Mat<3> columns = Mat<3>::Identity();
    if (p.axis_1.size == 0) return columns;
    columns.col(0) = inSpace(p.axis_1).normalized();
    if (p.axis_2.size == 0) {
        columns.col(1) << -columns(1, 0), columns(0, 0), 0;
    } else {
        const Vec<3> second = inSpace(p.axis_2).normalized();
        columns.col(1) = (second - columns.col(0).dot(second) * columns.col(0)).normalized();
    }
    columns.col(2) = columns.col(0).cross(columns.col(1));
    return columns;
}

}  // namespace

std::string LinearElasticParameters::constantsViolation() const {
    const auto constants = engineeringConstants(*this);
    const auto count = std::count_if(constants.begin(), constants.end(),
                                     [](const auto& constant) { return constant.has_value(); });
    if (stiffness.empty() ? count != 9 : count != 0)
        return "the elastic constants must be youngs_modulus_1, 2 and 3, poisson_ratio_12, 13 and "
               "23 and shear_modulus_12, 13 and 23, or a stiffness matrix instead";
    if (!stiffness.empty()) {
        const auto wrong = [](const std::vector<double>& row) { return row.size() != 6; };
        if (stiffness.size() != 6 || std::any_of(stiffness.begin(), stiffness.end(), wrong))
            return "stiffness must be six rows of six numbers, in the order 11, 22, 33, 23, 13, 12";
        const Stiffness matrix = tensorInAxes(*this);
        if (matrix != matrix.transpose()) return "stiffness must be symmetric";
        if (Eigen::LLT<Stiffness>(matrix).info() != Eigen::Success)
            return "stiffness must be positive definite";
        return {};
    }
    // With r_ij = nu_ij sqrt(E_j/E_i) the compliance is positive definite when this holds.
    const double r12 = *poisson_ratio_12 * std::sqrt(*youngs_modulus_2 / *youngs_modulus_1);
    const double r13 = *poisson_ratio_13 * std::sqrt(*youngs_modulus_3 / *youngs_modulus_1);
    const double r23 = *poisson_ratio_23 * std::sqrt(*youngs_modulus_3 / *youngs_modulus_2);
    const double determinant = 1 - r12 * r12 - r13 * r13 - r23 * r23 - 2 * r12 * r13 * r23;
    if (!(std::abs(r12) < 1 && std::abs(r13) < 1 && std::abs(r23) < 1 && determinant > 1e-12))
        return "the Poisson ratios are too large: no solid of these moduli has them, its strain "
               "energy would not be positive";
    return {};
}

std::string LinearElasticParameters::axesViolation() const {
    if (axis_1.size == 0) return axis_2.size == 0 ? "" : "axis_2 is given without axis_1";
    if (axis_2.size == 0 && axis_1.size == 3) return "axis_1 is given without axis_2";
    const double first = inSpace(axis_1).norm();
    const double second = axis_2.size == 0 ? 1 : inSpace(axis_2).norm();
    if (!(first > 0 && second > 0)) return "an axis has no direction: all its components are 0";
    const double cosine = inSpace(axis_1).dot(inSpace(axis_2)) / (first * second);
    if (std::abs(cosine) > 1e-3)
        return fmt::format(
            "axis_1 and axis_2 must be orthogonal, but the cosine of their angle is "
            "{:.4g}",
            cosine);
    return {};
}

Stiffness LinearElasticParameters::tensor() const {
    return rotated(tensorInAxes(*this), axes(*this));
}

LinearElastic::LinearElastic(const Parameters& p)
    : ElasticSolid(p.density, p.damping), stiffness_(p.tensor()) {
    constexpr int rows[] = {0, 1, 5};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) plane_(i, j) = stiffness_(rows[i], rows[j]);
    longitudinal_modulus_ = largestLongitudinalModulus(stiffness_);
}

}  // namespace sphinx::materials
