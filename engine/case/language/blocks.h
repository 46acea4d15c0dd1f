// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The blocks of a case as they are written, before they become a model.

#include "case/language/shapes.h"
#include "case/language/tables.h"
#include "case/model/model.h"
#include "dynamics/multibody/parameters.h"
#include "input/declaration/registry.h"

namespace sphinx::language {

struct LineBlock {
    input::Coordinates from, to;
    int points = 2;
};

struct AreaBlock {
    input::Coordinates from;
    input::Table edges;
    std::vector<int> points;
};

enum class BodyKind { fluid, solid, observer };

struct BodyBlock {
    BodyKind kind = BodyKind::fluid;
    input::Name shape;
    input::Name material;
    std::optional<model::BodyResolution> resolution;
    std::optional<model::Arrangement> arrangement;
    std::optional<model::Initial> initial;
    std::vector<std::pair<input::Name, input::Name>> parts;
    std::optional<input::Table> particles;
    std::optional<input::Table> points;
    std::optional<LineBlock> line;
    std::optional<AreaBlock> area;
    std::optional<model::Followed> follows;
};

/// An entry of `bodies`.
struct NamedBody {
    std::string name;
    input::Place place;
    std::vector<std::pair<std::string, input::Place>> given;  ///< keys that were written
    BodyBlock block;
    bool good = false;  ///< it was read without an error
};

struct OutputBlock {
    std::optional<input::Every> every;
};

/// An entry of `outputs`.
struct NamedOutput : input::Component {
    OutputBlock block;
};

/// The whole file.
struct CaseBlock {
    int version = 1;
    std::string title;
    int dimension = 2;
    std::optional<input::UnitSystem> units = input::UnitSystem{};  ///< empty: none
    std::vector<std::string> include;  ///< already merged when the block is read
    input::Node variables;             ///< once read: those that the resolved case needs
    std::vector<NamedTable> tables;    ///< likewise
    model::Resolution resolution;
    model::Domain domain;
    std::vector<NamedShape> geometry;
    std::vector<input::Component> materials;
    std::vector<NamedBody> bodies;
    std::vector<std::pair<input::Name, std::vector<model::Seen>>> topology;  ///< "self" is a body
    std::optional<dynamics::multibody::MultibodyParameters> multibody;
    std::vector<input::Component> dynamics;
    model::Loop loop;
    std::vector<NamedOutput> outputs;
};

}  // namespace sphinx::language
