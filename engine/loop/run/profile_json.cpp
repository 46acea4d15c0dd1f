// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/errors.h"
#include "loop/run/profile.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace sphinx::loop {
namespace {

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            out += {'\\', c};
        else if (static_cast<unsigned char>(c) < 0x20)
            out += fmt::format("\\u{:04x}", static_cast<int>(c));
        else
            out += c;
    }
    return out + '"';
}

std::string linesJson(const std::vector<ProfileLine>& lines, const std::string& indent) {
    if (lines.empty()) return "[]";
    std::string out = "[";
    const std::string inner = indent + "  ";
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const ProfileLine& line = lines[k];
        const auto& cost = line.nanoseconds_per_particle;
        out += fmt::format(
            "{}\n{}{{\"label\": {}, \"kind\": {}, \"calls\": {}, \"seconds\": {:.9f}, "
            "\"ns_per_particle\": {}, \"share\": {:.6f}, \"lines\": {}}}",
            k == 0 ? "" : ",", inner, quoted(line.label), quoted(line.kind), line.calls,
            line.seconds, cost ? fmt::format("{:.4f}", *cost) : "null", line.share,
            linesJson(line.lines, inner));
    }
    return out + "\n" + indent + "]";
}

}  // namespace

std::string profileJson(const Profile& profile) {
    std::string steps;
    for (const auto& [layer, n] : profile.steps)
        steps += fmt::format("{}{}: {}", steps.empty() ? "" : ", ", quoted(layer), n);
    return fmt::format(
        "{{\n  \"time\": {},\n  \"finished\": {},\n  \"loop_seconds\": {:.9f},\n  "
        "\"start_seconds\": {:.9f},\n"
        "  \"output_seconds\": {:.9f},\n  \"steps\": {{{}}},\n  \"lines\": {},\n"
        "  \"start\": {},\n  \"outputs\": {}\n}}\n",
        profile.time, profile.finished, profile.loop_seconds, profile.start_seconds,
        profile.output_seconds, steps, linesJson(profile.lines, "  "),
        linesJson(profile.start, "  "), linesJson(profile.outputs, "  "));
}

void writeProfile(const Profile& profile, const std::filesystem::path& path) {
    std::ofstream file(path);
    file << profileJson(profile) << std::flush;
    if (!file)
        throw FileError(fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
}

}  // namespace sphinx::loop
