// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/multibody/catenary.h"

#include "dynamics/multibody/mechanism.h"

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::multibody {
namespace {

/// The forces H (level) and V (upward) at its upper end as unknowns. Where the end comes to is the
/// gradient of W(H, V) = int T + T^2/(2 EA) ds, T the tension, which is convex: so Newton's method
/// with shorter steps where needed finds the one answer, and U = H x + V z - W is the energy.
class Hanging {
 public:
    Hanging(const CatenaryLine& line, double H, double V)
        : p_(line),
          H_(H),
          V_(V),
          lies_(line.on_ground && V < line.weight * line.length),
          below_(lies_ ? 0 : V - line.weight * line.length),
          hanging_(lies_ ? V / line.weight : line.length),
          T_(std::hypot(H, V)),
          T_below_(std::hypot(H, below_)) {
        if (H == 0) return;
        // sinh(asinh(V/H) - asinh(below/H)), without differences of what is nearly equal.
        const double c = V * below_ > 0
                             ? (V * V + below_ * below_ + H * H) / (T_ * T_below_ + V * below_)
                             : (T_ * T_below_ - V * below_) / (H * H);
        sinh_ = line.weight * hanging_ * (c + 1) / (T_ + T_below_);
        angle_ = std::asinh(sinh_);
    }

    double resting() const { return p_.length - hanging_; }
    double below() const { return below_; }
    double across() const {
        return resting() + H_ * (angle_ / p_.weight + p_.length / p_.stiffness);
    }
    double up() const {
        return hanging_ * (V_ + below_) * (1 / (T_ + T_below_) + 1 / (2 * p_.stiffness));
    }
    /// d across/dH, d across/dV = d up/dH, d up/dV.
    void slopes(double& xH, double& xV, double& zV) const {
        const double w = p_.weight, EA = p_.stiffness;
        const double bend = H_ * H_ / (T_ * T_below_) * sinh_;
        xH = (angle_ - bend) / w + p_.length / EA;
        xV = lies_ ? (H_ / T_ - 1) / w : (H_ / T_ - H_ / T_below_) / w;
        zV = bend / w + hanging_ / EA;
    }
    double energy(double across, double up) const {
        const double EA = p_.stiffness, H2 = H_ * H_;
        const double T = T_ + T_below_, V = V_ + below_;
        const double W = resting() * (H_ + H2 / (2 * EA)) +
                         0.25 * hanging_ * (T > 0 ? T + V * V / T : 0) +
                         H2 * angle_ / (2 * p_.weight) +
                         hanging_ * (H2 + (V_ * V_ + V_ * below_ + below_ * below_) / 3) / (2 * EA);
        return H_ * across + V_ * up - W;
    }

 private:
    CatenaryLine p_;
    double H_, V_;
    bool lies_;
    double below_, hanging_, T_, T_below_;
    double sinh_ = 0, angle_ = 0;
};

CatenaryShape shape(const CatenaryLine& line, double H, double V, double across, double up) {
    const Hanging at(line, H, V);
    return {H, V, at.below(), at.resting(), at.energy(across, up)};
}

}  // namespace

CatenaryShape hang(const CatenaryLine& line, double across, double up) {
    const double w = line.weight, L = line.length, EA = line.stiffness;
    if (line.on_ground) {
        if (up < 0)
            throw MechanismError("a line that lies on the ground has its upper end below it");
        // Straight up, what is left lies on the ground without tension.
        const double hanging = 2 * up / (1 + std::sqrt(1 + 2 * w * up / EA));
        if (L - hanging >= across) return shape(line, 0, w * hanging, across, up);
        if (up == 0) return shape(line, EA * (across - L) / L, 0, across, up);
    }
    // With both ends in one vertical line the level force is none.
    const double x = std::max(across, 1e-9 * L);
    // Where to begin: Jonkman 2007.
    const bool taut = std::hypot(x, up) >= L;
    const double lambda = taut ? 0.2 : std::sqrt(3 * ((L * L - up * up) / (x * x) - 1));
    double H = std::abs(w * x / (2 * lambda));
    double V = 0.5 * w * (up / std::tanh(lambda) + L);
    const double scale = L + x + std::abs(up);
    double wrong_x = 0, wrong_z = 0;
    const auto misfit = [&](double level, double lift) {
        const Hanging at(line, level, lift);
        wrong_x = at.across() - x;
        wrong_z = at.up() - up;
        return std::hypot(wrong_x, wrong_z) / scale;
    };
    double error = misfit(H, V);
    for (int n = 0; n < 200 && error > 0; ++n) {
        double xH, xV, zV;
        Hanging(line, H, V).slopes(xH, xV, zV);
        const double determinant = xH * zV - xV * xV;
        const double dH = -(zV * wrong_x - xV * wrong_z) / determinant;
        const double dV = -(xH * wrong_z - xV * wrong_x) / determinant;
        double part = 1;
        double next_H, next_V, next;
        do {
            next_H = std::max(H + part * dH, 0.1 * H);
            next_V = line.on_ground ? std::max(V + part * dV, 0.1 * V) : V + part * dV;
            next = misfit(next_H, next_V);
            part *= 0.5;
        } while (!(next < error) && part > 1e-9);
        // Nothing better: what is left is round-off.
        if (!(next < error)) break;
        H = next_H;
        V = next_V;
        error = next;
    }
    if (!(error < 1e-9)) throw MechanismError("a line hangs in no way that can be found");
    CatenaryShape found = shape(line, H, V, x, up);
    found.across *= across / x;
    return found;
}

}  // namespace sphinx::dynamics::multibody
