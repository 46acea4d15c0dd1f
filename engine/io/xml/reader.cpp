// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/xml/reader.h"

#include "core/errors.h"
#include "io/file/number_text.h"

#include <array>

namespace sphinx::io {
namespace {

constexpr std::size_t buffer_size = 1 << 16;
constexpr std::size_t most_open = 100, most_attributes = 32;
constexpr std::size_t longest_name = 100, longest_value = 1 << 16;
constexpr int end_of_file = -1;

bool isBlank(int c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
bool isNameCharacter(int c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
}

}  // namespace

XmlReader::XmlReader(const Path& path) : file_(File::openRead(path)) {}

void XmlReader::fail(const std::string& message) const {
    throw FileError("cannot read " + file_.path().string() + ": byte " +
                    std::to_string(passed_ + position_) + ": " + message);
}

int XmlReader::peek() {
    if (position_ == buffer_.size()) {
        passed_ += buffer_.size();
        position_ = 0;
        buffer_.resize(buffer_size);
        buffer_.resize(file_.read(buffer_.data(), buffer_.size()));
        if (buffer_.empty()) return end_of_file;
    }
    return static_cast<unsigned char>(buffer_[position_]);
}

char XmlReader::take() {
    if (peek() == end_of_file) fail("the file ends too early");
    return buffer_[position_++];
}

void XmlReader::expect(std::string_view text) {
    for (const char c : text)
        if (take() != c) fail("'" + std::string(text) + "' is missing");
}

void XmlReader::skipBlanks() {
    while (isBlank(peek())) ++position_;
}

std::string XmlReader::name() {
    std::string result;
    while (isNameCharacter(peek())) {
        result += take();
        if (result.size() > longest_name) fail("a name is too long");
    }
    if (result.empty()) fail("a name is missing");
    return result;
}

char XmlReader::entity() {
    std::string code;
    for (char c = take(); c != ';'; c = take()) {
        code += c;
        if (code.size() > 4) break;
    }
    static constexpr std::array<std::pair<std::string_view, char>, 7> known{{{"lt", '<'},
                                                                             {"gt", '>'},
                                                                             {"amp", '&'},
                                                                             {"quot", '"'},
                                                                             {"apos", '\''},
                                                                             {"#9", '\t'},
                                                                             {"#13", '\r'}}};
    for (const auto& [entity, character] : known)
        if (code == entity) return character;
    fail("unknown entity");
}

void XmlReader::endTag() {
    if (name() != open_.back()) fail("the end of '" + open_.back() + "' is missing");
    skipBlanks();
    expect(">");
    open_.pop_back();
}

bool XmlReader::next(XmlElement& element) {
    if (empty_) {
        empty_ = false;
        open_.pop_back();
        return false;
    }
    skipBlanks();
    if (open_.empty() && began_) {
        if (peek() != end_of_file) fail("there is something behind the end");
        return false;
    }
    expect("<");
    if (!began_ && peek() == '?') {
        while (take() != '>') {
        }
        skipBlanks();
        expect("<");
    }
    began_ = true;
    if (peek() == '/') {
        if (open_.empty()) fail("an end without a beginning");
        take();
        endTag();
        return false;
    }
    if (open_.size() == most_open) fail("elements are nested too deeply");
    element.name = name();
    element.attributes.clear();
    for (;;) {
        skipBlanks();
        if (peek() == '/') {
            take();
            empty_ = true;
        }
        if (empty_ || peek() == '>') break;
        if (element.attributes.size() == most_attributes) fail("too many attributes");
        std::string key = name();
        skipBlanks();
        expect("=");
        skipBlanks();
        expect("\"");
        std::string value;
        for (char c = take(); c != '"'; c = take()) {
            if (c == '<') fail("'<' inside an attribute");
            value += c == '&' ? entity() : c;
            if (value.size() > longest_value) fail("an attribute is too long");
        }
        element.attributes.emplace_back(std::move(key), std::move(value));
    }
    expect(">");
    open_.push_back(element.name);
    return true;
}

std::string XmlReader::text(std::size_t limit) {
    std::string result;
    if (empty_) {
        empty_ = false;
        open_.pop_back();
        return result;
    }
    for (;;) {
        if (peek() == end_of_file) fail("the file ends too early");
        // Whole runs between markup at once.
        const std::size_t found = buffer_.find_first_of("<&", position_);
        const std::size_t end = found == buffer_.npos ? buffer_.size() : found;
        result.append(buffer_, position_, end - position_);
        position_ = end;
        if (found != buffer_.npos) {
            if (take() == '<') break;
            result += entity();
        }
        if (result.size() > limit) fail("a text is too long");
    }
    expect("/");
    endTag();
    if (result.size() > limit) fail("a text is too long");
    return result;
}

void XmlReader::skip() {
    const std::size_t depth = open_.size();
    while (open_.size() >= depth) {
        if (empty_) {
            empty_ = false;
            open_.pop_back();
            continue;
        }
        while (peek() != '<') take();
        XmlElement element;
        next(element);
    }
}

const std::string& XmlReader::attribute(const XmlElement& element, std::string_view name) const {
    for (const auto& [key, value] : element.attributes)
        if (key == name) return value;
    fail("'" + element.name + "' has no attribute '" + std::string(name) + "'");
}

std::int64_t XmlReader::count(const XmlElement& element, std::string_view name,
                              std::int64_t limit) const {
    const auto value = parseInteger(attribute(element, name));
    if (!value || *value < 0 || *value > limit)
        fail("attribute '" + std::string(name) + "' of '" + element.name +
             "' is not a number from 0 to " + std::to_string(limit));
    return *value;
}

}  // namespace sphinx::io
