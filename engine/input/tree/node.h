// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/tree/place.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sphinx::input {

/// One value of a case with its place: nothing, a scalar, a list, or a map in the order written.
/// The same tree carries what was read, what was resolved, and the JSON Schema.
class Node {
 public:
    enum class Kind { null, scalar, list, map };
    struct Entry;

    Node() = default;
    explicit Node(Kind kind);
    /// A plain scalar: number, name, true or false.
    static Node plain(std::string text);
    static Node number(double value);  ///< shortest decimals that read back the same
    static Node integer(std::int64_t value);
    /// A scalar that is a string whatever it looks like.
    static Node string(std::string text);
    static Node list();
    static Node list(std::vector<Node> items);
    static Node map();

    bool isNull() const { return kind == Kind::null; }
    bool isScalar() const { return kind == Kind::scalar; }
    bool isList() const { return kind == Kind::list; }
    bool isMap() const { return kind == Kind::map; }

    /// Value of that key, or nullptr.
    const Node* find(std::string_view key) const;
    Node* find(std::string_view key);
    /// Sets or replaces the value of a key; returns it.
    Node& set(std::string_view key, Node value);
    Node& add(Node item);
    /// The same value at another place.
    Node at(Place where) &&;

    Kind kind = Kind::null;
    bool quoted = false;  ///< scalar in quotes: never a number
    bool flow = false;    ///< written as [...] or {...}, or inside one
    std::string text;     ///< of a scalar
    std::vector<Node> items;
    std::vector<Entry> entries;
    Place place;
};

struct Node::Entry {
    std::string key;
    Place place;  ///< of the key
    Node value;
};

/// "a list", "a map", "the text 'abc'": for messages.
std::string describeNode(const Node& node);

}  // namespace sphinx::input
