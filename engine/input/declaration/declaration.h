// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/access.h"
#include "input/declaration/sources.h"
#include "input/expressions/units.h"
#include "input/types/type.h"

#include <any>
#include <cassert>
#include <deque>
#include <functional>
#include <type_traits>
#include <typeinfo>

namespace sphinx::input {

/// What kind of thing a declaration is about. Blocks are the fixed parts of the language.
enum class Kind {
    block,
    shape,
    kernel,
    material,
    dynamics,
    joint,
    multibody_force,
    multibody_constraint,
    output,
    field
};
const char* kindName(Kind kind);
inline constexpr std::array all_kinds{
    Kind::block,    Kind::shape, Kind::kernel,          Kind::material,
    Kind::dynamics, Kind::joint, Kind::multibody_force, Kind::multibody_constraint,
    Kind::output,   Kind::field};

/// Something that a loop line can call.
class Action {
 public:
    Action(std::string name, std::string doc) : name_(std::move(name)), doc_(std::move(doc)) {}
    using Fields = std::initializer_list<std::string_view>;
    Action& reads(const std::string& owner, Fields fields) {
        return add(AccessMode::read, owner, fields);
    }
    Action& writes(const std::string& owner, Fields fields) {
        return add(AccessMode::write, owner, fields);
    }
    /// The same where another method of the loop writes the fields, else nothing.
    Action& mayRead(const std::string& owner, Fields fields) {
        return add(AccessMode::read, owner, fields, true);
    }
    Action& mayWrite(const std::string& owner, Fields fields) {
        return add(AccessMode::write, owner, fields, true);
    }
    Action& accumulates(const std::string& owner, Fields fields) {
        return add(AccessMode::accumulate, owner, fields);
    }
    /// The same of a field that is a result, which outputs alone may read; who adds takes it back.
    Action& tells(const std::string& owner, Fields fields) {
        return add(AccessMode::accumulate, owner, fields, false, true);
    }
    Action& releases(const std::string& owner, Fields fields) {
        return add(AccessMode::release, owner, fields);
    }
    Action& opens(const std::string& owner, std::string_view span) {
        return add(AccessMode::open, owner, {span});
    }
    Action& closes(const std::string& owner, std::string_view span) {
        return add(AccessMode::close, owner, {span});
    }
    Action& within(const std::string& owner, std::string_view span) {
        return add(AccessMode::within, owner, {span});
    }
    /// The method has an effect on its body that is there without being called: a line that calls
    /// it has no every, from or until. `why`: the reason and the way out.
    Action& throughout(std::string why);

    const std::string& name() const { return name_; }  ///< empty: the method's only one
    const std::string& doc() const { return doc_; }
    const std::vector<Access>& accesses() const { return accesses_; }
    const std::string& throughout() const { return throughout_; }  ///< empty: it may act at times

    /// What the owner of the kind attaches: of a method, what the action calls.
    template <class T>
    void payload(T attached) {
        payload_ = std::move(attached);
    }
    /// T must be the exact type of what was attached.
    template <class T>
    const T& payload() const {
        const T* attached = std::any_cast<T>(&payload_);
        assert(attached && "nothing of this type is attached to the action");
        return *attached;
    }

 private:
    Action& add(AccessMode mode, const std::string& owner, Fields fields, bool if_made = false,
                bool result = false);

    std::string name_;
    std::string doc_;
    std::string throughout_;
    std::vector<Access> accesses_;
    std::any payload_;
};

/// One parameter of a declaration, without the C++ type of its struct.
struct Parameter {
    std::string name;  ///< empty: the declaration is written as this bare value, not as a map
    bool required = false;
    std::shared_ptr<const TypeBase> type;
    std::string doc;
    std::function<void*(void*)> member;  ///< address of the value in the parameter struct

    const void* in(const void* parameters) const { return member(const_cast<void*>(parameters)); }
};

/// Where a formula or method comes from.
struct Citation {
    const Publication* publication;  ///< never null
    std::string where;               ///< equation or remark: "(54)"; empty: the whole

    /// "guide (54)"
    std::string text() const {
        return std::string(publication->key) + (where.empty() ? "" : " " + where);
    }
};

/// The one place that says what a component or block is; validation, `describe`, `list`, the JSON
/// Schema, the reference page, `show` and the check of the loop read it.
class Declaration {
 public:
    virtual ~Declaration() = default;

    Kind kind() const { return kind_; }
    const std::string& name() const { return name_; }
    const std::string& summary() const { return summary_; }
    const std::string& formula() const { return formula_; }
    const std::vector<Citation>& citations() const { return citations_; }
    const std::vector<std::string>& traits() const { return traits_; }
    bool hasTrait(std::string_view trait) const;

    const std::deque<Parameter>& parameters() const { return parameters_; }
    const Parameter* parameter(std::string_view name) const;
    bool bare() const { return parameters_.size() == 1 && parameters_.front().name.empty(); }

    /// Empty for a declaration without actions (materials, outputs, blocks).
    const std::deque<Action>& actions() const { return actions_; }
    /// Index of the action of that name, or -1.
    int actionIndex(std::string_view name) const;
    bool isTimeStep() const { return is_time_step_; }

    /// What the owner of the kind attached (dynamics: the factories for 2D and 3D). T must be the
    /// exact type of what was given to builder().
    template <class T>
    const T& builder() const {
        const T* attached = std::any_cast<T>(&builder_);
        assert(attached && "no builder of this type is attached to the declaration");
        return *attached;
    }

    const std::type_info& parametersType() const { return *type_; }
    std::shared_ptr<void> makeParameters() const { return make_(); }

    /// A rule across parameters: `violated` returns what is wrong or an empty text; the message
    /// is placed at that parameter.
    struct Rule {
        std::string parameter;
        std::function<std::string(const void*, const UnitSystem&)> violated;
    };
    const std::vector<Rule>& rules() const { return rules_; }

 protected:
    Declaration(Kind kind, std::string name, const std::type_info& type,
                std::function<std::shared_ptr<void>()> make)
        : kind_(kind), name_(std::move(name)), type_(&type), make_(std::move(make)) {}
    void add(Parameter parameter);
    void cite(std::string_view key, std::string where);

    Kind kind_;
    std::string name_;
    std::string summary_;
    std::string formula_;
    std::vector<Citation> citations_;
    std::vector<std::string> traits_;
    std::deque<Parameter> parameters_;
    std::deque<Action> actions_;
    std::vector<Rule> rules_;
    bool is_time_step_ = false;
    std::any builder_;
    const std::type_info* type_;
    std::function<std::shared_ptr<void>()> make_;
};

/// A declaration with the parameter struct P; defaults are those of P{}.
template <class P>
class Declared : public Declaration {
 public:
    Declared(Kind kind, std::string name)
        : Declaration(kind, std::move(name), typeid(P), [] { return std::make_shared<P>(); }) {}

    Declared& summary(std::string text) { return summary_ = std::move(text), *this; }
    Declared& formula(std::string text) { return formula_ = std::move(text), *this; }
    /// A publication of the list in sources.h, and where in it. Asserts that it is there.
    Declared& cite(std::string_view key, std::string where = "") {
        return Declaration::cite(key, std::move(where)), *this;
    }
    /// A property that references may ask for, such as "elastic". Of methods: "sums_over_itself"
    /// (its body must see itself), "permutes" (it reorders particles) and "removes" (it takes
    /// particles out of fluids where the domain says so).
    Declared& trait(std::string name) { return traits_.push_back(std::move(name)), *this; }

    template <class T, class Q>
    Declared& required(std::string name, T Q::*member, std::type_identity_t<Type<T>> type,
                       std::string doc) {
        return parameter(std::move(name), true, member, type.base(), std::move(doc));
    }
    template <class T, class Q>
    Declared& optional(std::string name, T Q::*member, std::type_identity_t<Type<T>> type,
                       std::string doc) {
        return parameter(std::move(name), false, member, type.base(), std::move(doc));
    }
    /// Without a value when the key is missing.
    template <class T, class Q>
    Declared& optional(std::string name, std::optional<T> Q::*member,
                       std::type_identity_t<Type<T>> type, std::string doc) {
        return parameter(std::move(name), false, member, input::optional(type).base(),
                         std::move(doc));
    }
    /// The value itself stands where others have a map of parameters: {union: [a, b]}.
    template <class T, class Q>
    Declared& bareValue(T Q::*member, std::type_identity_t<Type<T>> type, std::string doc) {
        return parameter("", true, member, type.base(), std::move(doc));
    }

    /// `violated` takes the parameters and, where its message has numbers with a unit, the units.
    template <class Violated>
    Declared& check(std::string parameter, Violated violated) {
        const auto call = [violated](const void* parameters,
                                     [[maybe_unused]] const UnitSystem& units) -> std::string {
            const P& p = *static_cast<const P*>(parameters);
            if constexpr (std::is_invocable_v<Violated, const P&, const UnitSystem&>)
                return violated(p, units);
            else
                return violated(p);
        };
        rules_.push_back({std::move(parameter), call});
        return *this;
    }

    /// Marks a method that a layer's `dt` names; the accesses are those of its estimate.
    Action& timeStep(std::string doc) {
        is_time_step_ = true;
        return addAction("", std::move(doc));
    }
    template <class T>
    Declared& builder(T payload) {
        return builder_ = std::move(payload), *this;
    }
    using Declaration::builder;
    using Declaration::formula;
    using Declaration::parameter;
    using Declaration::summary;

 protected:
    Action& addAction(std::string name, std::string doc) {
        return actions_.emplace_back(std::move(name), std::move(doc));
    }

 private:
    template <class T, class Q>
    Declared& parameter(std::string name, bool required, T Q::*member,
                        std::shared_ptr<const TypeBase> type, std::string doc) {
        add({std::move(name), required, std::move(type), std::move(doc),
             [member](void* p) -> void* { return &(static_cast<P*>(p)->*member); }});
        return *this;
    }
};

}  // namespace sphinx::input
