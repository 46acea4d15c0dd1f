// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The containers of type.h, as thin typed shells around code that works on TypeBase. Only type.h
// includes this, at its end.

namespace sphinx::input {
namespace detail {

using TypePointer = std::shared_ptr<const TypeBase>;

/// How to use a std::vector<T> or vector of pairs without knowing T.
struct Sequence {
    void* (*append)(void* vector);  ///< adds an element, returns its address
    void (*clear)(void* vector);
    std::size_t (*size)(const void* vector);
    const void* (*element)(const void* vector, std::size_t i);
};
TypePointer makeList(TypePointer element, Sequence sequence);
/// Elements are std::pair<Name, T>; `second` gives the address of the T.
TypePointer makeMap(TypePointer key, TypePointer value, Sequence sequence, Name* (*first)(void*),
                    void* (*second)(void*));

struct OptionalAccess {
    void* (*engage)(void* optional);  ///< makes a default value, returns its address
    void (*reset)(void* optional);
    const void* (*get)(const void* optional);  ///< null when empty
};
TypePointer makeOptional(TypePointer type, OptionalAccess access);
TypePointer makeWordOr(std::string word, TypePointer type, OptionalAccess access);
TypePointer makeStructure(const Declaration& declaration);

template <class T>
OptionalAccess optionalAccess() {
    using Optional = std::optional<T>;
    return {[](void* o) -> void* { return &static_cast<Optional*>(o)->emplace(); },
            [](void* o) { static_cast<Optional*>(o)->reset(); },
            [](const void* o) -> const void* {
                const auto& value = *static_cast<const Optional*>(o);
                return value ? &*value : nullptr;
            }};
}

template <class T>
Sequence sequenceOf() {
    using Vector = std::vector<T>;
    return {[](void* v) -> void* { return &static_cast<Vector*>(v)->emplace_back(); },
            [](void* v) { static_cast<Vector*>(v)->clear(); },
            [](const void* v) { return static_cast<const Vector*>(v)->size(); },
            [](const void* v, std::size_t i) -> const void* {
                return &(*static_cast<const Vector*>(v))[i];
            }};
}

}  // namespace detail

template <class P>
Type<P> structure(const Declaration& declaration) {
    return Type<P>(detail::makeStructure(declaration));
}

template <class T>
Type<std::vector<T>> list(Type<T> element) {
    return Type<std::vector<T>>(detail::makeList(element.base(), detail::sequenceOf<T>()));
}

inline Type<std::vector<double>> list(const Number& element) { return list(Type<double>(element)); }
inline Type<std::vector<int>> list(const Integer& element) { return list(Type<int>(element)); }

template <class T>
Type<std::optional<T>> optional(Type<T> type) {
    return Type<std::optional<T>>(detail::makeOptional(type.base(), detail::optionalAccess<T>()));
}

template <class T>
Type<std::optional<T>> wordOr(std::string word, Type<T> type) {
    return Type<std::optional<T>>(
        detail::makeWordOr(std::move(word), type.base(), detail::optionalAccess<T>()));
}

template <class T>
Type<std::vector<std::pair<Name, T>>> mapOf(Type<Name> key, Type<T> value) {
    using Pair = std::pair<Name, T>;
    return Type<std::vector<Pair>>(detail::makeMap(
        key.base(), value.base(), detail::sequenceOf<Pair>(),
        [](void* p) { return &static_cast<Pair*>(p)->first; },
        [](void* p) -> void* { return &static_cast<Pair*>(p)->second; }));
}

}  // namespace sphinx::input
