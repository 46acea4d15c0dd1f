// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/frames/pvd.h"

#include "core/errors.h"
#include "core/read_file.h"
#include "io/file/number_text.h"

#include <tinyxml2.h>

namespace sphinx::io {
namespace {

constexpr std::uint64_t size_limit = std::uint64_t{1} << 30;

}  // namespace

std::string pvdText(const std::vector<PvdEntry>& entries, const Provenance& provenance) {
    tinyxml2::XMLPrinter xml;
    xml.PushHeader(false, true);
    xml.OpenElement("VTKFile");
    xml.PushAttribute("type", "Collection");
    xml.PushAttribute("version", "1.0");
    xml.PushAttribute("byte_order", "LittleEndian");
    xml.OpenElement("Provenance");
    for (const auto& [name, value] : provenance.entries) {
        xml.OpenElement("Entry");
        xml.PushAttribute("name", name.c_str());
        xml.PushAttribute("value", value.c_str());
        xml.CloseElement();
    }
    xml.CloseElement();
    xml.OpenElement("Collection");
    for (const PvdEntry& entry : entries) {
        xml.OpenElement("DataSet");
        xml.PushAttribute("timestep", numberText(entry.time).c_str());
        xml.PushAttribute("frame", std::to_string(entry.frame).c_str());
        xml.PushAttribute("group", "");
        xml.PushAttribute("part", "0");
        xml.PushAttribute("file", entry.file.c_str());
        xml.CloseElement();
    }
    xml.CloseElement();
    xml.CloseElement();
    return xml.CStr();
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
