// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/tree/json.h"

#include <nlohmann/json.hpp>

namespace sphinx::input {
namespace {

using Json = nlohmann::ordered_json;

Json scalar(const Node& node) {
    if (node.quoted) return node.text;
    Json literal = Json::parse(node.text, nullptr, false);
    if (literal.is_number() || literal.is_boolean() || literal.is_null()) return literal;
    return node.text;
}

Json json(const Node& node) {
    switch (node.kind) {
        case Node::Kind::null: return nullptr;
        case Node::Kind::scalar: return scalar(node);
        case Node::Kind::list: {
            Json list = Json::array();
            for (const Node& item : node.items) list.push_back(json(item));
            return list;
        }
        case Node::Kind::map: break;
    }
    Json map = Json::object();
    for (const Node::Entry& entry : node.entries) map[entry.key] = json(entry.value);
    return map;
}

}  // namespace

std::string writeJson(const Node& node) {
    // Names of files may hold any bytes; JSON is UTF-8.
    return json(node).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sphinx::input
