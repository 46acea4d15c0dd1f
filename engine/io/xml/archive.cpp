// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/xml/archive.h"

#include "core/errors.h"
#include "io/file/base64.h"
#include "io/file/number_text.h"
#include "io/xml/text.h"

#include <algorithm>
#include <array>
#include <span>
#include <variant>

namespace sphinx::io {
namespace {

constexpr std::size_t longest_text = std::size_t{1} << 28;

std::string nameAttribute(std::string_view name) { return "name=\"" + escaped(name) + "\""; }

template <class T>
void appendArray(std::string& xml, const std::string& element, std::string_view name,
                 std::span<const T> values) {
    xml += "<" + element + " " + nameAttribute(name) + " values=\"" +
           std::to_string(values.size()) + "\">";
    appendList(xml, values);
    xml += "</" + element + ">\n";
}

/// Of the element that was opened last.
template <class T>
std::vector<T> readArray(XmlReader& reader, const XmlElement& element, const std::string& name) {
    const auto count = static_cast<std::size_t>(reader.count(element, "values", longest_text));
    const std::string text = reader.text(longest_text);
    // Memory is asked for only when there is text for so many values.
    std::vector<T> values(std::min(count, text.size()));
    if (values.size() != count || !parseList(text, values))
        reader.fail("'" + name + "' does not hold " + std::to_string(count) + " values");
    return values;
}

void appendValue(std::string& xml, std::string_view name, double v) {
    xml += "<number " + nameAttribute(name) + ">";
    appendExactNumber(xml, v);
    xml += "</number>\n";
}
void appendValue(std::string& xml, std::string_view name, std::int64_t v) {
    xml += "<integer " + nameAttribute(name) + ">";
    appendInteger(xml, v);
    xml += "</integer>\n";
}
void appendValue(std::string& xml, std::string_view name, bool v) {
    xml += "<flag " + nameAttribute(name) + (v ? ">true" : ">false") + "</flag>\n";
}
void appendValue(std::string& xml, std::string_view name, const std::string& v) {
    appendTextElement(xml, "text", nameAttribute(name), v);
}
void appendValue(std::string& xml, std::string_view name, const std::vector<double>& v) {
    appendArray<double>(xml, "numbers", name, v);
}
void appendValue(std::string& xml, std::string_view name, const std::vector<std::int64_t>& v) {
    appendArray<std::int64_t>(xml, "integers", name, v);
}
/// The elements of the types of ArchiveValue.
constexpr std::array<const char*, std::variant_size_v<ArchiveValue>> elements{
    "number", "integer", "flag", "text", "numbers", "integers"};

bool readFlag(XmlReader& reader, const std::string& name) {
    const std::string text = reader.text(10);
    if (text != "true" && text != "false") reader.fail("'" + name + "' is not true or false");
    return text == "true";
}

}  // namespace

void appendTextElement(std::string& xml, std::string_view element, std::string_view attributes,
                       std::string_view text) {
    const bool plain = isXmlText(text);
    const std::string tag = (plain ? "" : "binary_") + std::string(element);
    xml += "<" + tag;
    if (!attributes.empty()) xml += " " + std::string(attributes);
    xml += ">";
    if (plain)
        appendEscaped(xml, text);
    else
        xml += encodeBase64(text);
    xml += "</" + tag + ">\n";
}

std::string readTextElement(XmlReader& reader, const XmlElement& element) {
    std::string text = reader.text(longest_text);
    if (!element.name.starts_with("binary_")) return text;
    std::optional<std::string> bytes = decodeBase64(text);
    if (!bytes) reader.fail("this is not base64");
    return std::move(*bytes);
}

void XmlSaveArchive::endSections() {
    for (; left_ > 0; --left_) xml_ += "</section>\n";
}

const std::string& XmlSaveArchive::xml() {
    endSections();
    return xml_;
}

void XmlSaveArchive::transfer(std::string_view name, ArchiveValue& v) {
    endSections();
    std::visit([&](const auto& value) { appendValue(xml_, name, value); }, v);
}

void XmlSaveArchive::enter(std::string_view name) {
    endSections();
    xml_ += "<section " + nameAttribute(name) + ">\n";
}

struct XmlLoadArchive::SectionNode {
    std::map<std::string, ArchiveValue, std::less<>> values;
    std::map<std::string, SectionNode, std::less<>> sections;
};

XmlLoadArchive::XmlLoadArchive(XmlReader& reader, const Path& path)
    : path_(path), root_(std::make_unique<SectionNode>()), open_{root_.get()} {
    read(reader, *root_);
}

XmlLoadArchive::~XmlLoadArchive() = default;

void XmlLoadArchive::read(XmlReader& reader, SectionNode& section) {
    XmlElement element;
    while (reader.next(element)) {
        const std::string name = reader.attribute(element, "name");
        bool is_new = true;
        if (element.name == "section") {
            const auto [place, added] = section.sections.try_emplace(name);
            is_new = added;
            // The reader limits the depth.
            if (added) read(reader, place->second);
        } else if (element.name == "number") {
            const auto number = parseExactNumber(reader.text(100));
            if (!number) reader.fail("'" + name + "' is not a number");
            is_new = section.values.emplace(name, *number).second;
        } else if (element.name == "integer") {
            const auto integer = parseInteger(reader.text(100));
            if (!integer) reader.fail("'" + name + "' is not a whole number");
            is_new = section.values.emplace(name, *integer).second;
        } else if (element.name == "flag") {
            is_new = section.values.emplace(name, readFlag(reader, name)).second;
        } else if (element.name == "numbers") {
            is_new = section.values.emplace(name, readArray<double>(reader, element, name)).second;
        } else if (element.name == "integers") {
            is_new =
                section.values.emplace(name, readArray<std::int64_t>(reader, element, name)).second;
        } else if (element.name == "text" || element.name == "binary_text") {
            is_new = section.values.emplace(name, readTextElement(reader, element)).second;
        } else {
            reader.fail("unknown element '" + element.name + "'");
        }
        if (!is_new) reader.fail("'" + name + "' is there twice");
    }
}

void XmlLoadArchive::failMissing(const std::string& kind, std::string_view name) const {
    std::string place;
    for (const std::string& section : names_) place += section + "/";
    throw FileError("cannot read " + path_.string() + ": the state has no " + kind + " '" + place +
                    std::string(name) + "'");
}

void XmlLoadArchive::transfer(std::string_view name, ArchiveValue& v) {
    const auto found = open_.back()->values.find(name);
    if (found == open_.back()->values.end() || found->second.index() != v.index())
        failMissing(elements[v.index()], name);
    v = found->second;
}

bool XmlLoadArchive::has(std::string_view name) const {
    return open_.back()->values.contains(name) || open_.back()->sections.contains(name);
}

void XmlLoadArchive::enter(std::string_view name) {
    const auto found = open_.back()->sections.find(name);
    if (found == open_.back()->sections.end()) failMissing("section", name);
    open_.push_back(&found->second);
    names_.emplace_back(name);
}

void XmlLoadArchive::leave() {
    open_.pop_back();
    names_.pop_back();
}

}  // namespace sphinx::io
