// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/frames/vtkhdf.h"

#include "io/frames/vtkhdf_layout.h"
#include "io/hdf5/results_file.h"

#include <bit>
#include <optional>

namespace sphinx::io {

using namespace hdf5;

/// The file of one body and what was written to it last.
template <int Dim>
class VtkHdfOutput<Dim>::Series {
 public:
    Series(const FrameParameters& parameters, const BodyFrames<Dim>& frames)
        : parameters_(parameters),
          body_(frames.body),
          path_(parameters.folder / (frames.body->name + ".vtkhdf")) {
        members_.push_back({frames.body->particles.find(fields::position.name)});
        for (const particles::FieldBase* field : frameFields(frames)) members_.push_back({field});
    }

    /// The arrays of a frame; those that have not changed are in the file.
    struct Frame {
        std::size_t points = 0;
        std::vector<std::optional<ArrayCopy>> arrays;  // of all members
        std::size_t bytes = 0;
    };

    Frame take() {
        Frame frame;
        const particles::IdOrder order(body_->particles);
        frame.points = order.size();
        for (Member& member : members_) {
            const auto& array = frame.arrays.emplace_back(
                copyIfChanged<Dim>(*member.field, order, FieldLayout::padded,
                                   parameters_.single_precision, member.last));
            if (array) frame.bytes += array->values.size();
        }
        return frame;
    }

    void write(const Frame& frame, double time, std::int64_t number) {
        if (!file_) create(frame.points);
        VtkHdfStep step;
        step.time = time;
        step.frame = number;
        step.part = layout_->part(*file_, frame.points);
        for (std::size_t m = 0; m < members_.size(); ++m) {
            if (const auto& array = frame.arrays[m])
                members_[m].row = layout_->append(*file_, m, array->bytes());
            step.rows.push_back(members_[m].row);
        }
        layout_->addStep(step);
        commit(*file_, layout_->root(), true);
    }

    void resume(const Clock& clock, std::int64_t frames) {
        if (!isThere(path_)) return;
        makeLayout(body_->size());
        if (!layout_->load(path_, frames)) {
            layout_.reset();
            setAside(path_, clock.steps);
            return;
        }
        file_ = SafeFile::open(path_);
        commit(*file_, layout_->root(), true);
        const VtkHdfStep& last = layout_->lastStep();
        // The fingerprints are those of the last frame before the restart.
        if (last.frame == frames - 1)
            for (std::size_t m = 0; m < last.rows.size(); ++m)
                if (members_[m].fingerprint_known) {
                    members_[m].row = last.rows[m];
                    members_[m].last.taken = true;
                }
    }

    const std::string& name() const { return body_->name; }

    OutputFile file() const {
        std::vector<const particles::FieldBase*> fields;
        for (const Member& member : members_) fields.push_back(member.field);
        return {path_.filename().string(),
                frameBytes(fields, body_->size(), parameters_.single_precision)};
    }

    void transfer(Archive& archive) {
        for (Member& member : members_) {
            const std::string_view name = member.field->info().name;
            if (!archive.has(name)) continue;  // a resumed run may write other fields
            auto bits = std::bit_cast<std::int64_t>(member.last.fingerprint);
            archive.value(name, bits);
            member.last.fingerprint = std::bit_cast<std::uint64_t>(bits);
            member.fingerprint_known = true;
        }
    }

 private:
    struct Member {
        const particles::FieldBase* field;
        LastCopy last{};                 // taken: what the file has is what the fingerprint is of
        bool fingerprint_known = false;  // from the run that this one goes on with
        std::int64_t row = 0;            // where it was written last; for the thread that writes
    };

    void create(std::size_t points) {
        makeLayout(points);
        file_ = SafeFile::create(path_);
    }

    void makeLayout(std::size_t points) {
        std::vector<VtkHdfArray> arrays;
        for (const Member& member : members_) {
            const particles::FieldInfo& info = member.field->info();
            VtkHdfArray array;
            array.name = info.name;
            array.type = numberOf(numberType(info, parameters_.single_precision));
            array.components = componentsOf<Dim>(info.rank, FieldLayout::padded);
            array.attributes = {{"unit", parameters_.units.text(info.unit)},
                                {"description", std::string(info.doc)}};
            arrays.push_back(std::move(array));
        }
        layout_ = std::make_unique<VtkHdfLayout>(std::move(arrays), points);
        layout_->root().setAttributes(attributesOf(parameters_.provenance));
    }

    const FrameParameters& parameters_;
    const bodies::Body<Dim>* body_;
    Path path_;
    std::vector<Member> members_;  // the first one is the position
    std::optional<SafeFile> file_;
    std::unique_ptr<VtkHdfLayout> layout_;
};

template <int Dim>
VtkHdfOutput<Dim>::VtkHdfOutput(FrameParameters parameters, std::vector<BodyFrames<Dim>> bodies)
    : parameters_(std::move(parameters)) {
    for (const BodyFrames<Dim>& frames : bodies)
        series_.push_back(std::make_unique<Series>(parameters_, frames));
}

template <int Dim>
VtkHdfOutput<Dim>::~VtkHdfOutput() = default;

template <int Dim>
std::vector<OutputFile> VtkHdfOutput<Dim>::files() const {
    std::vector<OutputFile> files;
    for (const auto& series : series_) files.push_back(series->file());
    return files;
}

template <int Dim>
FileWork VtkHdfOutput<Dim>::take(const Clock& clock) {
    auto frames = std::make_shared<std::vector<typename Series::Frame>>();
    std::size_t bytes = 0;
    for (auto& series : series_) {
        frames->push_back(series->take());
        bytes += frames->back().bytes;
    }
    return {[this, frames, time = clock.time, number = frames_++] {
                for (std::size_t k = 0; k < series_.size(); ++k)
                    series_[k]->write((*frames)[k], time, number);
            },
            bytes};
}

template <int Dim>
void VtkHdfOutput<Dim>::transfer(Archive& archive) {
    archive.count("frames", frames_);
    const Section bodies(archive, "bodies");
    for (auto& series : series_) {
        if (!archive.has(series->name())) continue;  // a resumed run may write other bodies
        const Section section(archive, series->name());
        series->transfer(archive);
    }
}

template <int Dim>
void VtkHdfOutput<Dim>::resume(const Clock& clock) {
    for (auto& series : series_) series->resume(clock, frames_);
}

template class VtkHdfOutput<2>;
template class VtkHdfOutput<3>;

}  // namespace sphinx::io
