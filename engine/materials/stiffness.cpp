// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "materials/stiffness.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace sphinx::materials {
namespace {

constexpr int voigt[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
constexpr int first[6] = {0, 1, 2, 1, 0, 0};
constexpr int second[6] = {0, 1, 2, 2, 2, 1};

/// Acoustic tensor Q_ik = c_ijkl n_j n_l.
Mat<3> acousticTensor(const Stiffness& c, const Vec<3>& n) {
    Mat<3> q = Mat<3>::Zero();
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j)
                for (int l = 0; l < 3; ++l) q(i, k) += c(voigt[i][j], voigt[k][l]) * n[j] * n[l];
    return q;
}

/// max over m and n of c_ijkl m_i n_j m_k n_l uphill from n: each is in turn the best for the
/// other.
double climb(const Stiffness& c, Vec<3> n) {
    double value = 0;
    for (int step = 0; step < 100; ++step) {
        const Eigen::SelfAdjointEigenSolver<Mat<3>> solver(acousticTensor(c, n));
        const double next = solver.eigenvalues()[2];
        if (next <= value * (1 + 1e-15)) break;
        value = next;
        n = solver.eigenvectors().col(2);
    }
    return value;
}

}  // namespace

Stiffness rotated(const Stiffness& stiffness, const Mat<3>& axes) {
    // Column J of `strain` is what the unit strain J of x, y, z is in the given axes.
    Stiffness strain;
    for (int j = 0; j < 6; ++j) {
        Mat<3> e = Mat<3>::Zero();
        e(first[j], second[j]) = e(second[j], first[j]) = j < 3 ? 1 : 0.5;
        const Mat<3> turned = axes.transpose() * e * axes;
        for (int i = 0; i < 6; ++i) strain(i, j) = turned(first[i], second[i]) * (i < 3 ? 1 : 2);
    }
    const Stiffness result = strain.transpose() * stiffness * strain;
    return (result + result.transpose()) / 2;
}

double largestLongitudinalModulus(const Stiffness& stiffness) {
    double largest = 0;
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
            for (int z = 0; z <= 2; ++z)
                if (x || y || z)
                    largest = std::max(largest, climb(stiffness, Vec<3>(x, y, z).normalized()));
    return largest;
}

double averageBulkModulus(const Stiffness& stiffness) {
    return stiffness.topLeftCorner<3, 3>().sum() / 9;
}

double averageShearModulus(const Stiffness& stiffness) {
    const double axial = stiffness.diagonal().head<3>().sum();
    const double shear = stiffness.diagonal().tail<3>().sum();
    return (axial - (stiffness.topLeftCorner<3, 3>().sum() - axial) / 2 + 3 * shear) / 15;
}

}  // namespace sphinx::materials
