// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/viscous_bound.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace sphinx::dynamics::fluid {
namespace {

/// Of the largest stable step in the midst of a fluid.
constexpr double margin = 0.94;
/// Sums of rows by the largest eigenvalue in corners of walls, at least.
double rowsExceed(ViscousForm form, double ratio) {
    if (form == ViscousForm::central) return 1;
    return ratio < 1.5 * (1 + 1e-9) ? 1.11 : 1.05;
}
constexpr int waves = 6;  ///< steps of the wave number from 0 to pi along each axis

template <int Dim>
double largestEigenvalue(const Mat<Dim>& matrix) {
    return Eigen::SelfAdjointEigenSolver<Mat<Dim>>(matrix, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .maxCoeff();
}

template <int Dim>
class Lattice {
 public:
    Lattice(const sphinx::kernels::Kernel<Dim>& fluid, const sphinx::kernels::Kernel<Dim>& walls,
            double spacing, ViscousForm form)
        : form_(form), factor_(form == ViscousForm::laplacian ? fluid.laplacianFactor() : Dim + 2) {
        points_ = points(fluid, spacing);
        wall_points_ = points(walls, spacing);
    }

    /// Among plane waves: sum of weights (1 - cos).
    double ofWaves() const {
        double largest = 0;
        std::array<int, 3> k{};
        for (k[0] = 0; k[0] <= waves; ++k[0])
            for (k[1] = 0; k[1] <= k[0]; ++k[1])
                for (k[2] = 0; k[2] <= (Dim == 3 ? k[1] : 0); ++k[2]) {
                    Vec<Dim> wave;
                    for (int c = 0; c < Dim; ++c) wave[c] = std::numbers::pi / waves * k[c];
                    Mat<Dim> sum = Mat<Dim>::Zero();
                    for (const Point& p : points_) sum += term(p, 1 - std::cos(wave.dot(p.place)));
                    largest = std::max(largest, largestEigenvalue<Dim>(sum));
                }
        return largest;
    }

    /// Of a particle half a spacing from so many walls: twice its terms with the fluid, and those
    /// with the walls, which stand still.
    ViscousBound ofRow(int walls) const {
        Mat<Dim> own = Mat<Dim>::Zero();
        Mat<Dim> held = Mat<Dim>::Zero();
        const auto depth = [&](const Point& p) {  // below the surfaces, spacings
            Vec<Dim> below = Vec<Dim>::Zero();
            for (int k = 0; k < walls; ++k) below[k] = std::max(0.0, -0.5 - p.place[k]);
            return below;
        };
        for (const Point& p : points_)
            if (depth(p).isZero()) own += term(p, 1);
        for (const Point& p : wall_points_)
            if (!depth(p).isZero()) held += term(p, 1 + continued(p, depth(p)));
        return {largestEigenvalue<Dim>(2 * own + held), largestEigenvalue<Dim>(held)};
    }

 private:
    struct Point {
        Vec<Dim> place = Vec<Dim>::Zero();  // spacings
        double weight = 0;
    };

    /// Neighbors of the origin.
    std::vector<Point> points(const sphinx::kernels::Kernel<Dim>& kernel, double spacing) const {
        const double factor = 2 * factor_ * std::pow(spacing, Dim) * kernel.gradientFactor();
        const int n = static_cast<int>(std::ceil(kernel.cutoff() / spacing));
        const int depth = Dim == 3 ? n : 0;
        std::vector<Point> found;
        for (int a = -n; a <= n; ++a)
            for (int b = -n; b <= n; ++b)
                for (int c = -depth; c <= depth; ++c) {
                    const std::array<int, 3> place{a, b, c};
                    Point point;
                    for (int k = 0; k < Dim; ++k) point.place[k] = place[k];
                    const double r = spacing * point.place.norm();
                    if (!(r > 0)) continue;
                    point.weight = -factor * kernel.derivative(r) / r;
                    if (point.weight > 0) found.push_back(point);
                }
        return found;
    }
    /// d_j/d_i, see continuation() in terms/viscosity.h.
    static double continued(const Point& p, const Vec<Dim>& depth) {
        const double below = depth.norm();
        return below / std::max(std::abs(p.place.dot(depth)) / below - below, 0.25);
    }
    Mat<Dim> term(const Point& p, double times) const {
        if (form_ == ViscousForm::laplacian) return times * p.weight * Mat<Dim>::Identity();
        return times * p.weight / p.place.squaredNorm() * p.place * p.place.transpose();
    }

    ViscousForm form_;
    double factor_;
    std::vector<Point> points_;
    std::vector<Point> wall_points_;
};

}  // namespace

template <int Dim>
ViscousBound viscousBound(const Body<Dim>& fluid, ViscousForm form,
                          const std::vector<const Body<Dim>*>& walls) {
    const auto* of_walls = &fluid.kernel;  // of the largest reach: both directions of a pair use it
    for (const Body<Dim>* wall : walls)
        if (wall->kernel.cutoff() > of_walls->cutoff()) of_walls = &wall->kernel;
    const Lattice<Dim> lattice(fluid.kernel, *of_walls, fluid.spacing, form);
    const double exceed = rowsExceed(form, fluid.kernel.smoothingLength() / fluid.spacing);
    ViscousBound bound{lattice.ofWaves() / margin, 0};
    for (int k = 1; k <= (walls.empty() ? 0 : Dim); ++k) {
        const ViscousBound row = lattice.ofRow(k);
        bound.whole = std::max(bound.whole, row.whole / exceed);
        bound.walls = std::max(bound.walls, row.walls);
    }
    return bound;
}

template ViscousBound viscousBound(const Body<2>&, ViscousForm, const std::vector<const Body<2>*>&);
template ViscousBound viscousBound(const Body<3>&, ViscousForm, const std::vector<const Body<3>*>&);

}  // namespace sphinx::dynamics::fluid
