// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/frames/hdf5.h"

#include "io/hdf5/reader.h"

namespace sphinx::io {

using namespace hdf5;

template <int Dim>
struct Hdf5Output<Dim>::Series {
    struct Member {
        const particles::FieldBase* field = nullptr;
        std::uint64_t fingerprint = 0;
        std::shared_ptr<StoredNode> stored;  // null: not written by this process
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

template <int Dim>
Hdf5Output<Dim>::Hdf5Output(Hdf5Parameters parameters, std::shared_ptr<ResultsFile> file,
                            std::vector<BodyFrames<Dim>> bodies)
    : parameters_(std::move(parameters)),
      file_(std::move(file)),
      gatherer_(FieldLayout::plain, parameters_.single_precision) {
    for (const BodyFrames<Dim>& frames : bodies) {
        auto series = std::make_unique<Series>();
        series->body = frames.body;
        series->members.push_back({frames.body->particles.find(fields::position.name), 0, nullptr});
        for (const particles::FieldBase* field : frameFields(frames))
            series->members.push_back({field, 0, nullptr});
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
std::shared_ptr<ChunkedArray> Hdf5Output<Dim>::store(const particles::FieldBase& field,
                                                     const particles::IdOrder& order) {
    const ArrayView view = gatherer_.gather(field, order);
    Dimensions row_shape;
    if (field.info().rank == particles::Rank::vector) row_shape = {Dim};
    if (field.info().rank == particles::Rank::matrix) row_shape = {Dim, Dim};
    auto array = std::make_shared<ChunkedArray>(numberOf(view.type), row_shape,
                                                chunkRowsFor(order.size()), true);
    array->setAttributes({{"unit", parameters_.units.text(field.info().unit)},
                          {"description", std::string(field.info().doc)}});
    array->appendChunks(file_->file(), view.bytes);
    return array;
}

template <int Dim>
void Hdf5Output<Dim>::write(const Clock& clock) {
    open();
    for (auto& series : series_) {
        const particles::IdOrder order(series->body->particles);
        Group frame;
        frame.setAttributes({{"time", clock.time}, {"step", clock.steps}});
        for (auto& member : series->members) {
            const std::uint64_t now = fieldFingerprint(*member.field, order);
            if (!member.stored || now != member.fingerprint) {
                const Address address = store(*member.field, order)->store(file_->file());
                member.stored = std::make_shared<StoredNode>(address);
                member.fingerprint = now;
            }
            frame.put(std::string(member.field->info().name), member.stored);
        }
        series->group->put(frameName("frame", frames_, ""),
                           std::make_shared<StoredNode>(frame.store(file_->file())));
        series->time->append({clock.time});
        series->step->append({clock.steps});
        series->frame->append({frames_});
    }
    file_->commit(true);
    ++frames_;
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
