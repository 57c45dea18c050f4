// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace torquewright::packages_test {

struct Said {
  int exit_code = -1;  ///< -1: ended by a signal.
  std::string text;    ///< stdout and stderr together.
};

/// What a line of sh comes to, run in that folder.
Said said_by(const std::string& line, const std::filesystem::path& folder = ".");

/// The text alone; throws std::runtime_error with it where the line fails.
std::string text_by(const std::string& line, const std::filesystem::path& folder = ".");

/// As one word of sh.
std::string sh_word(const std::filesystem::path& word);

/// Of the programs, the ones that are not installed, as a list; empty: all are.
std::string missing_programs(const std::vector<std::string>& programs);

std::vector<std::string> lines_of(const std::string& text);

/// The bytes of a file.
std::string text_of(const std::filesystem::path& file);

/// The files below a folder, named from there, ascending.
std::vector<std::string> files_below(const std::filesystem::path& folder);

/// The words that lead to every command of a program that prints its help as ours does:
/// "", "gearbox", "gearbox optimize".
std::vector<std::string> commands_of(const std::filesystem::path& program);

}  // namespace torquewright::packages_test
