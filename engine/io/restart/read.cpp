// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/errors.h"
#include "io/file/compress.h"
#include "io/file/number_text.h"
#include "io/restart/restart.h"
#include "io/restart/values.h"
#include "io/xml/archive.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>

namespace sphinx::io {
namespace {

[[noreturn]] void fail(const Path& path, const std::string& reason) {
    throw FileError("cannot read " + path.string() + ": " + reason);
}

/// Opens the root and reads its attributes and the text of the case.
RestartHeader readHeader(XmlReader& reader, const Path& path) {
    XmlElement element;
    if (!reader.next(element) || element.name != "restart")
        fail(path, "it is not a restart file of sphinx");
    const std::int64_t any = std::numeric_limits<std::int64_t>::max();
    const std::int64_t format = reader.count(element, "format", any);
    if (format != restart_format)
        fail(path, "it has format " + std::to_string(format) + ", and this program reads format " +
                       std::to_string(restart_format));
    RestartHeader header;
    header.program = reader.attribute(element, "program");
    header.commit = reader.attribute(element, "commit");
    header.case_name = reader.attribute(element, "case");
    header.digest = reader.attribute(element, "digest");
    header.instruction_set = reader.attribute(element, "instruction_set");
    header.dimension = static_cast<int>(reader.count(element, "dimension", 3));
    header.steps = reader.count(element, "steps", any);
    const auto time = parseExactNumber(reader.attribute(element, "time"));
    if (!time) reader.fail("the time is not a number");
    header.time = *time;
    if (!reader.next(element) ||
        (element.name != "case_text" && element.name != "binary_case_text"))
        reader.fail("the text of the case is missing");
    header.case_text = readTextElement(reader, element);
    return header;
}

/// All values of the field that was opened last.
AlignedVector<std::int64_t> readValues(XmlReader& reader, bool integers, std::size_t most) {
    AlignedVector<std::int64_t> bits;
    XmlElement piece;
    while (reader.next(piece)) {
        appendPiece(reader, piece, integers, bits);
        if (bits.size() > most) reader.fail("there are more values than particles");
    }
    return bits;
}

template <int Dim>
void readBody(XmlReader& reader, const XmlElement& element, const RestartBody<Dim>& target) {
    particles::ParticleSet<Dim>& particles = target.body->particles;
    const std::int64_t most = std::numeric_limits<Index>::max();
    const auto count = static_cast<std::size_t>(reader.count(element, "particles", most));
    const std::int64_t next_id =
        reader.count(element, "next_id", std::numeric_limits<std::int64_t>::max());
    std::vector<std::string> missing = target.fields;
    missing.emplace_back(fields::position.name);

    XmlElement child;
    if (!reader.next(child) || child.name != "field" ||
        reader.attribute(child, "name") != fields::id.name)
        reader.fail("the ids must come first");
    // Memory for the particles is asked for only when their ids are really there.
    const AlignedVector<std::int64_t> ids = readValues(reader, true, count);
    if (ids.size() != count) reader.fail("there are fewer ids than particles");
    for (const std::int64_t id : ids)
        if (id < 0 || id >= next_id) reader.fail("an id is out of range");
    if (std::ranges::adjacent_find(ids, std::ranges::greater_equal()) != ids.end())
        reader.fail("the ids do not ascend");
    particles.restore(count, next_id);
    std::copy(ids.begin(), ids.end(), particles.id().data());

    while (reader.next(child)) {
        if (child.name != "field") reader.fail("unknown element '" + child.name + "'");
        const std::string name = reader.attribute(child, "name");
        const auto wanted = std::find(missing.begin(), missing.end(), name);
        if (wanted == missing.end()) {
            reader.skip();
            continue;
        }
        particles::FieldBase* field = particles.find(name);
        if (!field) reader.fail("body '" + target.body->name + "' has no field '" + name + "'");
        const std::int64_t components = field->components();
        if (reader.count(child, "components", 100) != components)
            reader.fail("field '" + name + "' has another number of components");
        const bool integers = field->info().rank == particles::Rank::integer;
        const std::size_t values = count * static_cast<std::size_t>(components);
        const AlignedVector<std::int64_t> bits = readValues(reader, integers, values);
        if (bits.size() != values) reader.fail("field '" + name + "' has too few values");
        void* to =
            integers ? static_cast<void*>(field->integers()) : static_cast<void*>(field->numbers());
        if (values > 0) std::memcpy(to, bits.data(), 8 * values);
        std::erase(missing, name);
    }
    if (!missing.empty())
        reader.fail("body '" + target.body->name + "' comes without field '" + missing.front() +
                    "'");
}

}  // namespace

void verifyRestart(const Path& path) {
    constexpr std::string_view beginning = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<restart ";
    File file = File::openRead(path);
    std::string buffer(std::size_t{1} << 20, '\0');
    const auto read = [&](std::uint64_t most) {
        const std::size_t size = std::min<std::uint64_t>(most, buffer.size());
        return std::string_view(buffer.data(), file.read(buffer.data(), size));
    };
    if (read(beginning.size()) != beginning) fail(path, "it is not a restart file of sphinx");
    file.seek(0);
    const std::uint64_t size = file.size(), end_size = restartEnd(0).size();
    std::uint64_t left = size - std::min(size, end_size);
    std::uint32_t sum = 0;
    while (left > 0) {
        const std::string_view bytes = read(left);
        if (bytes.empty()) fail(path, "it is cut short");
        sum = checksum(bytes, sum);
        left -= bytes.size();
    }
    if (read(end_size + 1) != restartEnd(sum)) fail(path, "it is cut short or damaged");
}

RestartHeader readRestartHeader(const Path& path) {
    verifyRestart(path);
    XmlReader reader(path);
    return readHeader(reader, path);
}

template <int Dim>
void readRestart(const Path& path, const StateTransfer& state,
                 const std::vector<RestartBody<Dim>>& bodies) {
    verifyRestart(path);
    XmlReader reader(path);
    const RestartHeader header = readHeader(reader, path);
    if (header.dimension != Dim)
        fail(path, "it belongs to a case of dimension " + std::to_string(header.dimension));
    XmlElement element;
    if (!reader.next(element) || element.name != "state") reader.fail("the state is missing");
    XmlLoadArchive archive(reader, path);

    std::vector<const RestartBody<Dim>*> missing;
    for (const RestartBody<Dim>& body : bodies) missing.push_back(&body);
    while (reader.next(element) && element.name == "body") {
        const std::string& name = reader.attribute(element, "name");
        const auto target = std::find_if(missing.begin(), missing.end(), [&](const auto* wanted) {
            return wanted->body->name == name;
        });
        if (target == missing.end()) {
            reader.skip();
            continue;
        }
        readBody(reader, element, **target);
        missing.erase(target);
    }
    if (element.name != "checksum") reader.fail("unknown element '" + element.name + "'");
    if (!missing.empty()) fail(path, "it has no body '" + missing.front()->body->name + "'");
    state(archive);
}

std::int64_t restartSteps(const Path& path) {
    if (path.extension() != ".xml") return -1;
    const std::string name = path.stem().string();
    const std::size_t bar = name.rfind('_');
    if (bar == name.npos || bar + 1 == name.size() ||
        name.find_first_not_of("0123456789", bar + 1) != name.npos)
        return -1;
    return parseInteger(std::string_view(name).substr(bar + 1)).value_or(-1);
}

RestartSearch findNewestValid(const Path& folder) {
    RestartSearch search;
    // By what they say themselves: a file may have been copied under another name.
    std::vector<std::pair<std::int64_t, Path>> candidates;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const Path& path = entry.path();
        if (restartSteps(path) < 0) continue;
        try {
            XmlReader reader(path);
            candidates.emplace_back(readHeader(reader, path).steps, path);
        } catch (const FileError&) {
            candidates.emplace_back(restartSteps(path), path);  // what is wrong comes below
        }
    }
    std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    for (const auto& [steps, path] : candidates) {
        try {
            verifyRestart(path);
            search.found = path;
            break;
        } catch (const FileError& problem) {
            search.skipped.emplace_back(path, problem.what());
        }
    }
    return search;
}

template void readRestart(const Path&, const StateTransfer&, const std::vector<RestartBody<2>>&);
template void readRestart(const Path&, const StateTransfer&, const std::vector<RestartBody<3>>&);

}  // namespace sphinx::io
