// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/run/provenance.h"

#include "sphinx_build.h"

#include <chrono>
#include <ctime>
#include <fstream>

namespace sphinx::run {
namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0) {
            const auto colon = line.find(": ");
            if (colon != std::string::npos) return line.substr(colon + 2);
        }
    return "unknown";
}

std::string now() {
    const std::time_t t = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm utc{};
    gmtime_r(&t, &utc);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text;
}

}  // namespace

std::string programVersion() { return SPHINX_VERSION; }
std::string programCommit() { return SPHINX_COMMIT; }

std::string instructionSet() {
#if defined(__AVX512F__)
    return "x86-64 avx512";
#elif defined(__AVX2__)
    return "x86-64 avx2";
#elif defined(__SSE2__)
    return "x86-64 sse2";
#elif defined(__aarch64__)
    return "aarch64";
#else
    return "generic";
#endif
}

io::Provenance makeProvenance(int threads) {
    return {{
        {"program", "sphinx"},
        {"version", SPHINX_VERSION},
        {"commit", SPHINX_COMMIT},
        {"compiler", SPHINX_COMPILER},
        {"flags", SPHINX_FLAGS},
        {"instruction_set", instructionSet()},
        {"processor", processor()},
        {"threads", std::to_string(threads)},
        {"date", now()},
    }};
}

}  // namespace sphinx::run
