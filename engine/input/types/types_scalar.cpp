// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/declaration/reader.h"
#include "input/expressions/decimal.h"
#include "input/tree/suggest.h"
#include "input/types/type_support.h"

#include <fmt/format.h>
#include <cmath>
#include <filesystem>

namespace sphinx::input {
namespace {

std::string bound(double value) { return fmt::format("{}", value); }

class NumberType final : public TypeBase {
 public:
    explicit NumberType(Number rule) : rule_(std::move(rule)) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        const auto value = reader.number(node, rule_.unit());
        if (!value) return false;
        if (const std::string violation = rule_.violation(*value); !violation.empty())
            return reader.error(node, fmt::format("{} is {}{} but {}", reader.label, *value,
                                                  reader.units.suffix(rule_.unit()), violation));
        *static_cast<double*>(out) = *value;
        return true;
    }
    Node write(const void* value, const Node* source) const override {
        return Node::number(*static_cast<const double*>(value)).at(placeOf(source));
    }
    Node schema(SchemaBuilder&) const override {
        Node schema = numberSchema();
        rule_.addRange(schema);
        return schema;
    }
    std::string text() const override {
        const std::string range = rule_.rangeText();
        return "number" + (range.empty() ? "" : " " + range) +
               (rule_.unit() == unit::none ? "" : ", " + dimensionText(rule_.unit()));
    }

 private:
    Number rule_;
};

template <class T>
class IntegerType final : public TypeBase {
 public:
    IntegerType(std::optional<std::int64_t> lower, std::optional<std::int64_t> upper)
        : lower_(lower), upper_(upper) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        std::optional<std::int64_t> value;
        if (node.isScalar()) value = parseDecimal<std::int64_t>(node.text);
        if (!value) {
            const auto number = reader.number(node, unit::none);
            if (!number) return false;
            if (*number != std::floor(*number) || std::abs(*number) > 9e15)
                return reader.error(node, fmt::format("{} is {} but must be a whole number",
                                                      reader.label, *number));
            value = static_cast<std::int64_t>(*number);
        }
        const std::string range = rangeText();
        if ((lower_ && *value < *lower_) || (upper_ && *value > *upper_))
            return reader.error(
                node, fmt::format("{} is {} but must be {}", reader.label, *value, range));
        if (*value != static_cast<T>(*value))
            return reader.error(node,
                                fmt::format("{} is {}, which is too large", reader.label, *value));
        *static_cast<T*>(out) = static_cast<T>(*value);
        return true;
    }
    Node write(const void* value, const Node* source) const override {
        return Node::integer(*static_cast<const T*>(value)).at(placeOf(source));
    }
    Node schema(SchemaBuilder&) const override {
        Node schema = Node::map();
        schema.set("type", Node::list({Node::string("integer"), Node::string("string")}));
        if (lower_) schema.set("minimum", Node::integer(*lower_));
        if (upper_) schema.set("maximum", Node::integer(*upper_));
        return schema;
    }
    std::string text() const override {
        const std::string range = rangeText();
        return "whole number" + (range.empty() ? "" : " " + range);
    }

 private:
    std::string rangeText() const {
        if (lower_ && upper_ && *lower_ == *upper_) return fmt::format("{}", *lower_);
        if (lower_ && upper_) return fmt::format("from {} to {}", *lower_, *upper_);
        if (lower_) return fmt::format("at least {}", *lower_);
        return upper_ ? fmt::format("at most {}", *upper_) : "";
    }
    std::optional<std::int64_t> lower_, upper_;
};

class BooleanType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!node.isScalar() || node.quoted || (node.text != "true" && node.text != "false"))
            return reader.mismatch(node, "true or false");
        *static_cast<bool*>(out) = node.text == "true";
        return true;
    }
    Node write(const void* value, const Node* source) const override {
        return Node::plain(*static_cast<const bool*>(value) ? "true" : "false").at(placeOf(source));
    }
    Node schema(SchemaBuilder&) const override { return schemaType("boolean"); }
    std::string text() const override { return "true or false"; }
};

class TextType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!node.isScalar()) return reader.mismatch(node, "a text");
        *static_cast<std::string*>(out) = node.text;
        return true;
    }
    Node write(const void* value, const Node* source) const override {
        return Node::string(*static_cast<const std::string*>(value)).at(placeOf(source));
    }
    Node schema(SchemaBuilder&) const override {
        Node schema = Node::map();
        schema.set("type", Node::list({Node::string("string"), Node::string("number")}));
        return schema;
    }
    std::string text() const override { return "text"; }
};

class FileType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!node.isScalar()) return reader.mismatch(node, "the name of a file");
        namespace fs = std::filesystem;
        const fs::path path = fs::path(node.place.source->folder) / node.text;
        std::error_code error;
        if (!fs::is_regular_file(path, error))
            return reader.error(node, "there is no file " + path.lexically_normal().string());
        auto& file = *static_cast<std::string*>(out);
        file = fs::absolute(path, error).lexically_normal().string();
        reader.files.push_back(file);
        return true;
    }
    Node write(const void* value, const Node* source) const override {
        return Node::string(*static_cast<const std::string*>(value)).at(placeOf(source));
    }
    Node schema(SchemaBuilder&) const override { return schemaType("string"); }
    std::string text() const override { return "file name"; }
};

class WallSecondsType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        const auto value =
            reader.scope.number(node, unit::time, reader.label, UnitSystem{}, reader.diagnostics);
        if (!value) return false;
        if (*value <= 0)
            return reader.error(
                node, fmt::format("{} is {} s but must be above 0", reader.label, *value));
        *static_cast<double*>(out) = *value;
        return true;
    }
    Node write(const void* value, const Node* source) const override {
        return Node::plain(fmt::format("{} s", *static_cast<const double*>(value)))
            .at(placeOf(source));
    }
    Node schema(SchemaBuilder&) const override {
        Node schema = numberSchema();
        schema.set("exclusiveMinimum", Node::integer(0));
        return schema;
    }
    std::string text() const override {
        return "wall time, such as 30 min; a bare number is seconds";
    }
};

class ChoiceType final : public TypeBase {
 public:
    ChoiceType(std::vector<detail::ChoiceEntry> entries, void (*set)(void*, long long),
               long long (*get)(const void*))
        : entries_(std::move(entries)), set_(set), get_(get) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        if (node.isScalar()) {
            for (const auto& entry : entries_)
                if (entry.name == node.text) return set_(out, entry.value), true;
            return reader.error(node, reader.label + " cannot be '" + node.text + "'" +
                                          didYouMean(node.text, names()));
        }
        return reader.mismatch(node, alternatives(names()));
    }
    Node write(const void* value, const Node* source) const override {
        const long long current = get_(value);
        for (const auto& entry : entries_)
            if (entry.value == current) return Node::plain(entry.name).at(placeOf(source));
        return {};
    }
    Node schema(SchemaBuilder&) const override {
        Node schema = Node::map();
        Node& all = schema.set("enum", Node::list());
        for (const auto& entry : entries_) all.add(Node::plain(entry.name));
        return schema;
    }
    std::string text() const override {
        std::string text;
        for (const auto& entry : entries_)
            text += (text.empty() ? "" : " | ") + entry.name +
                    (entry.doc.empty() ? "" : " (" + entry.doc + ")");
        return text;
    }

 private:
    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const auto& entry : entries_) names.push_back(entry.name);
        return names;
    }
    std::vector<detail::ChoiceEntry> entries_;
    void (*set_)(void*, long long);
    long long (*get_)(const void*);
};

}  // namespace

std::string Number::violation(double value) const {
    const bool below = lower_ && (lower_open_ ? value <= *lower_ : value < *lower_);
    const bool above = upper_ && (upper_open_ ? value >= *upper_ : value > *upper_);
    return below || above ? "must be " + rangeText() : "";
}

std::string Number::rangeText() const {
    std::string text;
    if (lower_) text = (lower_open_ ? "above " : "at least ") + bound(*lower_);
    if (upper_)
        text += (text.empty() ? "" : " and ") + std::string(upper_open_ ? "below " : "at most ") +
                bound(*upper_);
    return text;
}

void Number::addRange(Node& schema) const {
    if (lower_) schema.set(lower_open_ ? "exclusiveMinimum" : "minimum", Node::number(*lower_));
    if (upper_) schema.set(upper_open_ ? "exclusiveMaximum" : "maximum", Node::number(*upper_));
}

Number::operator Type<double>() const { return Type<double>(std::make_shared<NumberType>(*this)); }
Integer::operator Type<int>() const {
    return Type<int>(std::make_shared<IntegerType<int>>(lower_, upper_));
}
Integer::operator Type<std::int64_t>() const {
    return Type<std::int64_t>(std::make_shared<IntegerType<std::int64_t>>(lower_, upper_));
}
Type<bool> boolean() { return Type<bool>(std::make_shared<BooleanType>()); }
Type<std::string> text() { return Type<std::string>(std::make_shared<TextType>()); }
Type<std::string> file() { return Type<std::string>(std::make_shared<FileType>()); }
Type<double> wallSeconds() { return Type<double>(std::make_shared<WallSecondsType>()); }

std::shared_ptr<const TypeBase> detail::makeChoice(std::vector<ChoiceEntry> entries,
                                                   void (*set)(void*, long long),
                                                   long long (*get)(const void*)) {
    return std::make_shared<ChoiceType>(std::move(entries), set, get);
}

}  // namespace sphinx::input
