// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/frames/vtu.h"

#include "core/parallel.h"
#include "io/file/compress.h"
#include "io/file/number_text.h"
#include "io/xml/text.h"

#include <bit>
#include <cstring>

static_assert(std::endian::native == std::endian::little, "files are written as memory lies");

namespace sphinx::io {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 18;  // bytes before compression
constexpr std::size_t offset_digits = 20;

/// Appended data in VTK's compressed form: number of blocks, block size, size of a last partial
/// block, compressed sizes, then the blocks.
std::string encode(std::string_view bytes) {
    const std::size_t blocks = (bytes.size() + block_size - 1) / block_size;
    std::vector<std::string> compressed(blocks);
    parallelFor(
        blocks,
        [&](std::size_t b) { compressed[b] = compress(bytes.substr(b * block_size, block_size)); },
        1);
    std::vector<std::uint64_t> header{blocks, block_size, bytes.size() % block_size};
    for (const std::string& block : compressed) header.push_back(block.size());
    std::string result(header.size() * sizeof header[0], '\0');
    std::memcpy(result.data(), header.data(), result.size());
    for (const std::string& block : compressed) result += block;
    return result;
}

const char* typeName(NumberType type) {
    switch (type) {
        case NumberType::float64: return "Float64";
        case NumberType::float32: return "Float32";
        case NumberType::int64: break;
    }
    return "Int64";
}

/// Cells of n points: one vertex each. Depends on n alone, so it is encoded once.
struct VertexCells {
    std::size_t points = static_cast<std::size_t>(-1);
    std::string connectivity, offsets, types;

    void update(std::size_t n) {
        if (n == points) return;
        points = n;
        AlignedVector<std::int64_t> numbers(n);
        const auto encodeFrom = [&](std::int64_t first) {
            parallelFor(n,
                        [&](std::size_t i) { numbers[i] = first + static_cast<std::int64_t>(i); });
            return encode({reinterpret_cast<const char*>(numbers.data()), 8 * n});
        };
        connectivity = encodeFrom(0);
        offsets = encodeFrom(1);
        types = encode(std::string(n, '\1'));
    }
};

/// The header, with room for the offsets that are known only when the data are written.
class Header {
 public:
    void text(std::string_view line) { text_ += line; }
    void array(std::string_view type, std::string_view name, int components,
               const std::string& unit) {
        text_ += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + escaped(name) +
                 "\" NumberOfComponents=\"" + std::to_string(components) +
                 "\" format=\"appended\" offset=\"";
        places_.push_back(text_.size());
        text_ += std::string(offset_digits, '0') + "\"";
        if (unit.empty())
            text_ += "/>\n";
        else
            text_ += "><InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">" +
                     escaped(unit) + "</InformationKey></DataArray>\n";
    }
    void string(std::string_view name, std::string_view value) {
        text_ += "<Array type=\"String\" Name=\"" + escaped(name) +
                 "\" NumberOfTuples=\"1\" format=\"ascii\">";
        for (const char c : value) {
            appendInteger(text_, static_cast<unsigned char>(c));
            text_ += ' ';
        }
        text_ += "0</Array>\n";
    }
    const std::string& content() const { return text_; }
    std::size_t place(std::size_t array) const { return places_[array]; }

 private:
    std::string text_;
    std::vector<std::size_t> places_;
};

/// Writes array after array behind the header and fills in the offsets.
class Appender {
 public:
    Appender(AtomicFile& file, const Header& header) : file_(file), header_(header) {
        file_.write(header_.content());
    }
    void add(const std::string& encoded) {
        std::string digits = std::to_string(offset_);
        digits.insert(0, offset_digits - digits.size(), '0');
        file_.writeAt(header_.place(next_++), digits);
        file_.write(encoded);
        offset_ += encoded.size();
    }

 private:
    AtomicFile& file_;
    const Header& header_;
    std::size_t next_ = 0;
    std::uint64_t offset_ = 0;
};

}  // namespace

template <int Dim>
struct VtuOutput<Dim>::Series {
    const bodies::Body<Dim>* body = nullptr;
    const particles::FieldBase* position = nullptr;
    std::vector<const particles::FieldBase*> fields;
    std::uint64_t last_fingerprint = 0;
    std::string last_file;  // empty: none yet
    // For the thread that writes:
    VertexCells cells;
    std::vector<PvdEntry> entries;

    /// Of what a frame would hold: a resumed run may write other fields in another precision.
    std::uint64_t fingerprint(bool single_precision, const particles::IdOrder& order) const {
        std::string names = single_precision ? "single" : "double";
        for (const particles::FieldBase* field : fields)
            names += " " + std::string(field->info().name);
        std::uint64_t sum = io::fingerprint(names);
        const auto add = [&](const particles::FieldBase& field) {
            sum = std::rotl(sum, 7) * 31 + fieldFingerprint(field, order);
        };
        add(*position);
        for (const particles::FieldBase* field : fields) add(*field);
        return sum;
    }
    void transfer(Archive& archive) {
        auto bits = std::bit_cast<std::int64_t>(last_fingerprint);
        archive.value("file", last_file);
        archive.value("fingerprint", bits);
        last_fingerprint = std::bit_cast<std::uint64_t>(bits);
    }
};

/// The arrays of a body, if they have changed, and the file that has them.
template <int Dim>
struct VtuOutput<Dim>::Frame {
    std::string file;
    std::size_t points = 0;
    std::vector<ArrayCopy> arrays;  // the fields, then the position; none: the file is there
};

template <int Dim>
VtuOutput<Dim>::VtuOutput(FrameParameters parameters, std::vector<BodyFrames<Dim>> bodies)
    : parameters_(std::move(parameters)) {
    for (const BodyFrames<Dim>& frames : bodies) {
        auto series = std::make_unique<Series>();
        series->body = frames.body;
        series->position = frames.body->particles.find(fields::position.name);
        series->fields = frameFields(frames);
        series_.push_back(std::move(series));
    }
}

template <int Dim>
VtuOutput<Dim>::~VtuOutput() = default;

template <int Dim>
std::vector<OutputFile> VtuOutput<Dim>::files() const {
    std::vector<OutputFile> files;
    for (const auto& series : series_) {
        std::vector<const particles::FieldBase*> fields = series->fields;
        fields.push_back(series->position);
        files.push_back({series->body->name + "_*.vtu",
                         frameBytes(fields, series->body->size(), parameters_.single_precision)});
    }
    return files;
}

template <int Dim>
FileWork VtuOutput<Dim>::take(const Clock& clock) {
    auto frames = std::make_shared<std::vector<Frame>>();
    std::size_t bytes = 0;
    for (auto& series : series_) {
        Frame& frame = frames->emplace_back();
        const particles::IdOrder order(series->body->particles);
        const std::uint64_t now = series->fingerprint(parameters_.single_precision, order);
        if (series->last_file.empty() || now != series->last_fingerprint) {
            series->last_file = frameName(series->body->name, frames_, ".vtu");
            series->last_fingerprint = now;
            frame.points = order.size();
            const auto add = [&](const particles::FieldBase& field) {
                frame.arrays.push_back(copyArray<Dim>(field, order, FieldLayout::padded,
                                                      parameters_.single_precision));
            };
            for (const particles::FieldBase* field : series->fields) add(*field);
            add(*series->position);
            for (const ArrayCopy& array : frame.arrays) bytes += array.values.size();
        }
        frame.file = series->last_file;
    }
    return {[this, frames, time = clock.time, number = frames_++] {
                writeFrames(*frames, time, number);
            },
            bytes};
}

template <int Dim>
void VtuOutput<Dim>::writeFrames(const std::vector<Frame>& frames, double time,
                                 std::int64_t number) {
    for (std::size_t k = 0; k < series_.size(); ++k) {
        Series& series = *series_[k];
        const Frame& frame = frames[k];
        if (!frame.arrays.empty()) writeFrame(series, frame, time);
        series.entries.push_back({number, time, frame.file});
        const Path list = parameters_.folder / (series.body->name + ".pvd");
        publishFile(list, pvdText(series.entries, parameters_.provenance));
        unsynced_.add(list);
    }
}

template <int Dim>
void VtuOutput<Dim>::writeFrame(Series& series, const Frame& frame, double time) {
    const std::size_t n = frame.points;
    const auto type = [&](const particles::FieldBase& field) {
        return typeName(numberType(field.info(), parameters_.single_precision));
    };
    const auto unit = [&](const particles::FieldBase& field) {
        return parameters_.units.text(field.info().unit);
    };
    Header header;
    header.text(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n"
        "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
        "format=\"ascii\">");
    header.text(numberText(time) + "</DataArray>\n");
    for (const auto& [name, value] : parameters_.provenance.entries) header.string(name, value);
    header.text("</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(n) +
                "\" NumberOfCells=\"" + std::to_string(n) + "\">\n<PointData>\n");
    for (const particles::FieldBase* field : series.fields) {
        header.array(type(*field), field->info().name,
                     componentsOf<Dim>(field->info().rank, FieldLayout::padded), unit(*field));
    }
    header.text("</PointData>\n<Points>\n");
    header.array(type(*series.position), "Points", 3, unit(*series.position));
    header.text("</Points>\n<Cells>\n");
    header.array("Int64", "connectivity", 1, "");
    header.array("Int64", "offsets", 1, "");
    header.array("UInt8", "types", 1, "");
    header.text("</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");

    const Path path = parameters_.folder / frame.file;
    AtomicFile file(path);
    Appender appender(file, header);
    for (const ArrayCopy& array : frame.arrays) appender.add(encode(array.bytes()));
    series.cells.update(n);
    appender.add(series.cells.connectivity);
    appender.add(series.cells.offsets);
    appender.add(series.cells.types);
    file.write("\n</AppendedData>\n</VTKFile>\n");
    file.publish();
    unsynced_.add(path);
}

template <int Dim>
void VtuOutput<Dim>::transfer(Archive& archive) {
    archive.count("frames", frames_);
    const Section bodies(archive, "bodies");
    for (auto& series : series_) {
        if (!archive.has(series->body->name)) continue;  // a resumed run may write other bodies
        const Section section(archive, series->body->name);
        series->transfer(archive);
    }
}

template <int Dim>
void VtuOutput<Dim>::resume(const Clock&) {
    for (auto& series : series_) {
        const std::string& name = series->body->name;
        // First the list, so that it never names a file that is gone.
        const Path list = parameters_.folder / (name + ".pvd");
        series->entries = readPvd(list);
        const auto beyond = [&](const PvdEntry& entry) { return entry.frame >= frames_; };
        if (std::erase_if(series->entries, beyond) > 0)
            writeFileAtomically(list, pvdText(series->entries, parameters_.provenance));
        removeFramesFrom(parameters_.folder, name, ".vtu", frames_);
        // The results of a restart may begin in a folder of their own.
        if (!isThere(parameters_.folder / series->last_file)) series->last_file.clear();
    }
}

template class VtuOutput<2>;
template class VtuOutput<3>;

}  // namespace sphinx::io
