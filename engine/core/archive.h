// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/errors.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace sphinx {

using ArchiveValue = std::variant<double, std::int64_t, bool, std::string, std::vector<double>,
                                  std::vector<std::int64_t>>;

/// One interface for saving and for loading: a stateful class has a single transfer(Archive&), so
/// that what is written is what is read. Values are exact (bitwise) in both directions.
/// Small state only (clocks, triggers, counters, points of an observer); particle fields are
/// written by io as arrays.
class Archive {
 public:
    virtual ~Archive() = default;

    virtual bool loading() const = 0;
    /// Of a type of ArchiveValue.
    template <class T>
    void value(std::string_view name, T& v) {
        ArchiveValue held = v;
        transfer(name, held);
        v = std::get<T>(std::move(held));
    }

    /// Whether the present section has a value or a section of that name; ever so when saving.
    virtual bool has(std::string_view name) const = 0;

    /// Opens a named section; names of siblings differ. Throws FileError when loading and it is
    /// missing.
    virtual void enter(std::string_view name) = 0;
    /// Does not throw: the end of a section is that of a scope.
    virtual void leave() = 0;

    /// A value that is no number of things when it is negative: then a FileError when loading.
    void count(std::string_view name, std::int64_t& v) {
        value(name, v);
        if (loading() && v < 0)
            throw FileError("the saved state has " + std::to_string(v) + " " + std::string(name) +
                            ", which nothing can have");
    }

 protected:
    /// When saving it leaves the value as it is. When loading it gives one of the same type; throws
    /// FileError when there is none.
    virtual void transfer(std::string_view name, ArchiveValue& v) = 0;
};

/// Keeps enter and leave paired.
class Section {
 public:
    Section(Archive& archive, std::string_view name) : archive_(archive) { archive_.enter(name); }
    ~Section() { archive_.leave(); }
    Section(const Section&) = delete;
    Section& operator=(const Section&) = delete;

 private:
    Archive& archive_;
};

}  // namespace sphinx
