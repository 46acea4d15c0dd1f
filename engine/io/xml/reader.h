// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/file/file.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sphinx::io {

/// Start tag of an element.
struct XmlElement {
    std::string name;
    std::vector<std::pair<std::string, std::string>> attributes;
};

/// Reads XML from a file piece by piece, never as a tree: memory is a buffer and what the caller
/// asks for. It knows the part of XML that this program writes: elements, attributes, text,
/// entities and an XML declaration; no comments, no document types, nothing external.
/// Anything else is a FileError that names the file and the byte.
/// tinyxml2 holds whole documents in memory, and a restart may be larger than that. Its header and
/// state would fit, but stand in one document with the values; so this reader, and text.h, serve
/// restarts and the frames of vtu, and tinyxml2 what is small by itself (frames/pvd.cpp).
class XmlReader {
 public:
    explicit XmlReader(const Path& path);

    /// The next child of the element that was opened last (at first: the root). False when there
    /// is none: its end tag has been read, and the parent counts as opened last.
    bool next(XmlElement& element);
    /// Text of the element that was opened last, up to and with its end tag. An error if it has
    /// children or more than `limit` bytes.
    std::string text(std::size_t limit);
    /// Skips the rest of the element that was opened last.
    void skip();

    /// Value of an attribute; an error if there is none.
    const std::string& attribute(const XmlElement& element, std::string_view name) const;
    /// The same as a whole number from 0 to `limit`.
    std::int64_t count(const XmlElement& element, std::string_view name, std::int64_t limit) const;
    [[noreturn]] void fail(const std::string& message) const;

 private:
    int peek();
    char take();
    void expect(std::string_view text);
    void skipBlanks();
    std::string name();
    char entity();
    void endTag();

    File file_;
    std::string buffer_;
    std::size_t position_ = 0;
    std::uint64_t passed_ = 0;       // bytes before the buffer
    std::vector<std::string> open_;  // names of the open elements
    bool empty_ = false;             // the last one was <.../>
    bool began_ = false;
};

}  // namespace sphinx::io
