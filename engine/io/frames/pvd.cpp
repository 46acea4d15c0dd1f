// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/frames/pvd.h"

#include "core/errors.h"
#include "core/read_file.h"
#include "io/file/number_text.h"
#include "io/xml/text.h"

#include <tinyxml2.h>

namespace sphinx::io {
namespace {

constexpr std::uint64_t size_limit = std::uint64_t{1} << 30;

}  // namespace

void writePvd(const Path& path, const std::vector<PvdEntry>& entries,
              const Provenance& provenance) {
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "  <Provenance>\n";
    for (const auto& [name, value] : provenance.entries)
        text += "    <Entry name=\"" + escaped(name) + "\" value=\"" + escaped(value) + "\"/>\n";
    text += "  </Provenance>\n  <Collection>\n";
    for (const PvdEntry& entry : entries) {
        text += "    <DataSet timestep=\"";
        appendNumber(text, entry.time);
        text += "\" frame=\"" + std::to_string(entry.frame) + "\" group=\"\" part=\"0\" file=\"" +
                escaped(entry.file) + "\"/>\n";
    }
    text += "  </Collection>\n</VTKFile>\n";
    writeFileAtomically(path, text);
}

std::vector<PvdEntry> readPvd(const Path& path) {
    if (!isThere(path)) return {};
    const std::string text = readFile(path, size_limit);
    tinyxml2::XMLDocument document;
    const tinyxml2::XMLElement* root = nullptr;
    if (document.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS)
        root = document.FirstChildElement("VTKFile");
    const auto* collection = root ? root->FirstChildElement("Collection") : nullptr;
    if (!collection)
        throw FileError("cannot read " + path.string() + ": it is not a ParaView collection");
    std::vector<PvdEntry> entries;
    for (const auto* element = collection->FirstChildElement("DataSet"); element;
         element = element->NextSiblingElement("DataSet")) {
        const char* frame = element->Attribute("frame");
        const char* time = element->Attribute("timestep");
        const char* file = element->Attribute("file");
        const auto number = frame ? parseInteger(frame) : std::nullopt;
        const auto seconds = time ? parseExactNumber(time) : std::nullopt;
        if (!number || !seconds || !file)
            throw FileError("cannot read " + path.string() + ": line " +
                            std::to_string(element->GetLineNum()) +
                            " is not a frame that sphinx wrote");
        entries.push_back({*number, *seconds, file});
    }
    return entries;
}

}  // namespace sphinx::io
