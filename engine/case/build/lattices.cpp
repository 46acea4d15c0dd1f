// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/lattices.h"

#include <set>

namespace sphinx::build {
namespace {

using particles::Lattice;
using particles::SurfacePoints;

template <int Dim>
struct Candidate {
    const geometry::Shape<Dim>* shape;
    std::array<bool, Dim> movable{};
    SurfacePoints<Dim> surface;  ///< of the lattice as it would lie unmoved
    PlacedLattice<Dim> placed;
};

template <int Dim>
Vec<Dim> origin(const model::Body& body, const bodies::Domain<Dim>& domain) {
    if (body.resolution.origin) return body.resolution.origin->as<Dim>();
    Vec<Dim> origin = Vec<Dim>::Zero();
    for (int k = 0; k < Dim; ++k)
        if (domain.periodic[static_cast<std::size_t>(k)]) origin[k] = domain.bounds.lower[k];
    return origin;
}

template <int Dim>
Lattice<Dim> movedLattice(Lattice<Dim> lattice, int axis) {
    lattice.origin[axis] += 0.5 * lattice.spacing;
    return lattice;
}

/// Finds the points of the lattice where it lies now, and returns those on the surface.
template <int Dim>
SurfacePoints<Dim> fill(Candidate<Dim>& body) {
    auto scan = particles::scanLattice<Dim>(*body.shape, body.placed.lattice);
    body.placed.points = std::move(scan.points);
    body.placed.on_surface = scan.surface.count;
    return std::move(scan.surface);
}

/// Whether points fall on opposite faces, and on fewer ones where the lattice has moved.
template <int Dim>
bool gains(const Candidate<Dim>& body, int axis) {
    const auto& lower = body.surface.lower[axis];
    const auto& upper = body.surface.upper[axis];
    if (lower.empty() || upper.empty()) return false;
    const auto after =
        particles::surfacePoints<Dim>(*body.shape, movedLattice(body.placed.lattice, axis));
    return after.lower[axis].size() + after.upper[axis].size() < lower.size() + upper.size();
}

/// Whether both have the same lattice, and points of it on faces of both.
template <int Dim>
bool shareFace(const Candidate<Dim>& a, const Candidate<Dim>& b, int axis) {
    if (a.placed.lattice.spacing != b.placed.lattice.spacing) return false;
    std::set<particles::LatticeIndex<Dim>> points(a.surface.lower[axis].begin(),
                                                  a.surface.lower[axis].end());
    points.insert(a.surface.upper[axis].begin(), a.surface.upper[axis].end());
    for (const auto* face : {&b.surface.lower[axis], &b.surface.upper[axis]})
        for (const auto& point : *face)
            if (points.contains(point)) return true;
    return false;
}

/// Decides along one axis for all bodies; who shares a face with one that moves moves too.
template <int Dim>
void moveLattices(std::map<std::string, Candidate<Dim>>& bodies, int axis) {
    std::vector<Candidate<Dim>*> moved;
    const auto move = [&](Candidate<Dim>& body) {
        body.placed.moved[axis] = true;
        moved.push_back(&body);
    };
    for (auto& [name, body] : bodies)
        if (body.movable[axis] && gains(body, axis)) move(body);
    for (std::size_t n = 0; n < moved.size(); ++n)
        for (auto& [name, body] : bodies)
            if (body.movable[axis] && !body.placed.moved[axis] && shareFace(*moved[n], body, axis))
                move(body);
}

}  // namespace

template <int Dim>
std::map<std::string, PlacedLattice<Dim>> placeLattices(const model::Case& model,
                                                        const bodies::Domain<Dim>& domain) {
    std::map<std::string, Candidate<Dim>> bodies;
    for (const model::Body& source : model.bodies) {
        if (source.shape.empty() || source.particles) continue;
        Candidate<Dim> body{model.findShape(source.shape.text)->as<Dim>().get(), {}, {}, {}};
        body.placed.lattice = {source.spacing(model.resolution), origin(source, domain)};
        for (int k = 0; k < Dim; ++k)
            body.movable[k] =
                !source.resolution.origin && !domain.periodic[static_cast<std::size_t>(k)];
        body.surface = fill(body);
        bodies.emplace(source.name, std::move(body));
    }
    for (int axis = 0; axis < Dim; ++axis) moveLattices<Dim>(bodies, axis);

    std::map<std::string, PlacedLattice<Dim>> placed;
    for (auto& [name, body] : bodies) {
        for (int axis = 0; axis < Dim; ++axis)
            if (body.placed.moved[axis])
                body.placed.lattice = movedLattice(body.placed.lattice, axis);
        if (body.placed.moved != std::array<bool, Dim>{}) fill(body);
        placed.emplace(name, std::move(body.placed));
    }
    return placed;
}

template std::map<std::string, PlacedLattice<2>> placeLattices(const model::Case&,
                                                               const bodies::Domain<2>&);
template std::map<std::string, PlacedLattice<3>> placeLattices(const model::Case&,
                                                               const bodies::Domain<3>&);

}  // namespace sphinx::build
