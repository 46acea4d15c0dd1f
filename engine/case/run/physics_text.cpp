// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/run/physics_text.h"

#include "input/tree/yaml.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace sphinx::run {
namespace {

void drop(input::Node& map, std::string_view key) {
    std::erase_if(map.entries, [&](const input::Node::Entry& e) { return e.key == key; });
}

/// Observers look at the particles, which do not feel them.
void dropObservers(input::Node& resolved, const model::Case& model) {
    for (const char* block : {"bodies", "topology"}) {
        input::Node* map = resolved.find(block);
        if (!map) continue;
        for (const model::Body& body : model.bodies)
            if (body.role == bodies::Role::observer) drop(*map, body.name);
        if (map->entries.empty()) drop(resolved, block);
    }
}

/// A file is what it holds, wherever it lies.
void replaceFiles(input::Node& node, const std::map<std::string, std::string>& files) {
    for (input::Node& item : node.items) replaceFiles(item, files);
    for (input::Node::Entry& entry : node.entries) {
        const auto file = entry.key == "file" ? files.find(entry.value.text) : files.end();
        if (file != files.end())
            entry.value = input::Node::string(file->second);
        else
            replaceFiles(entry.value, files);
    }
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace

std::string physicsText(const model::Case& model) {
    input::Node resolved = model.resolved;
    // Of the variables only those are left that expressions of place and time use.
    for (const char* key : {"title", "outputs", "include"}) drop(resolved, key);
    // A restart outlives versions of the language that leave the state as it is.
    resolved.set("sphinx", input::Node::integer(model.state_version));
    if (input::Node* loop = resolved.find("loop")) drop(*loop, "end_time");
    // What happens to a particle that leaves changes nothing as long as none does.
    if (input::Node* domain = resolved.find("domain")) {
        drop(*domain, "lost_particles");
        if (domain->entries.empty()) drop(resolved, "domain");
    }
    dropObservers(resolved, model);
    replaceFiles(resolved, model.files);
    return input::writeYaml(resolved, false);
}

std::string difference(const std::string& before, const std::string& after, std::size_t limit) {
    std::vector<std::string> a = linesOf(before);
    std::vector<std::string> b = linesOf(after);
    // Most lines are the same, and the table below is as large as both texts multiplied.
    while (!a.empty() && !b.empty() && a.back() == b.back()) a.pop_back(), b.pop_back();
    const auto [first_a, first_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    a.erase(a.begin(), first_a);
    b.erase(b.begin(), first_b);
    // Length of the longest common subsequence of the rests, for the shortest list of changes.
    std::vector<std::vector<std::size_t>> common(a.size() + 1,
                                                 std::vector<std::size_t>(b.size() + 1, 0));
    for (std::size_t i = a.size(); i-- > 0;)
        for (std::size_t j = b.size(); j-- > 0;)
            common[i][j] = a[i] == b[j] ? common[i + 1][j + 1] + 1
                                        : std::max(common[i + 1][j], common[i][j + 1]);
    std::string text;
    std::size_t count = 0;
    for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
        if (i < a.size() && j < b.size() && a[i] == b[j]) {
            ++i;
            ++j;
            continue;
        }
        const bool removed =
            j == b.size() || (i < a.size() && common[i + 1][j] >= common[i][j + 1]);
        const std::string line = removed ? "- " + a[i] : "+ " + b[j];
        removed ? ++i : ++j;
        if (count < limit) text += line + "\n";
        if (count == limit) text += "...\n";
        ++count;
    }
    return text;
}

}  // namespace sphinx::run
