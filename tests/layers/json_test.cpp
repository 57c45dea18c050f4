// SPDX-License-Identifier: Apache-2.0
// What computes knows no JSON: it is read and written in io/, in files called *_spec or *_json, and
// by the checker of proofs, whose input is documents. Oracle: the files.
#include <gtest/gtest.h>

#include "tests/gates/source_tree.hpp"

namespace torquewright::layers {
namespace {

namespace fs = std::filesystem;

bool may_know_json(const fs::path& file) {
  const std::string name = file.generic_string();
  const std::string stem = file.stem().string();
  return name.starts_with("io/") || name.starts_with("gearbox/proof/") || stem.ends_with("_spec") ||
         stem.ends_with("_json");
}

/// Names its types. Passing on what a *_json function answered, to another one, needs no name.
bool knows_json(const fs::path& file) {
  const std::string text = gates::text_of(file);
  return text.find("nlohmann") != std::string::npos ||
         text.find("ordered_json") != std::string::npos;
}

TEST(Json, IsKnownOnlyToThoseThatReadAndWriteIt) {
  gates::Names broken;
  for (const char* folder : {"optimization", "gearbox", "actuator", "dynamics", "simulation",
                             "identification", "hopper", "src"}) {
    for (const char* extension : {".cpp", ".hpp"}) {
      for (const fs::path& file : gates::files_in(folder, extension)) {
        if (knows_json(file) && !may_know_json(file)) broken.insert(file.generic_string());
      }
    }
  }
  EXPECT_EQ(broken, gates::Names{}) << "only io/, the checker of proofs and files called *_spec or "
                                       "*_json know nlohmann/json";
}

}  // namespace
}  // namespace torquewright::layers
