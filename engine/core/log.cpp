// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/log.h"

#include "core/errors.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <set>
#include <string>

namespace sphinx::log {
namespace {

struct State {
    std::mutex mutex;
    std::FILE* file = nullptr;
    std::string status;
    std::set<std::string, std::less<>> warned;
};

State& state() {
    static State instance;
    return instance;
}

void write(std::FILE* stream, std::string_view prefix, std::string_view line) {
    if (!stream) return;
    std::fwrite(prefix.data(), 1, prefix.size(), stream);
    std::fwrite(line.data(), 1, line.size(), stream);
    std::fputc('\n', stream);
    std::fflush(stream);
}

void clearStatus(const State& s) {
    if (s.status.empty()) return;
    std::fputs("\r\033[K", stdout);
    std::fflush(stdout);
}

void drawStatus(const State& s) {
    std::fputs(s.status.c_str(), stdout);
    std::fflush(stdout);
}

/// A line on the terminal, above the status.
void print(const State& s, std::FILE* stream, std::string_view prefix, std::string_view line) {
    clearStatus(s);
    write(stream, prefix, line);
    drawStatus(s);
}

/// On the terminal and in the file; `once`: not again what was said so before.
void say(std::FILE* terminal, const char* prefix, std::string_view line, bool once = false) {
    State& s = state();
    std::lock_guard lock(s.mutex);
    if (once && !s.warned.emplace(line).second) return;
    print(s, terminal, prefix, line);
    write(s.file, prefix, line);
}

}  // namespace

void openFile(const std::filesystem::path& path) {
    State& s = state();
    std::lock_guard lock(s.mutex);
    if (s.file) std::fclose(s.file);
    s.file = std::fopen(path.c_str(), "ae");
    if (!s.file) throw FileError("cannot write " + path.string() + ": " + std::strerror(errno));
}

void closeFile() {
    State& s = state();
    std::lock_guard lock(s.mutex);
    if (s.file) std::fclose(s.file);
    s.file = nullptr;
}

void info(std::string_view line) { say(stdout, "", line); }
void warning(std::string_view line) { say(stderr, "warning: ", line, true); }
void message(std::string_view text) { say(stderr, "", text); }

void fileOnly(std::string_view line) {
    State& s = state();
    std::lock_guard lock(s.mutex);
    write(s.file, "", line);
}

void status(std::string_view line) {
    State& s = state();
    std::lock_guard lock(s.mutex);
    clearStatus(s);
    s.status = line;
    drawStatus(s);
}

}  // namespace sphinx::log
