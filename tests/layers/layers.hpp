// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::layers {

struct Include {
  std::string name;
  bool is_quoted = true;  ///< "name" and not <name>.
};

/// What the #include directives of a text name.
std::vector<Include> includes_in(std::string_view text);

/// A source of the library or the program, by its path from the repository's root.
struct SourceFile {
  std::string name;
  std::vector<Include> includes;
};
std::vector<SourceFile> library_sources(const std::filesystem::path& root);

/// The folders of the library and the program, and which others the files of each may include.
std::map<std::string, std::set<std::string>> folders_below();

/// The same of the rooms of a folder, by their names inside it.
std::map<std::string, std::set<std::string>> rooms_below(const std::string& folder);

/// The room that a file lies in, with its folder: "hopper/planning/region"; the folder alone where
/// it lies beside the rooms.
std::string room_named(std::string_view file);

/// Why the file (named from the repository's root) may not include that; empty if it may. Headers
/// that are not ours are free, but for the solvers and the parser of command lines, each at home in
/// one place.
std::string objection(std::string_view file, const Include& include);

/// One sentence for every objectionable include of every source under the root. Tests and
/// benchmarks may include anything.
std::vector<std::string> find_objections(const std::filesystem::path& root);

}  // namespace torquewright::layers
