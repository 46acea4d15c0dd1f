// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/relax.h"

#include "core/parallel.h"
#include "fitting/kernel_gradient.h"
#include "fitting/near_pairs.h"
#include "fitting/start.h"
#include "fitting/surface_row.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sphinx::fitting {
namespace {

/// What is kept of a displacement: a heavy ball rolls down (Polyak 1964).
constexpr double inertia = 0.9;
/// Steps in which the row gets to its depth. Sharp corners would squeeze points into one at once.
constexpr int steps_of_descent = 50;
/// The largest displacement, in spacings.
constexpr double longest = 0.1;
/// What moves by less than a tenth of the residual that is asked for stays.
constexpr double still = 0.1;
/// Places are multiples of it, in spacings: what differs by rounding alone becomes the same.
constexpr double grain = 0x1p-24;
/// In spacings: of a symmetric pair that a sharp corner has squeezed, one is left.
constexpr double too_near = 0.5;
/// In spacings: of the row, of all others at least, and where points come from that get into it.
constexpr double row_depth = 0.5;
constexpr double inner_depth = 1.02;
constexpr double start_depth = 1.6;
constexpr double shallow = 0.4;

template <int Dim>
class Relaxation {
 public:
    Relaxation(const Start<Dim>& start, const geometry::Shape<Dim>& shape,
               const particles::Lattice<Dim>& lattice, const kernels::Kernel<Dim>& kernel,
               const RelaxLimits& limits);

    Relaxed<Dim> run();

 private:
    /// A step; `descent`: how far the row has come. Returns the residual.
    double step(double descent);
    void move(std::size_t i, double descent);
    Vec<Dim> rounded(const Vec<Dim>& x) const;
    /// Whether there were pairs to thin out.
    bool thinOut();

    const geometry::Shape<Dim>* shape_;
    particles::Lattice<Dim> lattice_;
    RelaxLimits limits_;
    KernelGradient<Dim> gradient_;
    SurfaceRow<Dim> row_;
    double mobility_;   // displacement in a step by a force, length^2
    double least_way_;  // length
    double whole_;      // of the shape, length^Dim
    AlignedVector<Vec<Dim>> position_;
    AlignedVector<std::uint8_t> in_row_;
    AlignedVector<Vec<Dim>> force_;
    AlignedVector<Vec<Dim>> way_;        // in the last step
    AlignedVector<double> depth_;        // no less than that
    AlignedVector<double> rest_;         // of the force, as the residual counts it
    AlignedVector<std::uint8_t> moved_;  // in the last step
};

template <int Dim>
Relaxation<Dim>::Relaxation(const Start<Dim>& start, const geometry::Shape<Dim>& shape,
                            const particles::Lattice<Dim>& lattice,
                            const kernels::Kernel<Dim>& kernel, const RelaxLimits& limits)
    : shape_(&shape),
      lattice_(lattice),
      limits_(limits),
      gradient_(shape, lattice, kernel),
      row_(shape, lattice.spacing),
      mobility_(1 / gradient_.stiffness()),
      least_way_(still * limits.residual * gradient_.reference() * mobility_),
      whole_(start.volume * static_cast<double>(start.points.size())),
      position_(start.points.begin(), start.points.end()),
      in_row_(start.in_row.begin(), start.in_row.end()),
      way_(position_.size(), Vec<Dim>::Zero()),
      depth_(position_.size()),
      rest_(position_.size()),
      moved_(position_.size(), 1) {
    parallelFor(position_.size(),
                [&](std::size_t i) { depth_[i] = -shape.signedDistance(position_[i]); });
}

template <int Dim>
Vec<Dim> Relaxation<Dim>::rounded(const Vec<Dim>& x) const {
    const double unit = grain * lattice_.spacing;
    Vec<Dim> y;
    for (int k = 0; k < Dim; ++k)
        y[k] = lattice_.origin[k] + unit * std::round((x[k] - lattice_.origin[k]) / unit);
    return y;
}

template <int Dim>
void Relaxation<Dim>::move(std::size_t i, double descent) {
    const double spacing = lattice_.spacing;
    const Vec<Dim> before = inertia * way_[i];
    Vec<Dim> way = before + mobility_ * force_[i];
    const double length = way.norm();
    if (length > longest * spacing) way *= longest * spacing / length;
    Vec<Dim> x = position_[i] + way;
    depth_[i] -= length;
    rest_[i] = force_[i].norm();
    const double least = (in_row_[i] ? row_depth : inner_depth) * descent * spacing;
    const double most = in_row_[i] ? (start_depth + (row_depth - start_depth) * descent) * spacing
                                   : std::numeric_limits<double>::infinity();
    if (in_row_[i] || depth_[i] < least) {
        depth_[i] = -shape_->signedDistance(x);
        const double wanted = std::clamp(depth_[i], least, most);
        if (wanted != depth_[i]) {
            x = row_.place(x, wanted);
            depth_[i] = wanted;
            rest_[i] = (x - position_[i] - before).norm() / mobility_;
        }
    }
    way = rounded(x) - position_[i];
    moved_[i] = !(way.norm() < least_way_);
    way_[i] = moved_[i] ? way : Vec<Dim>(Vec<Dim>::Zero());
    position_[i] += way_[i];
}

template <int Dim>
double Relaxation<Dim>::step(double descent) {
    const double volume = whole_ / static_cast<double>(position_.size());
    gradient_.compute(position_, moved_, volume, force_);
    parallelFor(position_.size(), [&](std::size_t i) { move(i, descent); });
    return maxAll(position_.size(), 0, [&](std::size_t i) { return rest_[i]; }) /
           gradient_.reference();
}

template <int Dim>
bool Relaxation<Dim>::thinOut() {
    const NearPairs near = nearPairs(position_, too_near * lattice_.spacing);
    const auto nearest = [&](Index i) {
        const auto first = near.neighbor.begin() + static_cast<std::ptrdiff_t>(near.first[i]);
        const auto last = near.neighbor.begin() + static_cast<std::ptrdiff_t>(near.first[i + 1]);
        return std::min_element(first, last, [&](Index a, Index b) {
            return (position_[a] - position_[i]).squaredNorm() <
                   (position_[b] - position_[i]).squaredNorm();
        });
    };
    std::vector<std::uint8_t> leaves(position_.size(), 0);
    for (Index i = 0; i < position_.size(); ++i) {
        if (near.first[i] == near.first[i + 1]) continue;
        const Index j = *nearest(i);
        if (j < i || *nearest(j) != i) continue;
        position_[i] = rounded(0.5 * (position_[i] + position_[j]));
        in_row_[i] |= in_row_[j];
        leaves[j] = 1;
    }
    std::size_t left = 0;
    for (std::size_t i = 0; i < position_.size(); ++i) {
        if (leaves[i]) continue;
        position_[left] = position_[i];
        in_row_[left++] = in_row_[i];
    }
    position_.resize(left);
    in_row_.resize(left);
    way_.assign(left, Vec<Dim>::Zero());
    rest_.resize(left);
    moved_.assign(left, 1);
    depth_.resize(left);
    for (std::size_t i = 0; i < left; ++i) depth_[i] = -shape_->signedDistance(position_[i]);
    return left < leaves.size();
}

template <int Dim>
Relaxed<Dim> Relaxation<Dim>::run() {
    Relaxed<Dim> result;
    while (result.steps < limits_.steps) {
        const double descent = std::min(1.0, static_cast<double>(result.steps) / steps_of_descent);
        result.residual = step(descent);
        ++result.steps;
        if (descent < 1 || result.residual > limits_.residual) continue;
        result.converged = !thinOut();
        if (result.converged) break;
    }
    result.points.assign(position_.begin(), position_.end());
    result.volume = whole_ / static_cast<double>(position_.size());
    for (std::size_t i = 0; i < position_.size(); ++i) {
        if (!in_row_[i]) continue;
        ++result.row;
        if (!result.thin && -shape_->signedDistance(position_[i]) < shallow * lattice_.spacing)
            result.thin = position_[i];
    }
    return result;
}

}  // namespace

template <int Dim>
Relaxed<Dim> relax(const geometry::Shape<Dim>& shape, const particles::Lattice<Dim>& lattice,
                   const kernels::Kernel<Dim>& kernel, const RelaxLimits& limits) {
    const Start<Dim> start = startOf(shape, lattice);
    if (start.points.empty()) return {};
    return Relaxation<Dim>(start, shape, lattice, kernel, limits).run();
}

template Relaxed<2> relax(const geometry::Shape<2>&, const particles::Lattice<2>&,
                          const kernels::Kernel<2>&, const RelaxLimits&);
template Relaxed<3> relax(const geometry::Shape<3>&, const particles::Lattice<3>&,
                          const kernels::Kernel<3>&, const RelaxLimits&);

}  // namespace sphinx::fitting
