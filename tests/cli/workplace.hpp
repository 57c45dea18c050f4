// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "tests/cli/process.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::cli_test {

namespace fs = std::filesystem;

/// The text of a file.
std::string text_of(const fs::path& file);

/// A file of the repository, such as "specs/gearbox/d151_knee.json".
fs::path in_repository(std::string_view file);

/// A file of its specs, as an argument: in_specs("gearbox/d151_knee.json").
std::string in_specs(std::string_view file);

/// `text` with the one place that reads `from` replaced; throws where there is none.
std::string with(std::string text, std::string_view from, std::string_view to);

/// A problem document: the D151's knee. And the same with one place changed.
std::string knee();
std::string knee_with(std::string_view from, std::string_view to);

/// The same asking for what no design has: infeasible.
std::string tight_knee();

/// A scratch folder that the program runs in.
class Workplace {
 public:
  Workplace() { here.folder = folder_.path(); }

  Outcome run(const std::vector<std::string>& arguments) const {
    return cli_test::run(arguments, here);
  }
  fs::path write(std::string_view name, std::string_view content) const {
    return folder_.write(name, content);
  }
  fs::path path(std::string_view name = "") const { return folder_.path() / name; }
  std::string text(std::string_view name) const { return text_of(path(name)); }
  bool has(std::string_view name) const { return fs::exists(path(name)); }

  /// Every file in it by name, with its text.
  std::map<std::string, std::string> files() const;

  Circumstances here;

 private:
  test::ScratchFolder folder_;
};

}  // namespace torquewright::cli_test
