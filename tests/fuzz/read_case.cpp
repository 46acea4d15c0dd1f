// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// Any bytes as a case: either errors are reported, or the case is good, and then its resolved form
// is the same case.

#include "case/language/read.h"
#include "case/language/register.h"
#include "case/run/physics_text.h"
#include "case/run/show.h"
#include "core/errors.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

using namespace sphinx;

namespace {

const input::Registry& registry() {
    static const input::Registry* const all = [] {
        auto* made = new input::Registry;
        language::registerAll(*made);
        return made;
    }();
    return *all;
}

[[noreturn]] void fail(const char* what, const std::string& before, const std::string& after) {
    std::fprintf(stderr, "%s\n--- before\n%s\n--- after\n%s\n", what, before.c_str(),
                 after.c_str());
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    std::string shown, physics;
    try {
        const model::Case model = language::readCaseText("case.yaml", text, registry());
        shown = run::showCase(model);
        physics = run::physicsText(model);
    } catch (const CaseError& e) {
        if (std::string(e.what()).find("error: ") == std::string::npos)
            fail("an error without a message", text, e.what());
        return 0;
    } catch (const FileError&) {
        return 0;
    }
    try {
        const model::Case again = language::readCaseText("resolved.yaml", shown, registry());
        if (run::physicsText(again) != physics)
            fail("the resolved case is another one", physics, run::physicsText(again));
    } catch (const CaseError& e) {
        fail("the resolved case is wrong", shown, e.what());
    }
    return 0;
}
