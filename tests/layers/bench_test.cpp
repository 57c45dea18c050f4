// SPDX-License-Identifier: Apache-2.0
// Measurements stand alone: what needs a test's oracle or robot stands beside it. Oracle: the
// sources.
#include <gtest/gtest.h>

#include "tests/gates/excuses.hpp"
#include "tests/gates/source_tree.hpp"

namespace torquewright::layers {
namespace {

namespace fs = std::filesystem;

/// They may only become fewer.
const std::vector<gates::Excuse> kComparedWithOtherSolvers = {
    {"bench/gearbox_side_by_side.cpp", "puts named problems to Bonmin and MiniZinc"},
    {"bench/run_ours.cpp", "writes those problems as documents"},
    {"bench/verdict.hpp", "holds every solver's answer against the enumeration"},
};

TEST(Bench, IncludesNoTests) {
  gates::Names broken;
  for (const char* extension : {".cpp", ".hpp"}) {
    for (const fs::path& file : gates::files_in("bench", extension)) {
      if (gates::text_of(file).find("#include \"tests/") != std::string::npos) {
        broken.insert(file.generic_string());
      }
    }
  }
  gates::expect_excused(broken, kComparedWithOtherSolvers, "bench/ includes no tests");
}

}  // namespace
}  // namespace torquewright::layers
