// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/observe.h"

#include "core/exact_total.h"
#include "io/file/compress.h"
#include "io/series/columns.h"
#include "io/series/rows_output.h"
#include "measure/observe_carried.h"
#include "measure/observe_elevation.h"
#include "measure/observe_material.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace sphinx::measure {

template <int Dim>
ObserveSource<Dim>::ObserveSource(std::unique_ptr<ObserveWeights<Dim>> weights,
                                  std::vector<std::vector<const particles::FieldBase*>> fields,
                                  bool mean, const input::UnitSystem& units)
    : weights_(std::move(weights)), fields_(std::move(fields)), mean_(mean) {
    const std::size_t points = mean ? 1 : weights_->points();
    const auto add = [&](std::string_view name, particles::Rank rank, Dimension unit,
                         std::string text) {
        quantities_.push_back({std::string(name), units.text(unit), std::move(text),
                               io::pointLabels(points, io::componentLabels<Dim>(rank))});
    };
    for (const std::vector<const particles::FieldBase*>& field : fields_) {
        const particles::FieldInfo& info = field.front()->info();
        add(info.name, info.rank, info.unit, std::string(info.doc));
    }
    add("coverage", particles::Rank::scalar, unit::none, "sum of V_j W_ij over the particles seen");
    add("position", particles::Rank::vector, unit::length, "of the points");
}

template <int Dim>
void ObserveSource<Dim>::addRow(const std::vector<double>& values, std::size_t components,
                                std::span<double>& row) {
    if (!mean_) {
        std::copy(values.begin(), values.end(), row.begin());
        row = row.subspan(values.size());
        return;
    }
    for (std::size_t c = 0; c < components; ++c) {
        double sum = 0;
        std::size_t present = 0;
        for (std::size_t k = c; k < values.size(); k += components) {
            if (std::isnan(values[k])) continue;
            sum += values[k];
            ++present;
        }
        row[c] = present > 0 ? sum / static_cast<double>(present) : nan_value;
    }
    row = row.subspan(components);
}

template <int Dim>
void ObserveSource<Dim>::sample(const Clock&, std::span<double> row) {
    weights_->update();
    const std::size_t points = weights_->points();
    for (const std::vector<const particles::FieldBase*>& field : fields_) {
        const particles::FieldInfo& info = field.front()->info();
        const auto width = static_cast<std::size_t>(field.front()->components());
        values_.assign(points * width, 0);
        for (std::size_t point = 0; point < points; ++point) {
            double* value = values_.data() + point * width;
            const std::vector<ParticleWeight>& weights = weights_->of(point);
            for (std::size_t c = 0; c < width; ++c) {
                // Matrices stand in memory column by column.
                const std::size_t source =
                    info.rank == particles::Rank::matrix ? c % Dim * Dim + c / Dim : c;
                ExactTotal total;
                for (const ParticleWeight& one : weights)
                    total.add(one.weight *
                              field[one.body]->numbers()[width * one.particle + source]);
                value[c] = weights.empty() ? nan_value : total.value();
            }
        }
        addRow(values_, width, row);
    }
    values_.clear();
    for (std::size_t point = 0; point < points; ++point)
        values_.push_back(weights_->coverage(point));
    addRow(values_, 1, row);
    values_.clear();
    for (std::size_t point = 0; point < points; ++point)
        for (int k = 0; k < Dim; ++k) values_.push_back(weights_->position(point)[k]);
    addRow(values_, Dim, row);
}

namespace {

enum class ObservedQuantity { surface_elevation };

struct ObserveParameters : io::MeanParameters {
    input::Name observer;
    std::vector<input::Name> fields;
    std::optional<ObservedQuantity> quantity;
    bool mean = false;
};

template <int Dim>
std::vector<std::vector<const particles::FieldBase*>> observedFields(
    const ObserveParameters& p, const bodies::Body<Dim>& observer) {
    std::vector<std::vector<const particles::FieldBase*>> fields;
    for (auto name = p.fields.begin(); name != p.fields.end(); ++name) {
        if (std::find(p.fields.begin(), name, *name) != name)
            io::failAt(name->place, "the field '" + name->text + "' is named twice");
        if (name->text == fields::position.name)
            io::failAt(name->place, "the position of the points is always written");
        std::vector<const particles::FieldBase*>& field = fields.emplace_back();
        for (const bodies::Body<Dim>* body : observer.sees) {
            field.push_back(&io::fieldOf(*body, *name));
            if (field.back()->info().rank == particles::Rank::integer)
                io::failAt(name->place, "'" + name->text + "' cannot be interpolated");
        }
    }
    return fields;
}

/// Tells points and seen bodies, both free to change between a run and its resumption.
template <int Dim>
std::string lookedAt(const bodies::Body<Dim>& observer) {
    std::string text;
    for (std::size_t i = 0; i < observer.size(); ++i)
        for (int k = 0; k < Dim; ++k)
            text += fmt::format("{:a} ", observer.particles.position()[i][k]);
    for (const bodies::Body<Dim>* body : observer.sees) text += body->name + " ";
    return fmt::format("{:016x}", io::fingerprint(text));
}

template <int Dim>
std::unique_ptr<Output> makeObserve(const ObserveParameters& p, const input::Component& component,
                                    const io::OutputContext<Dim>& context) {
    bodies::Body<Dim>& observer = *context.world.find(p.observer.text);
    const io::Follower<Dim>* follower = context.follower(observer);
    const std::string followed = !follower          ? ""
                                 : !follower->solid ? "the material"
                                 : follower->part
                                     ? follower->solid->name + "." + follower->part->name
                                     : follower->solid->name;
    if (observer.sees.empty())
        io::failAt(p.observer.place,
                   "the observer '" + observer.name + "' sees no body; name some in topology");
    if (p.quantity) {
        if (follower && !follower->solid)
            io::failAt(p.observer.place,
                       "the elevation of the surface is observed at points fixed in space, or "
                       "carried along by a rigid body, but '" +
                           observer.name + "' follows " + followed);
        return io::makeRowsOutput(
            component, context,
            {p, "surface_elevation at " + (follower ? followed + " " : "") + lookedAt(observer)},
            makeElevationSource(observer, follower, p.observer.place, context));
    }
    std::vector<std::vector<const particles::FieldBase*>> fields = observedFields(p, observer);
    std::unique_ptr<ObserveWeights<Dim>> weights;
    if (follower && follower->solid)
        weights = std::make_unique<CarriedWeights<Dim>>(observer, *follower, context.relations,
                                                        context.world);
    else if (follower)
        weights = std::make_unique<MaterialWeights<Dim>>(observer, context.relations,
                                                         context.world.domain);
    else
        weights = std::make_unique<ObserveWeights<Dim>>(observer, context.relations);
    return io::makeRowsOutput(
        component, context,
        {p, (follower ? "points of " + followed + " " : "points in space ") + lookedAt(observer)},
        std::make_unique<ObserveSource<Dim>>(std::move(weights), std::move(fields), p.mean,
                                             context.units));
}

}  // namespace

void declareObserve(input::Registry& registry) {
    using P = ObserveParameters;
    auto& d = registry.declare<P>(input::Kind::output, "observe");
    d.summary(
        "Time series of fields, or of the height of the surface, at the points of an observer");
    d.formula(
        "f(x) = sum_j V_j W_j f_j / coverage, coverage = sum_j V_j W_j over the bodies that the "
        "observer sees; without a particle near, f is NaN and the coverage 0");
    d.required("observer", &P::observer, input::bodyReference({"observer"}), "where to look");
    d.optional("fields", &P::fields, input::list(input::fieldReference()),
               "of the bodies that the observer sees");
    d.optional("quantity", &P::quantity,
               input::choice<ObservedQuantity>({
                   {"surface_elevation", ObservedQuantity::surface_elevation,
                    "height against gravity, or along the last axis without it, at which the part "
                    "of space that fluid fills falls through 1/2; points above each other are one "
                    "gauge"},
               }),
               "something else than fields");
    d.optional("mean", &P::mean, input::boolean(),
               "one mean over all points, those without a particle near left out: a sensor's area");
    io::declareMeans(d);
    d.check("observer", [](const P& p) -> std::string {
        return p.fields.empty() == p.quantity.has_value() ? ""
                                                          : "an observer needs either 'fields' or "
                                                            "'quantity'";
    });
    d.check("mean", [](const P& p) -> std::string {
        return p.mean && p.quantity ? "'mean' is for fields" : "";
    });
    d.builder(io::outputFactory<P>([]<int Dim>(const P& p, const input::Component& component,
                                               const io::OutputContext<Dim>& context) {
        return makeObserve(p, component, context);
    }));
}

template class ObserveSource<2>;
template class ObserveSource<3>;

}  // namespace sphinx::measure
