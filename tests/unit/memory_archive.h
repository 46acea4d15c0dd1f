// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/archive.h"
#include "core/errors.h"

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace sphinx::test {

/// Values by their path.
using Saved = std::map<std::string, ArchiveValue>;

/// Keeps what is saved, and gives it back once `is_loading` is set.
class MemoryArchive final : public Archive {
 public:
    MemoryArchive() = default;
    explicit MemoryArchive(Saved s) : saved(std::move(s)), is_loading(true) {}

    bool loading() const override { return is_loading; }
    bool has(std::string_view name) const override {
        return !is_loading || saved.contains(path(name)) || hasSection(name);
    }
    void enter(std::string_view name) override {
        if (is_loading && !hasSection(name)) throw FileError("no section " + path(name));
        path_.push_back(std::string(name) + "/");
    }
    void leave() override { path_.pop_back(); }

    Saved saved;
    bool is_loading = false;

 private:
    std::string path(std::string_view name) const {
        std::string whole;
        for (const std::string& part : path_) whole += part;
        return whole + std::string(name);
    }
    bool hasSection(std::string_view name) const {
        const std::string key = path(name) + "/";
        const auto first = saved.lower_bound(key);
        return first != saved.end() && first->first.starts_with(key);
    }
    void transfer(std::string_view name, ArchiveValue& v) override {
        const std::string key = path(name);
        if (is_loading) {
            const auto found = saved.find(key);
            if (found == saved.end()) throw FileError("no value " + key);
            if (found->second.index() != v.index()) throw std::bad_variant_access();
            v = found->second;
        } else if (!saved.emplace(key, v).second) {
            throw FileError("written twice: " + key);
        }
    }

    std::vector<std::string> path_;
};

}  // namespace sphinx::test
