// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/archive.h"
#include "dynamics/contact/search.h"

namespace sphinx::dynamics::contact {

/// What two surfaces do to each other where they meet.
struct PairLaw {
    double stiffness = 0;    ///< pressure per depth of penetration, of little of it
    double thickness = 0;    ///< of the layer that gives way; 0: infinite
    double coulomb = 0;      ///< coefficient of dry friction
    double viscous = 0;      ///< viscosity of the layer between both
    double restitution = 1;  ///< between rigid bodies: speed after over speed before
};

/// Two surfaces, or one with itself, that do not go through each other.
template <int Dim>
class Pair {
 public:
    Pair(const Domain<Dim>& domain, Surface<Dim>& a, Surface<Dim>& b, const PairLaw& law,
         double reach)
        : domain_(&domain),
          law_(law),
          reach_(reach),
          search_(domain, a, b, reach),
          a_(&a),
          b_(&b) {}
    virtual ~Pair() = default;
    Pair(const Pair&) = delete;
    Pair& operator=(const Pair&) = delete;

    /// Adds to contact_force and contact_pressure; the surfaces are those of the middle of a step
    /// by dt.
    virtual void act(double dt) = 0;
    /// State besides particle fields.
    virtual void transfer(Archive&) {}

    const PairLaw& law() const { return law_; }
    /// By how much stiffer than that the surfaces were for their particles in the last step; 0
    /// where nothing touched.
    double stiffening() const { return stiffening_; }
    bool involves(const Body<Dim>& body) const {
        return &a_->body() == &body || &b_->body() == &body;
    }
    /// The surfaces have moved.
    void search() { search_.update(); }
    /// Of the points of a body that have the other surface in reach.
    double nearArea(const Body<Dim>& body) const;

 protected:
    const Domain<Dim>* domain_;
    PairLaw law_;
    double reach_;
    Search<Dim> search_;
    double stiffening_ = 0;

 private:
    Surface<Dim>* a_;
    Surface<Dim>* b_;
};

}  // namespace sphinx::dynamics::contact
