// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/changes.h"
#include "case/language/read.h"
#include "case/language/types.h"
#include "case/model/smoothing.h"
#include "input/declaration/reader.h"
#include "input/expressions/expression_parser.h"

#include <fmt/format.h>

namespace sphinx::language {
namespace {

using namespace input;

void registerKernels(Registry& registry) {
    struct NoParameters {};
    const auto declare = [&](kernels::KernelType type, const char* summary, const char* formula,
                             const char* source) {
        auto& d = registry.declare<NoParameters>(Kind::kernel, kernels::kernelName(type));
        d.summary(summary).formula(formula).cite(source).builder(type);
    };
    declare(kernels::KernelType::wendland_c2, "Wendland C2, reach 2h; does not pair up",
            "(1 - q/2)^4 (2q + 1)", "Wendland 1995");
    declare(kernels::KernelType::cubic_spline, "Cubic spline (M4), reach 2h",
            "((2 - q)^3 - 4 (1 - q)^3)/4 with positive parts", "Monaghan & Lattanzio 1985");
    declare(kernels::KernelType::quintic_spline, "Quintic spline (M6), reach 3h",
            "(3 - q)^5 - 6 (2 - q)^5 + 15 (1 - q)^5 with positive parts", "Morris, Fox & Zhu 1997");
}

void declareVariables(Registry& registry) {
    struct NoParameters {};
    auto& d = registry.declare<NoParameters>(Kind::block, "variables");
    d.summary(
        "Names for numbers, quantities (number, blank, unit) and expressions, in any order; one "
        "that "
        "depends on x, y, z or t may stand where they may");
    d.formula(expressionHelp());
}

void declareUnits(Registry& registry) {
    using P = UnitSystem;
    auto& d = registry.declare<P>(Kind::block, "units");
    d.summary("Units of every number without unit, or none; default: SI");
    d.formula("units: " + unitNames() + "; powers, products and quotients of them: kg/m^3, Pa*s");
    d.optional("length", &P::length, text(), "unit of length");
    d.optional("time", &P::time, text(), "unit of time");
    d.optional("mass", &P::mass, text(), "unit of mass");
    const auto check = [&](const char* name, std::string P::*member, Dimension dimension) {
        d.check(name, [name, member, dimension](const P& p) -> std::string {
            const std::string& text = p.*member;
            const auto unit = parseUnit(text);
            if (!unit) return "'" + text + "' is not a unit" + suggestUnit(text);
            if (unit->dimension == dimension && text.find_first_of("*/^") == std::string::npos)
                return "";
            return "'" + text + "' is not a unit of " + name;
        });
    };
    check("length", &P::length, unit::length);
    check("time", &P::time, unit::time);
    check("mass", &P::mass, unit::mass);
}

std::string ratioText() {
    using kernels::KernelType;
    const auto ratio = [](bodies::Role role, KernelType kernel) {
        return model::defaultSmoothingRatio(role, kernel);
    };
    return fmt::format(
        "smoothing length h / dp of all bodies that state none; default: {} of elastic bodies, of "
        "others {} with quintic_spline, {} with wendland_c2, {} with cubic_spline",
        ratio(bodies::Role::elastic, KernelType::wendland_c2),
        ratio(bodies::Role::fluid, KernelType::quintic_spline),
        ratio(bodies::Role::fluid, KernelType::wendland_c2),
        ratio(bodies::Role::fluid, KernelType::cubic_spline));
}

void declareResolution(Registry& registry) {
    using P = model::Resolution;
    auto& d = registry.declare<P>(Kind::block, "resolution");
    d.summary("Distance of the particles and what they see of each other");
    d.required("spacing", &P::spacing, number(unit::length).above(0),
               "reference distance of neighboring particles dp");
    d.optional("smoothing_ratio", &P::smoothing_ratio, number(unit::none).atLeast(0.8).atMost(4),
               ratioText());
    d.optional("kernel", &P::kernel, kernel(registry),
               "smoothing kernel of all bodies; default: quintic_spline, of elastic bodies and "
               "where only a smoothing_ratio is stated wendland_c2");
    d.optional("precision", &P::precision,
               choice<Precision>({
                   {"single", Precision::single,
                    "32-bit numbers, of exact differences of places and with exact sums"},
                   {"double", Precision::full,
                    "64-bit numbers: for comparisons of runs that differ by rounding; takes "
                    "a third longer"},
               }),
               "of the terms between two particles of a fluid");
}

void declareDomain(Registry& registry) {
    using P = model::Domain;
    auto& d = registry.declare<P>(Kind::block, "domain");
    d.summary("Where particles may be");
    d.optional(
        "lower", &P::lower, coordinates(unit::length),
        "corner of the smallest coordinates; default: that of all shapes, less their largest "
        "extent as room for splashes");
    d.optional("upper", &P::upper, coordinates(unit::length),
               "corner of the largest coordinates; default: likewise");
    d.optional("periodic", &P::periodic, axes(), "axes along which the domain repeats");
    d.optional("lost_particles", &P::lost,
               choice<bodies::LostParticles>(
                   {{"stop", bodies::LostParticles::stop, "the run ends with exit code 3"},
                    {"remove", bodies::LostParticles::remove,
                     "go on without it, counted in the mass balance; only of fluids"}}),
               "what happens when a particle leaves the domain");
    d.check("upper", [](const P& p, const UnitSystem& units) -> std::string {
        if (!p.lower || !p.upper) return "";
        for (int k = 0; k < p.lower->size; ++k)
            if (p.lower->values[k] >= p.upper->values[k])
                return fmt::format("upper is {0}{2} but must be above lower, {1}{2}",
                                   p.upper->values[k], p.lower->values[k],
                                   units.suffix(unit::length));
        return "";
    });
}

void declareBody(Registry& registry) {
    {
        using P = model::BodyResolution;
        auto& d = registry.declare<P>(Kind::block, "bodies.resolution");
        d.summary("Particle spacing of one body");
        d.optional("level", &P::level, integer().atLeast(0).atMost(10),
                   "the spacing is the reference spacing / 2^level");
        d.optional("spacing", &P::spacing, number(unit::length).above(0),
                   "the spacing itself, instead of a level");
        d.optional("smoothing_ratio", &P::smoothing_ratio,
                   number(unit::none).atLeast(0.8).atMost(4),
                   "h / dp; default: that of the case (resolution.smoothing_ratio)");
        d.optional(
            "origin", &P::origin, coordinates(unit::length),
            "a point that faces of lattice cells meet; default: the origin of coordinates (half a "
            "spacing from it where points would fall on opposite faces), along a periodic axis the "
            "lower bound of the domain");
        d.check("spacing", [](const P& p) -> std::string {
            return p.spacing && p.level ? "give level or spacing, not both" : "";
        });
    }
    {
        using P = model::Initial;
        auto& d = registry.declare<P>(Kind::block, "bodies.initial");
        d.summary("Values at the start, constants or expressions of x, y, z; otherwise zero");
        d.optional("velocity", &P::velocity, fieldVector(unit::velocity),
                   "velocity; of a rigid body that nothing moves, which stands still: that of its "
                   "surface, which slides along itself and drags fluids (a lid, a turning "
                   "cylinder)");
        d.optional("pressure", &P::pressure, fieldExpression(unit::pressure),
                   "pressure of a fluid; density and mass follow from it");
    }
    {
        using P = LineBlock;
        auto& d = registry.declare<P>(Kind::block, "bodies.line");
        d.summary("Observer points on a line, both ends included");
        d.required("from", &P::from, coordinates(unit::length), "first point");
        d.required("to", &P::to, coordinates(unit::length), "last point");
        d.required("points", &P::points, integer().atLeast(2).atMost(1'000'000),
                   "number of points");
    }
    {
        using P = AreaBlock;
        auto& d = registry.declare<P>(Kind::block, "bodies.area");
        d.summary("Observer points in the cells of a grid: a sensor with an extent (2D: a length)");
        d.required("from", &P::from, coordinates(unit::length), "corner");
        d.required("edges", &P::edges, table(unit::length),
                   "vectors of the edges: 1 in 2D, 2 in 3D");
        d.required("points", &P::points, list(integer().atLeast(1).atMost(10'000)),
                   "number of points along each edge");
    }
    using P = BodyBlock;
    auto& d = registry.declare<P>(Kind::block, "bodies");
    d.summary("One entry of bodies: particles with a material, or points that observe");
    d.required("kind", &P::kind,
               choice<BodyKind>({{"fluid", BodyKind::fluid, ""},
                                 {"solid", BodyKind::solid, "rigid or elastic by its material"},
                                 {"observer", BodyKind::observer, "looks and does not act"}}),
               "what it is");
    d.optional("shape", &P::shape, shapeReference(), "where particles are made");
    d.optional("material", &P::material, materialReference(), "law of the material");
    d.optional("particles", &P::particles, table(unit::length, unit::volume),
               "particles one by one, coordinates and volume (2D: area), instead of a lattice");
    d.optional("arrangement", &P::arrangement,
               choice<model::Arrangement>(
                   {{"lattice", model::Arrangement::lattice,
                     "the points of a square (cubic) lattice inside the shape, each with the "
                     "volume of a cell"},
                    {"jittered", model::Arrangement::jittered,
                     "of a fluid: those points, each displaced at random by up to a quarter of a "
                     "spacing along each axis, in the same way in every run"},
                    {"relaxed", model::Arrangement::relaxed,
                     "fitted to the surface of the shape: moved from the lattice until the "
                     "outermost row stands half a spacing inside and all are spread evenly; "
                     "together they have the volume of the shape"}}),
               "how the particles stand in the shape; default: lattice");
    const auto block = [&](const char* name) -> const Declaration& {
        return *registry.find(Kind::block, name);
    };
    d.optional("resolution", &P::resolution,
               structure<model::BodyResolution>(block("bodies.resolution")), "particle spacing");
    d.optional("initial", &P::initial, structure<model::Initial>(block("bodies.initial")),
               "values at the start");
    d.optional("parts", &P::parts, mapOf(newName(), shapeReference()),
               "named sets of particles: those inside a shape");
    d.optional("points", &P::points, table(unit::length), "observer: points");
    d.optional("line", &P::line, structure<LineBlock>(block("bodies.line")), "observer: a line");
    d.optional("area", &P::area, structure<AreaBlock>(block("bodies.area")), "observer: an area");
    d.optional("follows", &P::follows, followed(), "observer: whether it moves, and with what");
}

void declareLoop(Registry& registry) {
    {
        using P = model::Step;
        auto& d = registry.declare<P>(Kind::block, "run");
        d.summary("A line of the loop that does not act in every step");
        d.required("run", &P::run, actionReference(), "METHOD or METHOD.ACTION");
        d.optional("every", &P::every, every(registry), "how often; without: in every step");
        d.optional("from", &P::from, number(unit::time),
                   "it acts in the steps of its layer that begin at this time or later");
        d.optional("until", &P::until, number(unit::time),
                   "it acts in the steps of its layer that begin before this time; a wall that it "
                   "moved then stands still");
        d.check("", [](const P& p) -> std::string {
            return p.every || p.from || p.until
                       ? ""
                       : "a line with 'run' needs at least one of every, from and until";
        });
        d.check("until", [](const P& p, const UnitSystem& units) -> std::string {
            return !p.from || !p.until || *p.until > *p.from
                       ? ""
                       : fmt::format("until is {0}{2} but must be above from, {1}{2}", *p.until,
                                     *p.from, units.suffix(unit::time));
        });
    }
    const auto fit =
        choice<loop::Fit>({{"split", loop::Fit::split, "equal substeps, none above the estimate"},
                           {"clip", loop::Fit::clip, "estimates, the last one cut"},
                           {"overshoot", loop::Fit::overshoot,
                            "estimates; the parent's step becomes what was covered"}});
    {
        using P = model::Layer;
        auto& d = registry.declare<P>(Kind::block, "layer");
        d.summary("Covers the step of its parent layer with substeps");
        d.required("layer", &P::name, newName(), "name in logs and in the profile");
        d.required("dt", &P::dt, timeStep(), "size of a substep");
        d.optional("fit", &P::fit, fit, "how the substeps fill the parent's step");
        d.required("steps", &P::steps, list(step(registry)), "what a substep does, in order");
    }
    using P = model::Loop;
    auto& d = registry.declare<P>(Kind::block, "loop");
    d.summary("What happens when: the outermost layer and what precedes it");
    d.optional("start_time", &P::start_time, number(unit::time), "time at the start");
    d.required("end_time", &P::end_time, number(unit::time),
               "the run ends after the first outermost step that reaches it");
    d.optional("start", &P::start, list(step(registry)), "done once, before the first step");
    d.required("layer", &P::name, newName(), "name of the outermost layer");
    d.required("dt", &P::dt, timeStep(), "size of an outermost step");
    d.required("steps", &P::steps, list(step(registry)), "what an outermost step does, in order");
    d.check("end_time", [](const P& p, const UnitSystem& units) -> std::string {
        return p.end_time > p.start_time
                   ? ""
                   : fmt::format("end_time is {0}{2} but must be above start_time, {1}{2}",
                                 p.end_time, p.start_time, units.suffix(unit::time));
    });
}

void declareCase(Registry& registry) {
    const auto block = [&](const char* name) -> const Declaration& {
        return *registry.find(Kind::block, name);
    };
    {
        using P = OutputBlock;
        auto& d = registry.declare<P>(Kind::block, "outputs");
        d.summary("Keys that every entry of outputs has, besides those of its type");
        d.optional("every", &P::every, every(registry),
                   "how often; without: at the start and at the end");
    }
    using P = CaseBlock;
    auto& d = registry.declare<P>(Kind::block, "case");
    d.summary("A case: what is simulated, and how");
    d.required("sphinx", &P::version, integer().atLeast(1).atMost(language_version),
               "version of the language");
    d.optional("title", &P::title, text(), "for people");
    // The order matters from here: these are needed to read what follows.
    d.required("dimension", &P::dimension,
               Type<int>(withEffect(choice<int>({{"2", 2, ""}, {"3", 3, ""}}).base(),
                                    [](Reader& reader, const void* value) {
                                        reader.dimension = *static_cast<const int*>(value);
                                    })),
               "dimension of space");
    d.optional("units", &P::units,
               Type<std::optional<UnitSystem>>(withEffect(
                   wordOr("none", structure<UnitSystem>(block("units"))).base(),
                   [](Reader& reader, const void* value) {
                       const auto& units = *static_cast<const std::optional<UnitSystem>*>(value);
                       if (units) reader.units = *units;
                       reader.units.none = !units;
                   })),
               "of numbers without unit");
    d.optional("include", &P::include, list(text()),
               "files whose maps are merged into this one, which wins");
    d.optional("variables", &P::variables, variables(), "numbers for expressions");
    d.optional("tables", &P::tables, namedTables(block("tables")),
               "functions of one argument for expressions");
    d.required("resolution", &P::resolution, structure<model::Resolution>(block("resolution")),
               "spacing and kernel");
    d.optional("domain", &P::domain, structure<model::Domain>(block("domain")), "bounds");
    d.optional("geometry", &P::geometry, namedShapes(), "named shapes");
    d.optional("materials", &P::materials, components(Kind::material), "named materials");
    d.required("bodies", &P::bodies, namedBodies(block("bodies")), "named bodies");
    d.optional("topology", &P::topology, mapOf(bodyReference(), list(seen())),
               "whose particles each body sees");
    d.optional("multibody", &P::multibody,
               structure<dynamics::multibody::MultibodyParameters>(block("multibody")),
               "rigid bodies and their joints");
    d.optional("dynamics", &P::dynamics, components(Kind::dynamics), "named methods that can act");
    d.required("loop", &P::loop, structure<model::Loop>(block("loop")), "what acts, and when");
    d.optional("outputs", &P::outputs, outputs(block("outputs")), "what is written");
}

}  // namespace

void registerCaseLanguage(Registry& registry) {
    registerKernels(registry);
    registerShapes(registry);
    declareUnits(registry);
    declareVariables(registry);
    declareTables(registry);
    declareResolution(registry);
    declareDomain(registry);
    declareBody(registry);
    declareEvery(registry);
    declareLoop(registry);
    declareMultibody(registry);
    declareCase(registry);
}

}  // namespace sphinx::language
