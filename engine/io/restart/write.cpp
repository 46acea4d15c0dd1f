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

void writeField(Stream& stream, const particles::FieldInfo& field, int components,
                std::string_view bytes, RestartEncoding encoding) {
    const bool integers = field.rank == particles::Rank::integer;
    stream.write("<field" + attribute("name", field.name) +
                 attribute("rank", rankName(field.rank)) +
                 attribute("components", std::to_string(components)) + ">\n");
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

/// Fields of a body in the order of the file: ids first, from which a reader learns how many
/// particles there really are.
template <int Dim>
std::vector<const particles::FieldBase*> fieldsOf(const RestartBody<Dim>& body) {
    const particles::ParticleSet<Dim>& particles = body.body->particles;
    std::vector<const particles::FieldBase*> result{&particles.id(), &particles.position()};
    for (const std::string& name : body.fields)
        if (const auto* field = particles.find(name);
            std::find(result.begin(), result.end(), field) == result.end())
            result.push_back(field);
    return result;
}

std::string bodyElement(const std::string& name, std::size_t particles, std::int64_t next_id) {
    return "<body" + attribute("name", name) + attribute("particles", std::to_string(particles)) +
           attribute("next_id", std::to_string(next_id)) + ">\n";
}

template <int Dim>
void writeBody(Stream& stream, const RestartBody<Dim>& entry, RestartEncoding encoding) {
    const particles::ParticleSet<Dim>& particles = entry.body->particles;
    const particles::IdOrder order(particles);
    stream.write(bodyElement(entry.body->name, particles.size(), particles.nextId()));
    AlignedVector<char> buffer;
    for (const particles::FieldBase* field : fieldsOf(entry))
        writeField(stream, field->info(), field->components(), order.bytes(*field, buffer),
                   encoding);
    stream.write("</body>\n");
}

void writeBody(Stream& stream, const TakenBody& body, RestartEncoding encoding) {
    stream.write(bodyElement(body.name, body.particles, body.next_id));
    for (const TakenField& field : body.fields)
        writeField(stream, field.info, field.components, {field.values.data(), field.values.size()},
                   encoding);
    stream.write("</body>\n");
}

template <class Bodies>
void writeFile(const Path& path, const RestartHeader& header, const std::string& state_text,
               const Bodies& bodies, RestartEncoding encoding) {
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
    for (const auto& body : bodies) writeBody(stream, body, encoding);
    stream.finish();
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
    writeFile(path, header, state_text, bodies, encoding);
}

void writeRestart(const Path& path, const RestartHeader& header, const std::string& state_text,
                  const std::vector<TakenBody>& bodies, RestartEncoding encoding) {
    writeFile(path, header, state_text, bodies, encoding);
}

template <int Dim>
TakenBody takeBody(const RestartBody<Dim>& body) {
    const particles::ParticleSet<Dim>& particles = body.body->particles;
    const particles::IdOrder order(particles);
    TakenBody taken{body.body->name, particles.size(), particles.nextId(), {}};
    for (const particles::FieldBase* field : fieldsOf(body))
        taken.fields.push_back({field->info(), field->components(), order.copy(*field)});
    return taken;
}

template void writeRestart(const Path&, const RestartHeader&, const StateTransfer&,
                           const std::vector<RestartBody<2>>&, RestartEncoding);
template void writeRestart(const Path&, const RestartHeader&, const StateTransfer&,
                           const std::vector<RestartBody<3>>&, RestartEncoding);
template void writeRestart(const Path&, const RestartHeader&, const std::string&,
                           const std::vector<RestartBody<2>>&, RestartEncoding);
template void writeRestart(const Path&, const RestartHeader&, const std::string&,
                           const std::vector<RestartBody<3>>&, RestartEncoding);
template TakenBody takeBody(const RestartBody<2>&);
template TakenBody takeBody(const RestartBody<3>&);

}  // namespace sphinx::io
