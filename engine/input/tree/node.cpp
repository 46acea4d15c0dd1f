// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/tree/node.h"

#include <fmt/format.h>

namespace sphinx::input {

Node Node::plain(std::string text) {
    Node node(Kind::scalar);
    node.text = std::move(text);
    return node;
}

Node Node::number(double value) { return plain(fmt::format("{}", value)); }

Node Node::integer(std::int64_t value) { return plain(std::to_string(value)); }

Node Node::string(std::string text) {
    Node node = plain(std::move(text));
    node.quoted = true;
    return node;
}

Node::Node(Kind kind) : kind(kind) {}

Node Node::list() { return Node(Kind::list); }

Node Node::list(std::vector<Node> items) {
    Node node(Kind::list);
    node.items = std::move(items);
    return node;
}

Node Node::map() { return Node(Kind::map); }

const Node* Node::find(std::string_view key) const {
    for (const Entry& entry : entries)
        if (entry.key == key) return &entry.value;
    return nullptr;
}

Node* Node::find(std::string_view key) {
    for (Entry& entry : entries)
        if (entry.key == key) return &entry.value;
    return nullptr;
}

Node& Node::set(std::string_view key, Node value) {
    if (Node* present = find(key)) return *present = std::move(value);
    Place where = value.place;
    return entries.push_back({std::string(key), std::move(where), std::move(value)}),
           entries.back().value;
}

Node& Node::add(Node item) { return items.emplace_back(std::move(item)); }

Node Node::at(Place where) && {
    place = std::move(where);
    return std::move(*this);
}

std::string describeNode(const Node& node) {
    switch (node.kind) {
        case Node::Kind::null: return "empty";
        case Node::Kind::list: return "a list";
        case Node::Kind::map: return "a map";
        case Node::Kind::scalar: break;
    }
    std::string text = node.text.substr(0, 60);
    if (text.size() < node.text.size()) text += "...";
    // The commonest slip that makes a text of a map: {time:0.1}.
    const auto colon = node.text.find(':');
    if (!node.quoted && colon != std::string::npos && colon + 1 < node.text.size() &&
        node.text.find(' ') == std::string::npos)
        return "'" + text + "' (is a blank missing after the colon?)";
    return "'" + text + "'";
}

}  // namespace sphinx::input
