// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/errors.h"
#include "input/tree/json.h"
#include "loop/run/profile.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace sphinx::loop {
namespace {

using input::Node;

Node linesNode(const std::vector<ProfileLine>& lines) {
    Node list = Node::list();
    for (const ProfileLine& line : lines) {
        Node& one = list.add(Node::map());
        one.set("label", Node::string(line.label));
        one.set("kind", Node::string(line.kind));
        one.set("calls", Node::integer(line.calls));
        one.set("seconds", Node::number(line.seconds));
        const auto& cost = line.nanoseconds_per_particle;
        one.set("ns_per_particle", cost ? Node::number(*cost) : Node{});
        one.set("share", Node::number(line.share));
        if (line.iterations > 0) one.set("iterations", Node::integer(line.iterations));
        one.set("lines", linesNode(line.lines));
    }
    return list;
}

}  // namespace

std::string profileJson(const Profile& profile) {
    Node steps = Node::map();
    for (const auto& [layer, n] : profile.steps) steps.set(layer, Node::integer(n));
    Node whole = Node::map();
    whole.set("time", Node::number(profile.time));
    whole.set("finished", Node::plain(profile.finished ? "true" : "false"));
    whole.set("loop_seconds", Node::number(profile.loop_seconds));
    whole.set("start_seconds", Node::number(profile.start_seconds));
    whole.set("output_seconds", Node::number(profile.output_seconds));
    whole.set("writing_seconds", Node::number(profile.writing_seconds));
    whole.set("steps", std::move(steps));
    whole.set("lines", linesNode(profile.lines));
    whole.set("start", linesNode(profile.start));
    whole.set("outputs", linesNode(profile.outputs));
    whole.set("writing", linesNode(profile.writing));
    return input::writeJson(whole);
}

void writeProfile(const Profile& profile, const std::filesystem::path& path) {
    std::ofstream file(path);
    file << profileJson(profile) << std::flush;
    if (!file)
        throw FileError(fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
}

}  // namespace sphinx::loop
