// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/read.h"
#include "case/language/register.h"
#include "case/run/check.h"
#include "case/run/provenance.h"
#include "case/run/run.h"
#include "case/run/show.h"
#include "core/errors.h"
#include "core/parallel.h"
#include "input/declaration/describe.h"
#include "input/declaration/schema.h"
#include "input/expressions/decimal.h"
#include "input/tree/suggest.h"

#include <fcntl.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

namespace {

using namespace sphinx;

/// What was asked for, all of it or a FileError: a full disk must not look like a short answer.
void print(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw FileError(std::string("cannot write the answer: ") + std::strerror(errno));
}

/// Where no memory is left as well.
void printError(std::string_view text) {
    std::fprintf(stderr, "%.*s\n", static_cast<int>(text.size()), text.data());
}

/// What the command line says; each verb uses its part.
struct CommandLine {
    std::string case_file;
    std::vector<std::string> overrides;
    std::string name;
    bool markdown = false;
    run::RunOptions run;
    std::string time_limit;
};

void show(const CommandLine& line, const input::Registry& registry) {
    const model::Case model = language::readCase(line.case_file, line.overrides, registry);
    std::fputs(model.warnings.c_str(), stderr);
    print(run::showCase(model));
}

void check(const CommandLine& line, const input::Registry& registry) {
    setThreadCount(line.run.threads);
    const run::CheckReport report =
        run::checkCase(language::readCase(line.case_file, line.overrides, registry));
    std::fputs(report.warnings.c_str(), stderr);
    print(report.text);
}

/// Seconds of [DAYS-]HOURS:MINUTES:SECONDS, as batch systems write a limit.
std::optional<double> readClockTime(std::string_view text) {
    double days = 0;
    if (const auto dash = text.find('-'); dash != text.npos) {
        const auto read = input::parseDecimal<int>(text.substr(0, dash));
        if (!read || *read < 0) return {};
        days = *read;
        text.remove_prefix(dash + 1);
    }
    double seconds = 0;
    for (int part = 0; part < 3; ++part) {
        const std::size_t end = part < 2 ? text.find(':') : text.size();
        if (end == text.npos) return {};
        const auto read = input::parseDecimal<int>(text.substr(0, end));
        if (!read || *read < 0 || (part > 0 && *read > 59)) return {};
        seconds = 60 * seconds + *read;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return 86400 * days + seconds;
}

/// "3h", "90 min", "45s", "01:30:00" or plain seconds; throws CaseError.
double readDuration(const std::string& text) {
    double seconds = -1;
    if (const auto clock = readClockTime(text)) {
        seconds = *clock;
    } else {
        const std::size_t end = std::min(text.find_first_not_of("0123456789.+-eE"), text.size());
        const std::size_t unit_begin = std::min(text.find_first_not_of(' ', end), text.size());
        const std::string unit = text.substr(unit_begin);
        const double factor = unit.empty() || unit == "s" ? 1
                              : unit == "min"             ? 60
                              : unit == "h"               ? 3600
                              : unit == "d"               ? 86400
                                                          : 0;
        seconds = factor * input::parseDecimal<double>(text.substr(0, end)).value_or(-1);
    }
    if (!(seconds > 0))
        throw CaseError("error: --time-limit is '" + text +
                        "' but must be a time like 3h, 90min, 45s, 2d or 01:30:00");
    return seconds;
}

int runVerb(CommandLine& line, const input::Registry& registry) {
    if (!line.time_limit.empty()) line.run.time_limit = readDuration(line.time_limit);
    return run::runCase(language::readCase(line.case_file, line.overrides, registry), line.run);
}

void addCase(CLI::App& verb, CommandLine& line) {
    verb.add_option("case", line.case_file, "the case, a YAML file")
        ->required()
        ->check(CLI::ExistingFile);
    verb.add_option("--set", line.overrides, "override a value: path=YAML, such as loop.end_time=1")
        ->take_all()
        ->expected(1)
        ->type_name("PATH=VALUE");
}

void addThreads(CLI::App& verb, CommandLine& line) {
    verb.add_option("--threads,-j", line.run.threads, "threads, else all of the machine")
        ->check(CLI::Range(1, 4096));
}

/// The parser alone would ask for a verb without a word on the one that was written.
void requireVerb(const CLI::App& app, const std::string& word) {
    std::vector<std::string> verbs;
    for (const CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
    if (!word.starts_with('-') && std::find(verbs.begin(), verbs.end(), word) == verbs.end())
        throw CaseError("error: there is no verb '" + word + "'" + input::didYouMean(word, verbs));
}

/// A program that is started without standard files would give their numbers to its results, and
/// write its messages there.
void keepStandardFiles() {
    for (int number = 0; number <= 2; ++number)
        if (::fcntl(number, F_GETFD) < 0 && errno == EBADF) [[maybe_unused]]
            const int opened = ::open("/dev/null", number == 0 ? O_RDONLY : O_WRONLY);
}

int runProgram(int argc, char** argv) {
    input::Registry registry;
    language::registerAll(registry);
    CommandLine line;
    CLI::App app("sphinx: smoothed particle hydrodynamics from a YAML case");
    app.require_subcommand(1);
    app.set_version_flag("--version",
                         "sphinx " + run::programVersion() + " (" + run::programCommit() + ")");
    int code = exit_done;

    auto* run_verb = app.add_subcommand("run", "run a case");
    addCase(*run_verb, line);
    const auto notEmpty = [](const std::string& text) {
        return std::string(text.empty() ? "an empty text is none" : "");
    };
    run_verb->add_option("--output,-o", line.run.output, "results folder, else output/NAME")
        ->check(notEmpty);
    addThreads(*run_verb, line);
    auto* resume = run_verb->add_flag("--resume", line.run.resume,
                                      "go on from the newest restart in the results folder");
    auto* restart =
        run_verb
            ->add_option("--restart", line.run.restart, "start from the state in this restart file")
            ->check(notEmpty);
    auto* overwrite = run_verb->add_flag("--overwrite", line.run.overwrite,
                                         "remove the results that the folder holds");
    resume->excludes(restart)->excludes(overwrite);
    run_verb
        ->add_option("--time-limit", line.time_limit,
                     "write a restart and end after this wall time, such as 3h")
        ->check(notEmpty);
    run_verb->add_flag_callback(
        "--no-outputs", [&] { line.run.outputs = false; }, "write no files, for timing");
    run_verb->callback([&] { code = runVerb(line, registry); });

    auto* check_verb = app.add_subcommand("check", "everything but stepping");
    addCase(*check_verb, line);
    addThreads(*check_verb, line);
    check_verb->callback([&] { check(line, registry); });

    auto* show_verb =
        app.add_subcommand("show", "print the resolved case with the origin of values");
    addCase(*show_verb, line);
    show_verb->callback([&] { show(line, registry); });

    auto* list_verb = app.add_subcommand("list", "print the names that a case can use");
    list_verb->add_option("kind", line.name,
                          "block, shape, kernel, material, dynamics, output or field");
    list_verb->callback([&] { print(input::listText(registry, line.name)); });

    auto* describe_verb = app.add_subcommand("describe", "explain a name or a block of a case");
    describe_verb->add_option("name", line.name, "such as fluid.pressure_relaxation or loop")
        ->required();
    describe_verb->callback([&] { print(input::describeText(registry, line.name)); });

    auto* schema_verb = app.add_subcommand("schema", "print the JSON Schema of a case for editors");
    schema_verb->add_flag("--markdown", line.markdown, "the reference page instead");
    schema_verb->callback([&] {
        print(line.markdown
                  ? input::referencePage(registry)
                  : input::jsonSchema(registry, *registry.find(input::Kind::block, "case")));
    });

    if (argc > 1) requireVerb(app, argv[1]);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        std::ostringstream answer, complaint;
        const bool asked_for = app.exit(e, answer, complaint) == 0;  // --help, --version
        std::fputs(complaint.str().c_str(), stderr);
        print(answer.str());
        return asked_for ? exit_done : exit_case_wrong;
    }
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    keepStandardFiles();
    try {
        return runProgram(argc, argv);
    } catch (const sphinx::CaseError& e) {
        printError(e.what());
        return sphinx::exit_case_wrong;
    } catch (const sphinx::PhysicsError& e) {
        printError(std::string("error: ") + e.what());
        return sphinx::exit_physics_failed;
    } catch (const sphinx::FileError& e) {
        printError(std::string("error: ") + e.what());
        return sphinx::exit_files_failed;
    } catch (const std::filesystem::filesystem_error& e) {
        printError(std::string("error: ") + e.what());
        return sphinx::exit_files_failed;
    } catch (const std::bad_alloc&) {
        printError("error: the case needs more memory than there is");
        return sphinx::exit_case_wrong;
    } catch (const std::system_error& e) {
        printError(std::string("error: the system refuses what the program needs: ") + e.what());
        return sphinx::exit_files_failed;
    } catch (const std::exception& e) {
        printError(std::string("error: this is a fault of the program, please report it: ") +
                   e.what());
        return sphinx::exit_program_faulty;
    }
}
