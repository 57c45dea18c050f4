// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <compare>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/fuzz/program/case.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::fuzz {

namespace fs = std::filesystem;

/// Tells a file from what it was before, by when it was last written; the program sets no times.
struct Stamp {
  mode_t mode{};
  ino_t number{};
  off_t bytes{};
  std::int64_t written_ns{};

  auto operator<=>(const Stamp&) const = default;
};

/// Everything in the scene but folders, by its path in it.
using Look = std::map<std::string, Stamp>;

/// The folder in which the program runs: copies of the repository's examples under their names, and
/// what a case adds to them. It is one folder for all runs, mended after each.
class Scene {
 public:
  Scene();

  fs::path folder() const { return scratch_.path() / "work"; }
  fs::path temporary() const { return scratch_.path() / "tmp"; }
  fs::path path(const std::string& name) const { return folder() / name; }
  /// The examples' paths.
  const std::vector<std::string>& examples() const { return examples_; }

  /// As at the start, but for what the case says. Things whose paths lead elsewhere are left out.
  void lay_out(const Case& one);
  /// As at the start.
  void mend();

  Look look() const;

 private:
  void copy(const std::string& example);

  test::ScratchFolder scratch_;
  std::vector<std::string> examples_;
  Look untouched_;
};

/// Paths that are in one of them alone, or differ.
std::vector<std::string> changed(const Look& before, const Look& after);

}  // namespace torquewright::fuzz
