// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace sphinx {

/// What a run says: plain lines to the terminal and to log.txt. Thread-safe.
namespace log {

/// From now on every line also goes to this file (appended). Throws FileError.
void openFile(const std::filesystem::path& path);
void closeFile();

void info(std::string_view line);     ///< stdout and file
void warning(std::string_view line);  ///< "warning: ..." to stderr and file; equal lines only once
void message(std::string_view text);  ///< as it is, to stderr and file
void fileOnly(std::string_view line);

/// One line that stays below everything that is logged, rewritten in place (progress on a terminal;
/// the caller asks isatty). An empty one removes it.
void status(std::string_view line);

}  // namespace log
}  // namespace sphinx
