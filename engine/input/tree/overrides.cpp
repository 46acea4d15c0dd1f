// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/tree/overrides.h"

#include "input/tree/suggest.h"
#include "input/tree/yaml.h"

#include <algorithm>
#include <charconv>

namespace sphinx::input {
namespace {

constexpr std::size_t longest_path = 20;

struct Piece {
    std::string text;
    Place place;
};

std::vector<std::string> keys(const Node& map) {
    std::vector<std::string> keys;
    for (const Node::Entry& entry : map.entries) keys.push_back(entry.key);
    return keys;
}

Node* findItem(Node& list, const std::string& word) {
    for (Node& item : list.items)
        if (const Node* layer = item.find("layer"); layer && layer->text == word) return &item;
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    const bool is_number = error == std::errc() && end == word.data() + word.size();
    return is_number && index < list.items.size() ? &list.items[index] : nullptr;
}

bool isVariable(const Node& root, const std::string& name) {
    const Node* variables = root.find("variables");
    return variables && variables->find(name);
}

void apply(Node& root, const std::vector<Piece>& path, const std::vector<std::string>& named_blocks,
           Node value, Diagnostics& diagnostics) {
    Node* node = &root;
    std::string so_far;
    for (std::size_t k = 0; k < path.size(); ++k) {
        const Piece& piece = path[k];
        if (node->isList()) {
            Node* item = findItem(*node, piece.text);
            if (!item) {
                diagnostics.error(piece.place, so_far + " has no item '" + piece.text +
                                                   "'; items are counted from 0, layers are "
                                                   "found by their name");
                return;
            }
            node = item;
        } else {
            if (!node->isMap()) {
                diagnostics.error(piece.place,
                                  so_far + " is a single value: it has no '" + piece.text + "'");
                return;
            }
            Node* present = node->find(piece.text);
            const bool named = k == 1 && std::find(named_blocks.begin(), named_blocks.end(),
                                                   path[0].text) != named_blocks.end();
            if (!present && k == 0 && path.size() == 1 && isVariable(root, piece.text)) {
                diagnostics.error(
                    piece.place,
                    "'" + piece.text + "' is a variable: write variables." + piece.text);
                return;
            }
            if (const auto bracket = piece.text.find('[');
                !present && bracket != std::string::npos) {
                const std::string list =
                    (so_far.empty() ? "" : so_far + ".") + piece.text.substr(0, bracket);
                diagnostics.error(piece.place, "items of a list are named by their number: write " +
                                                   list + ".0 for the first one");
                return;
            }
            if (!present && named) {
                diagnostics.error(piece.place, so_far + " has no '" + piece.text + "'" +
                                                   didYouMean(piece.text, keys(*node)));
                return;
            }
            if (!present) {
                // Whether the key is known at all is checked like that of any key of the file.
                Node created = Node::map();
                created.place = piece.place;
                present = &node->set(piece.text, std::move(created));
            }
            for (Node::Entry& entry : node->entries)
                if (&entry.value == present && k + 1 == path.size()) entry.place = piece.place;
            node = present;
        }
        so_far += (so_far.empty() ? "" : ".") + piece.text;
    }
    *node = std::move(value);
}

}  // namespace

void applyOverrides(Node& root, const std::vector<std::string>& overrides,
                    const std::vector<std::string>& named_blocks, int source_order,
                    Diagnostics& diagnostics) {
    if (overrides.empty()) return;
    auto source = std::make_shared<Source>();
    source->name = "--set";
    source->folder = ".";
    source->order = source_order;
    for (const std::string& one : overrides) {
        source->text += one;
        // One override is one line; a line end inside becomes a blank.
        std::replace(source->text.end() - static_cast<std::ptrdiff_t>(one.size()),
                     source->text.end(), '\n', ' ');
        source->text += '\n';
    }
    for (std::size_t line = 0; line < overrides.size(); ++line) {
        const std::string text(source->line(static_cast<int>(line) + 1));
        const auto place = [&](std::size_t offset) {
            return Place{source, static_cast<int>(line) + 1, static_cast<int>(offset) + 1};
        };
        const auto equals = text.find('=');
        if (equals == std::string::npos || equals == 0) {
            diagnostics.error(place(0), "expected path=value, such as loop.end_time=1");
            continue;
        }
        if (text.substr(0, equals) == "include") {
            diagnostics.error(place(0),
                              "files are included before values are set: write it in the case");
            continue;
        }
        std::vector<Piece> path;
        for (std::size_t begin = 0; begin <= equals;) {
            const std::size_t end = std::min(text.find('.', begin), equals);
            path.push_back({text.substr(begin, end - begin), place(begin)});
            begin = end + 1;
        }
        if (path.size() > longest_path) {
            diagnostics.error(place(0),
                              "the path has more than " + std::to_string(longest_path) + " keys");
            continue;
        }
        const std::size_t before = diagnostics.errors();
        Node value = readYaml(source, std::string_view(text).substr(equals + 1),
                              {static_cast<int>(line), static_cast<int>(equals) + 1}, diagnostics);
        if (diagnostics.errors() > before) continue;
        if (value.isNull()) {
            diagnostics.error(place(equals), "'" + text.substr(0, equals) + "' has no value");
            continue;
        }
        apply(root, path, named_blocks, std::move(value), diagnostics);
    }
}

}  // namespace sphinx::input
