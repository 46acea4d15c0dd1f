// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check/rows.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace sphinx::check {
namespace {

constexpr double thin_part = 0.1;
/// No beam of so many bends otherwise than it should.
constexpr std::size_t many_rows = 100;

template <int Dim>
struct Cell {
    std::array<std::int64_t, Dim> place;  // on the lattice
    std::size_t rows;                     // of the shortest line through it
};

/// The cells that particles of the piece are in, each once.
template <int Dim>
std::vector<Cell<Dim>> cellsOf(const bodies::Body<Dim>& body) {
    std::vector<Cell<Dim>> cells;
    const Vec<Dim> origin = body.particles.position()[0];
    for (const bodies::Body<Dim>* piece : body.piece())
        for (std::size_t i = 0; i < piece->size(); ++i) {
            const Vec<Dim> x = (piece->particles.position()[i] - origin) / body.spacing;
            Cell<Dim>& cell = cells.emplace_back(Cell<Dim>{{}, ~std::size_t{0}});
            for (int k = 0; k < Dim; ++k)
                cell.place[static_cast<std::size_t>(k)] = std::llround(x[k]);
        }
    std::ranges::sort(cells, {}, &Cell<Dim>::place);
    const auto same = std::ranges::unique(cells, {}, &Cell<Dim>::place);
    cells.erase(same.begin(), same.end());
    return cells;
}

/// Takes account of the lines along an axis.
template <int Dim>
void countAlong(std::size_t axis, std::vector<Cell<Dim>>& cells) {
    const auto turned = [&](const Cell<Dim>& cell) {  // the axis last
        auto place = cell.place;
        std::rotate(place.begin() + static_cast<std::ptrdiff_t>(axis),
                    place.begin() + static_cast<std::ptrdiff_t>(axis) + 1, place.end());
        return place;
    };
    std::ranges::sort(cells, {}, turned);
    for (auto first = cells.begin(); first != cells.end();) {
        auto next = first + 1;
        for (auto place = turned(*first);; ++next) {
            ++place.back();
            if (next == cells.end() || turned(*next) != place) break;
        }
        const auto rows = static_cast<std::size_t>(next - first);
        for (; first != next; ++first) first->rows = std::min(first->rows, rows);
    }
}

/// Spacings that a line along the normal through a particle is long within the piece.
template <int Dim>
std::size_t rowsThrough(const std::vector<const bodies::Body<Dim>*>& piece,
                        const bodies::Body<Dim>& body, const Vec<Dim>& x) {
    const auto inside = [&](const Vec<Dim>& y) {
        return std::ranges::any_of(piece, [&](const auto* one) { return one->shape->contains(y); });
    };
    const Vec<Dim> normal = body.shape->normal(x);
    std::size_t rows = 1;
    for (const double way : {-body.spacing, body.spacing})
        for (int k = 1; rows < many_rows && inside(x + k * way * normal); ++k) ++rows;
    return rows;
}

/// Of a body whose particles stand in no lattice: the same along the normals of its surface.
template <int Dim>
std::size_t fittedRowsAcross(const bodies::Body<Dim>& body) {
    const auto piece = body.piece();
    std::vector<std::size_t> rows;
    for (const bodies::Body<Dim>* one : piece)
        for (std::size_t i = 0; i < one->size(); ++i)
            rows.push_back(rowsThrough(piece, *one, one->particles.position()[i]));
    const auto place =
        rows.begin() + static_cast<std::ptrdiff_t>(thin_part * static_cast<double>(rows.size()));
    std::ranges::nth_element(rows, place);
    return *place;
}

}  // namespace

template <int Dim>
std::size_t rowsAcross(const bodies::Body<Dim>& body) {
    if (body.size() == 0) return 0;
    const auto piece = body.piece();
    if (!body.on_lattice &&
        std::ranges::all_of(piece, [](const auto* one) { return one->shape != nullptr; }))
        return fittedRowsAcross(body);
    std::vector<Cell<Dim>> cells = cellsOf(body);
    for (std::size_t axis = 0; axis < Dim; ++axis) countAlong(axis, cells);
    const auto place =
        cells.begin() + static_cast<std::ptrdiff_t>(thin_part * static_cast<double>(cells.size()));
    std::ranges::nth_element(cells, place, {}, &Cell<Dim>::rows);
    return place->rows;
}

template <int Dim>
double bendingError(std::size_t rows, const bodies::Body<Dim>& body) {
    // Row by row: the particles at the faces know the strain of a place further inside, the more so
    // the larger the smoothing length.
    const auto n = static_cast<double>(rows);
    const double ratio = body.kernel.smoothingLength() / body.spacing;
    const double soft = (0.45 + 2.2 * (1 - std::exp((0.85 - ratio) / 0.36))) / std::pow(n, 1.75);
    // What hardly changes its volume cannot bend particle by particle.
    const materials::ElasticSolid& solid = *body.elastic().material;
    const double lambda = solid.bulkModulus() - 2. / 3 * solid.shearModulus();
    const double locking = 1.1 * std::max(0., lambda / solid.shearModulus()) / (n * n * n * n);
    return (1 + soft) / (1 + locking) - 1;
}

std::string bendingText(std::size_t rows, double error) {
    const std::string across = fmt::format("{} row{} across: bending ", rows, rows == 1 ? "" : "s");
    if (std::abs(error) < 0.01) return across + "within 1 %";
    return across +
           fmt::format("about {:.0f} % {}", 100 * std::abs(error), error > 0 ? "soft" : "stiff");
}

template std::size_t rowsAcross(const bodies::Body<2>&);
template std::size_t rowsAcross(const bodies::Body<3>&);
template double bendingError(std::size_t, const bodies::Body<2>&);
template double bendingError(std::size_t, const bodies::Body<3>&);

}  // namespace sphinx::check
