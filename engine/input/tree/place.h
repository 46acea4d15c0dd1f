// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace sphinx::input {

/// A text that is read: a case file, an included file, or the values of `--set` (one a line).
struct Source {
    std::string name;    ///< as it appears in messages
    std::string folder;  ///< where relative paths in it start
    std::string text;
    int order = 0;  ///< messages are sorted by this, then by line and column

    /// The line of that number (from 1) without its end; empty when there is none.
    std::string_view line(int number) const;
};

/// Where something was written. Without a source it was not written: a default.
struct Place {
    std::shared_ptr<const Source> source;
    int line = 0;    ///< from 1
    int column = 0;  ///< from 1, in bytes

    explicit operator bool() const { return source != nullptr; }
    /// "case.yaml:31", "--set" or "default".
    std::string origin() const;
};

/// Order of messages: by source, line, column; defaults first.
bool operator<(const Place& a, const Place& b);

}  // namespace sphinx::input
