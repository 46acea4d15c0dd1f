// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/errors.h"
#include "core/parallel.h"
#include "io/file/compress.h"
#include "io/file/number_text.h"
#include "io/restart/restart.h"
#include "io/restart/values.h"
#include "io/xml/archive.h"
#include "io/xml/text.h"
#include "particles/id_order.h"

#include <algorithm>
#include <array>

namespace sphinx::io {
namespace {

/// Passes text on to the file and keeps the checksum of everything.
class Stream {
 public:
    explicit Stream(const Path& path) : file_(path) {}
    void write(std::string_view text) {
        checksum_ = checksum(text, checksum_);
        file_.write(text);
    }
    void finish() {
        file_.write(restartEnd(checksum_));
        file_.commit();
    }

 private:
    AtomicFile file_;
    std::uint32_t checksum_ = 0;
};

std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + escaped(value) + "\"";
}

const char* rankName(particles::Rank rank) {
    switch (rank) {
        case particles::Rank::scalar: return "scalar";
        case particles::Rank::vector: return "vector";
        case particles::Rank::matrix: return "matrix";
        case particles::Rank::integer: break;
    }
    return "integer";
}

void writeField(Stream& stream, const particles::FieldBase& field, const particles::IdOrder& order,
                RestartEncoding encoding) {
    const bool integers = field.info().rank == particles::Rank::integer;
    stream.write("<field" + attribute("name", field.info().name) +
                 attribute("rank", rankName(field.info().rank)) +
                 attribute("components", std::to_string(field.components())) + ">\n");
    AlignedVector<char> buffer;
    const std::string_view bytes = order.bytes(field, buffer);
    const std::size_t values = bytes.size() / 8;
    // A few pieces at a time: encoded by all threads, never all in memory.
    std::array<std::string, 8> pieces;
    for (std::size_t begin = 0; begin < values; begin += pieces.size() * values_in_piece) {
        parallelFor(
            pieces.size(),
            [&](std::size_t p) {
                const std::size_t first = begin + p * values_in_piece;
                pieces[p].clear();
                if (first < values)
                    pieces[p] =
                        encodePiece(bytes.data() + 8 * first,
                                    std::min(values_in_piece, values - first), integers, encoding);
            },
            1);
        for (const std::string& piece : pieces) stream.write(piece);
    }
    stream.write("</field>\n");
}

}  // namespace

std::string restartEnd(std::uint32_t checksum) {
    return "<checksum crc32=\"" + hexText(checksum) + "\"/>\n</restart>\n";
}

std::string stateText(const StateTransfer& state) {
    XmlSaveArchive archive;
    state(archive);
    return archive.xml();
}

std::string restartName(const RestartHeader& header) {
    return header.case_name + "_" + std::to_string(header.steps) + ".xml";
}

template <int Dim>
void writeRestart(const Path& path, const RestartHeader& header, const StateTransfer& state,
                  const std::vector<RestartBody<Dim>>& bodies, RestartEncoding encoding) {
    writeRestart(path, header, stateText(state), bodies, encoding);
}

template <int Dim>
void writeRestart(const Path& path, const RestartHeader& header, const std::string& state_text,
                  const std::vector<RestartBody<Dim>>& bodies, RestartEncoding encoding) {
    Stream stream(path);
    stream.write("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<restart" +
                 attribute("format", std::to_string(restart_format)) +
                 attribute("program", header.program) + attribute("commit", header.commit) +
                 attribute("case", header.case_name) + attribute("digest", header.digest) +
                 attribute("dimension", std::to_string(header.dimension)) +
                 attribute("instruction_set", header.instruction_set));
    for (const auto& [name, value] : header.build_and_machine.entries)
        stream.write(attribute(name, value));
    std::string text = " time=\"";
    appendExactNumber(text, header.time);
    text += "\"" + attribute("steps", std::to_string(header.steps)) + ">\n";
    appendTextElement(text, "case_text", "", header.case_text);
    stream.write(text);
    stream.write("<state>\n" + state_text + "</state>\n");
    for (const RestartBody<Dim>& entry : bodies) {
        const particles::ParticleSet<Dim>& particles = entry.body->particles;
        const particles::IdOrder order(particles);
        stream.write("<body" + attribute("name", entry.body->name) +
                     attribute("particles", std::to_string(particles.size())) +
                     attribute("next_id", std::to_string(particles.nextId())) + ">\n");
        // Ids first: a reader learns from them how many particles there really are.
        std::vector<std::string> names{std::string(fields::id.name),
                                       std::string(fields::position.name)};
        for (const std::string& name : entry.fields)
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        for (const std::string& name : names)
            writeField(stream, *particles.find(name), order, encoding);
        stream.write("</body>\n");
    }
    stream.finish();
}

template void writeRestart(const Path&, const RestartHeader&, const StateTransfer&,
                           const std::vector<RestartBody<2>>&, RestartEncoding);
template void writeRestart(const Path&, const RestartHeader&, const StateTransfer&,
                           const std::vector<RestartBody<3>>&, RestartEncoding);
template void writeRestart(const Path&, const RestartHeader&, const std::string&,
                           const std::vector<RestartBody<2>>&, RestartEncoding);
template void writeRestart(const Path&, const RestartHeader&, const std::string&,
                           const std::vector<RestartBody<3>>&, RestartEncoding);

}  // namespace sphinx::io
