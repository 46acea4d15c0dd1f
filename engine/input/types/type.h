// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/unit.h"
#include "input/expressions/expression.h"
#include "input/tree/node.h"
#include "input/types/values.h"

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sphinx::input {

class Declaration;
class Reader;
class SchemaBuilder;

/// What a value of a case may be: reads it, writes it, and describes itself to people and editors.
/// Works on void*: the one C++ type it stands for is fixed by Type<T>.
class TypeBase {
 public:
    virtual ~TypeBase() = default;

    /// Reads into *value. False: an error was reported and *value means nothing.
    virtual bool read(const Node& node, Reader& reader, void* value) const = 0;
    /// The resolved form. `source` is what it was read from (its place is kept), null for a
    /// default.
    virtual Node write(const void* value, const Node* source) const = 0;
    /// JSON Schema of the value.
    virtual Node schema(SchemaBuilder& builder) const = 0;
    /// For people: "number above 0, mass/length^3".
    virtual std::string text() const = 0;
    /// The same in a message, behind "must be".
    virtual std::string wanted() const { return text(); }

    /// Names of things that the value refers to.
    virtual void names(const void*, std::vector<Name>&) const {}
    /// True when there is nothing to write (an optional without value).
    virtual bool absent(const void*) const { return false; }
};

/// A TypeBase that stands for the C++ type T.
template <class T>
class Type {
 public:
    explicit Type(std::shared_ptr<const TypeBase> base) : base_(std::move(base)) {}
    const std::shared_ptr<const TypeBase>& base() const { return base_; }

 private:
    std::shared_ptr<const TypeBase> base_;
};

/// A number, expression or quantity, converted to case units.
class Number {
 public:
    explicit Number(Dimension unit) : unit_(unit) {}
    Number& above(double bound) { return lower_ = bound, lower_open_ = true, *this; }
    Number& atLeast(double bound) { return lower_ = bound, lower_open_ = false, *this; }
    Number& below(double bound) { return upper_ = bound, upper_open_ = true, *this; }
    Number& atMost(double bound) { return upper_ = bound, upper_open_ = false, *this; }
    operator Type<double>() const;

    Dimension unit() const { return unit_; }
    /// Empty when the value is inside, else "must be above 0".
    std::string violation(double value) const;
    std::string rangeText() const;      ///< "above 0 and at most 1", or empty
    void addRange(Node& schema) const;  ///< minimum, exclusiveMaximum, ...

 private:
    Dimension unit_;
    std::optional<double> lower_, upper_;
    bool lower_open_ = false;
    bool upper_open_ = false;
};
inline Number number(Dimension unit) { return Number(unit); }

/// A whole number: decimal digits, or an expression with a whole result.
class Integer {
 public:
    Integer& atLeast(std::int64_t bound) { return lower_ = bound, *this; }
    Integer& atMost(std::int64_t bound) { return upper_ = bound, *this; }
    operator Type<int>() const;
    operator Type<std::int64_t>() const;

 private:
    std::optional<std::int64_t> lower_, upper_;
};
inline Integer integer() { return {}; }

Type<bool> boolean();      ///< true or false
Type<std::string> text();  ///< any scalar
Type<std::string> file();  ///< an existing file, relative to the file that names it; made absolute

/// One word of a closed set.
template <class E>
struct Choice {
    std::string name;
    E value;
    std::string doc;
};
namespace detail {
struct ChoiceEntry {
    std::string name;
    long long value;
    std::string doc;
};
std::shared_ptr<const TypeBase> makeChoice(std::vector<ChoiceEntry> entries,
                                           void (*set)(void*, long long),
                                           long long (*get)(const void*));
}  // namespace detail
template <class E>
Type<E> choice(std::initializer_list<Choice<E>> choices) {
    std::vector<detail::ChoiceEntry> entries;
    for (const Choice<E>& c : choices)
        entries.push_back({c.name, static_cast<long long>(c.value), c.doc});
    return Type<E>(detail::makeChoice(
        std::move(entries), [](void* p, long long v) { *static_cast<E*>(p) = static_cast<E>(v); },
        [](const void* p) { return static_cast<long long>(*static_cast<const E*>(p)); }));
}

/// Axes of the case: [x, y], 0 is x.
Type<std::vector<int>> axes();

/// References; that the named thing exists and fits is checked once everything has been read.
/// `traits`: one of them must be the body's kind (fluid, solid, observer), its material's type, or
/// a trait of that type's declaration (elastic, rigid).
Type<Name> bodyReference(std::vector<std::string> traits = {});
/// A body, or a part of it: "gate.base".
Type<Name> partReference(std::vector<std::string> traits = {});
Type<Name> materialReference(std::vector<std::string> traits = {});
Type<Name> shapeReference();
Type<Name> actionReference();  ///< METHOD or METHOD.ACTION
Type<Name> layerReference();
Type<Name> fieldReference();  ///< a name of particles/fields.h
/// A body of the block `multibody`, or the ground.
Type<Name> rigidBodyReference(bool or_ground = false);
Type<Name> jointReference();
Type<Name> multibodyForceReference();  ///< an entry of `multibody.forces`
/// A name that the author chooses here; see checkNewName().
Type<Name> newName();

/// A point or vector of the case's dimension.
Type<Coordinates> coordinates(Dimension unit);
/// A number or an expression of x, y, z, t.
Type<FieldExpression> fieldExpression(Dimension unit);
/// One per dimension.
Type<std::vector<FieldExpression>> fieldVector(Dimension unit);
/// Rows of one number per dimension, [[1, 2], [3, 4]] or {file: NAME}.
Type<Table> table(Dimension unit);
/// The same with one more number of another unit at the end of each row.
Type<Table> table(Dimension unit, Dimension last);
/// The same where the format of the file is the business of whoever uses it: rows stay empty.
Type<Table> tableOrFile(Dimension unit);
/// Seconds on the clock on the wall, whatever the units of the case: a number or a quantity of
/// time.
Type<double> wallSeconds();

/// A map with the keys of that declaration, read into its parameter struct.
template <class P>
Type<P> structure(const Declaration& declaration);

template <class T>
Type<std::vector<T>> list(Type<T> element);
template <class T>
Type<std::optional<T>> optional(Type<T> type);
/// The word, which stands for no value, or a value that is not a scalar.
template <class T>
Type<std::optional<T>> wordOr(std::string word, Type<T> type);
/// A map whose keys are references, in the order written.
template <class T>
Type<std::vector<std::pair<Name, T>>> mapOf(Type<Name> key, Type<T> value);

}  // namespace sphinx::input

#include "input/types/type_templates.h"
