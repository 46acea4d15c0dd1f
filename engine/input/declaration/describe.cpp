// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/declaration/describe.h"

#include "core/errors.h"
#include "input/tree/suggest.h"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>

namespace sphinx::input {
namespace {

std::string defaultText(const Node& node) {
    if (node.isScalar()) return node.text.empty() ? "''" : node.text;
    std::string text;
    if (node.isList()) {
        for (const Node& item : node.items) text += (text.empty() ? "" : ", ") + defaultText(item);
        return "[" + text + "]";
    }
    for (const Node::Entry& entry : node.entries)
        text += (text.empty() ? "" : ", ") + entry.key + ": " + defaultText(entry.value);
    return "{" + text + "}";
}

std::string defaultText(const Declaration& declaration, const Parameter& p) {
    if (p.required) return "required";
    const std::shared_ptr<void> defaults = declaration.makeParameters();
    const void* value = p.in(defaults.get());
    return p.type->absent(value) ? "optional"
                                 : "default " + defaultText(p.type->write(value, nullptr));
}

/// "body: velocity, mass; neighbors.solid: normal" for one mode; empty when there is none.
std::string accessText(const Action& action, AccessMode mode) {
    std::string text;
    std::string owner;
    for (const Access& access : action.accesses()) {
        if (access.mode != mode) continue;
        if (access.owner == owner) {
            text += ", " + access.field;
        } else {
            text += (text.empty() ? "" : "; ") + access.owner + ": " + access.field;
            owner = access.owner;
        }
    }
    return text;
}

constexpr std::pair<AccessMode, const char*> modes[] = {{AccessMode::read, "reads"},
                                                        {AccessMode::write, "writes"},
                                                        {AccessMode::accumulate, "accumulates"},
                                                        {AccessMode::release, "releases"},
                                                        {AccessMode::open, "begins"},
                                                        {AccessMode::close, "ends"},
                                                        {AccessMode::within, "within"}};

/// The text in lines of at most 100 columns, all but the first indented.
std::string wrapped(const std::string& text, std::size_t indent) {
    constexpr std::size_t width = 100;
    std::string out;
    std::size_t column = indent;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        if (column > indent && column + 1 + end - begin > width) {
            out += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (begin > 0) {
            out += ' ';
            ++column;
        }
        out += text.substr(begin, end - begin);
        column += end - begin;
        begin = end + 1;
    }
    return out;
}

std::string describeOne(const Declaration& d) {
    std::string out = d.name() + " (" + kindName(d.kind()) + ")\n";
    const auto add = [&](const char* title, const std::string& text) {
        if (!text.empty()) out += fmt::format("  {:<10}{}\n", title, wrapped(text, 12));
    };
    out += "  " + d.summary() + "\n";
    add("formula", d.formula());
    for (const Citation& citation : d.citations())
        add("source", citation.text() + ": " + fullCitation(*citation.publication));
    add("traits", joined(d.traits()));
    if (!d.parameters().empty()) out += "\nparameters\n";
    std::size_t width = 0;
    for (const Parameter& p : d.parameters()) width = std::max(width, p.name.size());
    for (const Parameter& p : d.parameters()) {
        out += fmt::format("  {:<{}}  {}\n", p.name.empty() ? "(value)" : p.name, width, p.doc);
        out += fmt::format("  {:<{}}    {}\n", "", width,
                           wrapped(defaultText(d, p) + "; " + p.type->text(), width + 6));
    }
    if (!d.actions().empty()) out += d.isTimeStep() ? "\ntime-step estimate\n" : "\nactions\n";
    for (const Action& action : d.actions()) {
        out += "  " + action.name() + (action.name().empty() || action.doc().empty() ? "" : ": ") +
               action.doc() + "\n";
        for (const auto& [mode, word] : modes)
            if (const std::string text = accessText(action, mode); !text.empty())
                out += fmt::format("    {:<12}{}\n", word, wrapped(text, 16));
        if (!action.throughout().empty())
            out += fmt::format("    {:<12}{}\n", "throughout", wrapped(action.throughout(), 16));
    }
    return out;
}

/// Calls use(declaration, parameter) for every key of every declaration.
template <class Use>
void forEachKey(const Registry& registry, Use use) {
    for (const Kind kind : all_kinds)
        for (const std::string& name : registry.names(kind)) {
            const Declaration& declaration = *registry.find(kind, name);
            for (const Parameter& p : declaration.parameters())
                if (!p.name.empty()) use(declaration, p);
        }
}

/// Where a key of that name, or OWNER.KEY, may stand; keys that mean the same together. Empty if
/// there is none.
std::string describeKey(const Registry& registry, const std::string& name) {
    std::vector<std::pair<std::string, std::string>> meanings;  // text, owners
    forEachKey(registry, [&](const Declaration& d, const Parameter& p) {
        if (p.name != name && d.name() + "." + p.name != name) return;
        const std::string text = fmt::format("  {}\n  {}\n", wrapped(p.doc, 2),
                                             wrapped(defaultText(d, p) + "; " + p.type->text(), 2));
        const auto same =
            std::ranges::find(meanings, text, &std::pair<std::string, std::string>::first);
        if (same == meanings.end())
            meanings.emplace_back(text, d.name());
        else
            same->second += ", " + d.name();
    });
    std::string out;
    for (const auto& [text, owners] : meanings)
        out += (out.empty() ? "" : "\n") +
               wrapped(fmt::format("{} (key of {})", name.substr(name.rfind('.') + 1), owners), 4) +
               "\n" + text;
    return out;
}

bool hasWord(const std::string& text, const std::string& word) {
    const auto ends = [&](std::size_t k) {
        return k >= text.size() ||
               !(std::isalnum(static_cast<unsigned char>(text[k])) != 0 || text[k] == '_');
    };
    for (std::size_t k = 0; (k = text.find(word, k)) != std::string::npos; ++k)
        if ((k == 0 || ends(k - 1)) && ends(k + word.size())) return true;
    return false;
}

/// What speaks of a word that is no name; empty if nothing does.
std::string mentions(const Registry& registry, const std::string& word) {
    std::string out;
    for (const Kind kind : all_kinds)
        for (const std::string& name : registry.names(kind))
            if (const std::string& summary = registry.find(kind, name)->summary();
                hasWord(summary, word))
                out += fmt::format("  {}: {}\n", name, wrapped(summary, 4));
    forEachKey(registry, [&](const Declaration& d, const Parameter& p) {
        if (hasWord(p.doc, word) || hasWord(p.type->text(), word))
            out += fmt::format("  {}.{}: {}\n", d.name(), p.name,
                               wrapped(p.doc + "; " + p.type->text(), 4));
    });
    return out.empty() ? "" : fmt::format("nothing is called '{}'; of it speak\n", word) + out;
}

std::string escaped(std::string text) {
    for (std::size_t k = 0; (k = text.find_first_of("|*<", k)) != std::string::npos; k += 2)
        text.insert(k, "\\");
    return text;
}

std::string markdownOne(const Declaration& d) {
    std::string out = "### `" + d.name() + "`\n\n" + escaped(d.summary()) + ".\n\n";
    if (!d.formula().empty()) out += "Formula: `" + d.formula() + "`\n\n";
    std::string sources;
    for (const Citation& citation : d.citations())
        sources += (sources.empty() ? "Source: " : "; ") + citation.text();
    if (!sources.empty()) out += sources + "\n\n";
    if (!d.traits().empty()) out += "Traits: " + joined(d.traits()) + "\n\n";
    if (!d.parameters().empty()) out += "| key | | value | meaning |\n|---|---|---|---|\n";
    for (const Parameter& p : d.parameters())
        out +=
            fmt::format("| {} | {} | {} | {} |\n", p.name.empty() ? "(value)" : "`" + p.name + "`",
                        escaped(defaultText(d, p)), escaped(p.type->text()), escaped(p.doc));
    if (!d.parameters().empty()) out += "\n";
    for (const Action& action : d.actions()) {
        out += "- " + (d.isTimeStep()          ? "estimate"
                       : action.name().empty() ? "action"
                                               : "`" + action.name() + "`");
        if (!action.doc().empty()) out += ": " + escaped(action.doc());
        for (const auto& [mode, word] : modes)
            if (const std::string text = accessText(action, mode); !text.empty())
                out += fmt::format("; {} {}", word, text);
        if (!action.throughout().empty()) out += "; throughout: " + escaped(action.throughout());
        out += "\n";
    }
    return out + (d.actions().empty() ? "" : "\n");
}

const char* kindTitle(Kind kind) {
    switch (kind) {
        case Kind::block: return "Blocks";
        case Kind::shape: return "Shapes";
        case Kind::kernel: return "Smoothing kernels";
        case Kind::material: return "Materials";
        case Kind::dynamics: return "Dynamics";
        case Kind::joint: return "Joints";
        case Kind::multibody_force: return "Forces of multibody";
        case Kind::multibody_constraint: return "Constraints of multibody";
        case Kind::output: return "Outputs";
        case Kind::field: return "Fields";
    }
    return "";
}

}  // namespace

std::string listText(const Registry& registry, const std::string& kind) {
    std::vector<std::string> kinds;
    for (const Kind one : all_kinds) kinds.emplace_back(kindName(one));
    if (!kind.empty() && std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
        throw CaseError("error: there is no kind '" + kind + "'" + didYouMean(kind, kinds));
    std::string out;
    for (const Kind one : all_kinds) {
        if (!kind.empty() && kind != kindName(one)) continue;
        std::size_t width = 0;
        for (const std::string& name : registry.names(one)) width = std::max(width, name.size());
        if (kind.empty()) out += (out.empty() ? "" : "\n") + std::string(kindName(one)) + "\n";
        for (const std::string& name : registry.names(one))
            out += fmt::format("{}{:<{}}  {}\n", kind.empty() ? "  " : "", name, width,
                               registry.find(one, name)->summary());
    }
    return out;
}

std::string describeText(const Registry& registry, const std::string& name) {
    std::string out;
    std::vector<std::string> known;
    for (const Kind kind : all_kinds) {
        if (const Declaration* found = registry.find(kind, name))
            out += (out.empty() ? "" : "\n") + describeOne(*found);
        for (std::string& other : registry.names(kind)) known.push_back(std::move(other));
    }
    if (out.empty()) out = describeKey(registry, name);
    if (out.empty()) out = mentions(registry, name);
    if (out.empty()) {
        forEachKey(registry,
                   [&](const Declaration&, const Parameter& p) { known.push_back(p.name); });
        const auto near = nearest(name, known);
        throw CaseError(fmt::format(
            "error: there is nothing called '{}'; {}", name,
            near ? fmt::format("did you mean '{}'?", *near) : "'sphinx list' prints the names"));
    }
    return out;
}

std::string referencePage(const Registry& registry) {
    std::string out =
        "# Reference of the case language\n\n"
        "Generated by `sphinx schema --markdown` from the declarations in the program.\n\n";
    for (const Kind kind : all_kinds) {
        if (registry.names(kind).empty()) continue;
        out += std::string("## ") + kindTitle(kind) + "\n\n";
        for (const std::string& name : registry.names(kind))
            out += markdownOne(*registry.find(kind, name));
    }
    out += "## Sources\n\n";
    for (const Publication& one : publications())
        out += "- " + std::string(one.key) + ": " + fullCitation(one) + "\n";
    return out;
}

}  // namespace sphinx::input
