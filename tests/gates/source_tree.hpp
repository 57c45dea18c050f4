// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::gates {

using Names = std::set<std::string, std::less<>>;

/// The repository's root.
std::filesystem::path root();

/// Whole text of a file, named from the root.
std::string text_of(const std::filesystem::path& name);

/// Files of that extension in a folder and below it, named from the root, in alphabetical order.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                            std::string_view extension);

/// What the first group of the pattern matches, wherever it does. `^` is the begin of a line.
Names matches(const std::string& text, const std::string& pattern);

/// From the line that begins so to the next line that begins with "## "; empty if there is none.
std::string section(const std::string& page, const std::string& heading);

/// What stands in `backticks` in the first column of a page's tables. A name that begins with a dot
/// continues the one before it: `ring_tip.sun`, `.planet`.
Names named_in_first_column(const std::string& page);

}  // namespace torquewright::gates
