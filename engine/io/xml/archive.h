// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/archive.h"
#include "io/xml/reader.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace sphinx::io {

/// Collects small state as XML elements: <section name="loop"><number name="time">1.5</number>...,
/// arrays as <numbers name="offset" values="2">0 0.25</numbers>. Doubles keep every bit
/// (appendExactNumber).
class XmlSaveArchive final : public Archive {
 public:
    bool loading() const override { return false; }
    bool has(std::string_view) const override { return true; }
    void enter(std::string_view name) override;
    void leave() override { ++left_; }

    /// Everything saved so far, in lines.
    const std::string& xml();

 private:
    void transfer(std::string_view name, ArchiveValue& v) override;
    void endSections();

    std::string xml_;
    int left_ = 0;  // sections whose end is written before what comes next: that may need memory
};

/// Gives back what an XmlSaveArchive collected. What is not there is a FileError that names it.
class XmlLoadArchive final : public Archive {
 public:
    /// Reads the children of the element that was opened last.
    explicit XmlLoadArchive(XmlReader& reader, const Path& path);
    ~XmlLoadArchive() override;

    bool loading() const override { return true; }
    bool has(std::string_view name) const override;
    void enter(std::string_view name) override;
    void leave() override;

 private:
    struct SectionNode;

    void transfer(std::string_view name, ArchiveValue& v) override;
    void read(XmlReader& reader, SectionNode& section);
    [[noreturn]] void failMissing(const std::string& kind, std::string_view name) const;

    Path path_;
    std::unique_ptr<SectionNode> root_;
    std::vector<SectionNode*> open_;  // the root first
    std::vector<std::string> names_;
};

/// <NAME ...>text</NAME>, or as base64 in <binary_NAME ...> if XML cannot say the text.
void appendTextElement(std::string& xml, std::string_view element, std::string_view attributes,
                       std::string_view text);
/// Text of such an element, which was opened last.
std::string readTextElement(XmlReader& reader, const XmlElement& element);

}  // namespace sphinx::io
