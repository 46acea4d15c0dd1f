// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/phases.h"
#include "dynamics/contact/force.h"
#include "dynamics/multibody/step.h"

namespace sphinx::language {
namespace {

using namespace input;

Coordinates pointOf(const std::vector<double>& row, int dimension) {
    Coordinates point;
    point.size = dimension;
    for (int k = 0; k < dimension; ++k) point.values[k] = row[k];
    return point;
}

std::vector<Coordinates> pointsOf(const LineBlock& line) {
    std::vector<Coordinates> points;
    for (int n = 0; n < line.points; ++n) {
        const double s = static_cast<double>(n) / (line.points - 1);
        Coordinates& point = points.emplace_back(line.from);
        for (int k = 0; k < point.size; ++k)
            point.values[k] = (1 - s) * line.from.values[k] + s * line.to.values[k];
    }
    return points;
}

std::vector<Coordinates> pointsOf(const AreaBlock& area) {
    std::vector<Coordinates> points{area.from};
    for (std::size_t edge = 0; edge < area.edges.rows.size(); ++edge) {
        std::vector<Coordinates> more;
        const int n = area.points[edge];
        for (const Coordinates& base : points)
            for (int cell = 0; cell < n; ++cell) {
                Coordinates& point = more.emplace_back(base);
                for (int k = 0; k < point.size; ++k)
                    point.values[k] += (cell + 0.5) / n * area.edges.rows[edge][k];
            }
        points = std::move(more);
    }
    return points;
}

model::Body makeBody(const NamedBody& named, const Component* material, int dimension) {
    const BodyBlock& block = named.block;
    model::Body body;
    body.name = named.name;
    body.place = named.place;
    body.role = roleOf(block.kind, material);
    body.shape = block.shape;
    body.material = block.material;
    body.resolution = block.resolution.value_or(model::BodyResolution{});
    body.arrangement = block.arrangement.value_or(model::Arrangement::lattice);
    body.initial = block.initial.value_or(model::Initial{});
    for (const auto& [key, place] : named.given)
        if (key == "initial") body.initial.place = place;
    body.follows = block.follows.value_or(model::Followed{});
    for (const auto& [part, shape] : block.parts)
        body.parts.push_back({part.text, part.place, shape});
    if (block.particles) {
        model::DirectParticles& direct = body.particles.emplace();
        for (const auto& row : block.particles->rows) {
            direct.points.push_back(pointOf(row, dimension));
            direct.volumes.push_back(row.back());
        }
    }
    if (block.points)
        for (const auto& row : block.points->rows) body.points.push_back(pointOf(row, dimension));
    if (block.line) body.points = pointsOf(*block.line);
    if (block.area) body.points = pointsOf(*block.area);
    return body;
}

/// A step of the mechanism moves the particles of all its bodies.
void fillParts(const dynamics::multibody::MultibodyParameters& multibody,
               std::vector<Component>& methods) {
    using Parameters = dynamics::multibody::StepParameters;
    for (Component& method : methods) {
        if (!method.find<Parameters>()) continue;
        auto filled = std::make_shared<Parameters>();
        for (const auto& [name, body] : multibody.bodies)
            filled->parts.insert(filled->parts.end(), body.particles.begin(), body.particles.end());
        method.parameters = std::move(filled);
    }
}

/// A body that does not say with whom is in contact with all that its topology says.
void fillContacts(const model::Case& model, std::vector<Component>& methods) {
    using Parameters = dynamics::contact::ForceParameters;
    for (Component& method : methods) {
        const auto* given = method.find<Parameters>();
        if (!given || !given->with.empty()) continue;
        auto filled = std::make_shared<Parameters>(*given);
        for (const model::Seen& seen : model.seenBy(given->body.text))
            if (seen.as == model::SeenAs::contact)
                filled->with.push_back({seen.body.text, given->body.place});
        method.parameters = std::move(filled);
    }
}

}  // namespace

model::Case makeModel(const CaseBlock& block, const UnitSystem& units, Diagnostics& diagnostics) {
    model::Case model;
    model.title = block.title;
    model.dimension = block.dimension;
    model.units = units;
    model.resolution = block.resolution;
    model.domain = block.domain;
    model.shapes = buildShapes(block.geometry, block.dimension, diagnostics);
    model.materials = block.materials;
    for (const NamedBody& body : block.bodies)
        model.bodies.push_back(makeBody(
            body, findComponent(block.materials, body.block.material.text), block.dimension));
    for (const auto& [body, sees] : block.topology) {
        model::Sight& sight = model.topology.emplace_back();
        sight.body = body;
        for (model::Seen seen : sees) {
            if (seen.body.text == "self") seen.body.text = body.text;
            sight.sees.push_back(std::move(seen));
        }
    }
    model.multibody = block.multibody;
    model.dynamics = block.dynamics;
    if (block.multibody) fillParts(*block.multibody, model.dynamics);
    fillContacts(model, model.dynamics);
    model.loop = block.loop;
    for (const NamedOutput& output : block.outputs) {
        model::Output& made = model.outputs.emplace_back();
        static_cast<Component&>(made) = output;
        made.every = output.block.every.value_or(Every{});
    }
    return model;
}

}  // namespace sphinx::language
