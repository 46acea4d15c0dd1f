// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/frames/hdf5.h"

#include "io/hdf5/reader.h"

#include <optional>

namespace sphinx::io {

using namespace hdf5;

template <int Dim>
struct Hdf5Output<Dim>::Series {
    struct Member {
        const particles::FieldBase* field = nullptr;
        LastCopy last{};
        std::shared_ptr<StoredNode> stored{};  // for the thread that writes, like all below
    };

    const bodies::Body<Dim>* body = nullptr;
    std::vector<Member> members;
    std::shared_ptr<Group> group;
    std::shared_ptr<SmallArray> time, step, frame;

    void makeGroup(const std::string& time_unit) {
        group = std::make_shared<Group>();
        time = group->put("time", std::make_shared<SmallArray>(Number::float64, Dimensions{}));
        step = group->put("step", std::make_shared<SmallArray>(Number::int64, Dimensions{}));
        frame = group->put("frame", std::make_shared<SmallArray>(Number::int64, Dimensions{}));
        time->setAttributes({{"unit", time_unit}, {"description", "time of each frame"}});
        step->setAttributes({{"description", "outermost steps before each frame"}});
        frame->setAttributes({{"description", "number of each frame, as in its group's name"}});
    }
};

/// The arrays of a body; those that have not changed are in the file.
template <int Dim>
struct Hdf5Output<Dim>::Frame {
    std::size_t particles = 0;
    std::vector<std::optional<ArrayCopy>> arrays;  // of all members
};

template <int Dim>
Hdf5Output<Dim>::Hdf5Output(Hdf5Parameters parameters, std::shared_ptr<ResultsFile> file,
                            std::vector<BodyFrames<Dim>> bodies)
    : parameters_(std::move(parameters)), file_(std::move(file)) {
    for (const BodyFrames<Dim>& frames : bodies) {
        auto series = std::make_unique<Series>();
        series->body = frames.body;
        series->members.push_back({frames.body->particles.find(fields::position.name)});
        for (const particles::FieldBase* field : frameFields(frames))
            series->members.push_back({field});
        series->makeGroup(parameters_.units.text(unit::time));
        series_.push_back(std::move(series));
    }
}

template <int Dim>
Hdf5Output<Dim>::~Hdf5Output() = default;

template <int Dim>
std::vector<OutputFile> Hdf5Output<Dim>::files() const {
    std::vector<OutputFile> files;
    for (const auto& series : series_) {
        std::vector<const particles::FieldBase*> fields;
        for (const auto& member : series->members) fields.push_back(member.field);
        files.push_back({"results.h5:bodies/" + series->body->name,
                         frameBytes(fields, series->body->size(), parameters_.single_precision)});
    }
    return files;
}

template <int Dim>
void Hdf5Output<Dim>::open() {
    if (open_) return;
    file_->open();
    for (auto& series : series_) file_->bodies().put(series->body->name, series->group);
    open_ = true;
}

template <int Dim>
std::shared_ptr<ChunkedArray> Hdf5Output<Dim>::store(const particles::FieldInfo& field,
                                                     const ArrayCopy& values,
                                                     std::size_t particles) {
    Dimensions row_shape;
    if (field.rank == particles::Rank::vector) row_shape = {Dim};
    if (field.rank == particles::Rank::matrix) row_shape = {Dim, Dim};
    auto array = std::make_shared<ChunkedArray>(numberOf(values.type), row_shape,
                                                chunkRowsFor(particles), true);
    array->setAttributes(
        {{"unit", parameters_.units.text(field.unit)}, {"description", std::string(field.doc)}});
    array->appendChunks(file_->file(), values.bytes());
    return array;
}

template <int Dim>
FileWork Hdf5Output<Dim>::take(const Clock& clock) {
    auto frames = std::make_shared<std::vector<Frame>>();
    std::size_t bytes = 0;
    for (auto& series : series_) {
        Frame& frame = frames->emplace_back();
        const particles::IdOrder order(series->body->particles);
        frame.particles = order.size();
        for (auto& member : series->members) {
            const auto& array = frame.arrays.emplace_back(
                copyIfChanged<Dim>(*member.field, order, FieldLayout::plain,
                                   parameters_.single_precision, member.last));
            if (array) bytes += array->values.size();
        }
    }
    return {[this, frames, clock, number = frames_++] { writeFrames(*frames, clock, number); },
            bytes};
}

template <int Dim>
void Hdf5Output<Dim>::writeFrames(const std::vector<Frame>& frames, const Clock& clock,
                                  std::int64_t number) {
    open();
    for (std::size_t k = 0; k < series_.size(); ++k) {
        Series& series = *series_[k];
        Group frame;
        frame.setAttributes({{"time", clock.time}, {"step", clock.steps}});
        for (std::size_t m = 0; m < series.members.size(); ++m) {
            auto& member = series.members[m];
            const particles::FieldInfo& field = member.field->info();
            if (const auto& array = frames[k].arrays[m])
                member.stored = std::make_shared<StoredNode>(
                    store(field, *array, frames[k].particles)->store(file_->file()));
            frame.put(std::string(field.name), member.stored);
        }
        series.group->put(frameName("frame", number, ""),
                          std::make_shared<StoredNode>(frame.store(file_->file())));
        series.time->append({clock.time});
        series.step->append({clock.steps});
        series.frame->append({number});
    }
    file_->commit(true);
}

template <int Dim>
void Hdf5Output<Dim>::resume(const Clock&) {
    file_->resume();
    const Reader reader(file_->path());
    for (auto& series : series_) {
        const std::string place = "bodies/" + series->body->name;
        if (!reader.has(place)) continue;
        const std::vector<double> times = reader.numbers(place + "/time");
        const std::vector<std::int64_t> steps = reader.integers(place + "/step");
        const std::vector<std::int64_t> numbers = reader.integers(place + "/frame");
        for (const Link& link : reader.members(place)) {
            const std::int64_t number = frameNumber(link.name, "frame", "");
            if (number >= 0 && number < frames_)
                series->group->put(link.name, std::make_shared<StoredNode>(link.address));
        }
        for (std::size_t k = 0; k < std::min({times.size(), steps.size(), numbers.size()}); ++k) {
            if (numbers[k] >= frames_) break;
            series->time->append({times[k]});
            series->step->append({steps[k]});
            series->frame->append({numbers[k]});
        }
    }
    open();
    file_->commit(true);
}

template class Hdf5Output<2>;
template class Hdf5Output<3>;

}  // namespace sphinx::io
