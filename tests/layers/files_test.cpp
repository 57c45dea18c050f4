// SPDX-License-Identifier: Apache-2.0
// Files are opened, replaced and removed by io/ alone (docs/decisions/0016). Oracle: the sources.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/gates/excuses.hpp"
#include "tests/gates/source_tree.hpp"

namespace torquewright::layers {
namespace {

namespace fs = std::filesystem;

constexpr std::array kWays = {"fstream>",   "fopen(",     "::open(",    "::creat(",  "mkstemp(",
                              " ::rename(", "(::rename(", "fs::rename", "unlink(",   "fs::remove",
                              "freopen(",   "fs::copy",   "openat(",    "truncate(", "mkdir("};

/// They may only become fewer.
const std::vector<gates::Excuse> kLeftAlone = {
    {"identification/log/spill_file.cpp", "holds a log in a file that has no name"},
};

bool touches_files(const fs::path& file) {
  const std::string text = gates::text_of(file);
  return std::any_of(kWays.begin(), kWays.end(),
                     [&](const char* way) { return text.find(way) != std::string::npos; });
}

TEST(Files, AreTouchedByIoAlone) {
  gates::Names broken;
  for (const char* folder : {"optimization", "gearbox", "actuator", "dynamics", "simulation",
                             "identification", "hopper", "src"}) {
    for (const char* extension : {".cpp", ".hpp"}) {
      for (const fs::path& file : gates::files_in(folder, extension)) {
        if (touches_files(file)) broken.insert(file.generic_string());
      }
    }
  }
  gates::expect_excused(broken, kLeftAlone, "only io/ opens, replaces and removes files");
}

// The number of a process comes again, always 1 in a container: a name from it may be taken.
TEST(Files, HaveNoNamesFromTheNumberOfAProcess) {
  for (const fs::path& file : gates::files_in("io", ".cpp")) {
    EXPECT_EQ(gates::text_of(file).find("getpid("), std::string::npos) << file;
  }
}

// What has no name is called as its file is, which need not be text: io::stem_in_text.
TEST(Files, GiveNamesThroughIoAlone) {
  gates::Names broken;
  for (const char* folder :
       {"gearbox", "actuator", "simulation", "identification", "hopper", "src"}) {
    for (const fs::path& file : gates::files_in(folder, ".cpp")) {
      if (gates::text_of(file).find("stem()") != std::string::npos) {
        broken.insert(file.generic_string());
      }
    }
  }
  gates::expect_excused(broken, {}, "a file's name goes into text by io/text/one_line.hpp");
}

}  // namespace
}  // namespace torquewright::layers
