// SPDX-License-Identifier: Apache-2.0
// Kinds of documents: each has a schema that the program carries, a line in docs/README.md and an
// example in specs/. Oracle: the files of specs/.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/embedded_schemas.hpp"
#include "tests/gates/excuses.hpp"
#include "tests/gates/source_tree.hpp"

namespace torquewright::gates {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::string_view kWritten = "written, never read: its command shows one";
const std::vector<Excuse> kWithoutExample = {
    {"calibration_report", kWritten},
    {"check_report", kWritten},
    {"gearbox", "read as a part of actuators and gear_strength; a problem stands for it"},
    {"identification_report", kWritten},
    {"lint_report", kWritten},
    {"mor_need", kWritten},
    {"mor_ratios", kWritten},
    {"mor_table", kWritten},
    {"region_comparison", kWritten},
    {"simulator_file", kWritten},
    {"strength_report", kWritten},
};

Names kinds() {
  Names names;
  for (const fs::path& file : files_in("specs/schema", ".json")) names.insert(file.stem().string());
  return names;
}

TEST(EveryKind, IsCarriedByTheProgram) {
  Names carried;
  for (const io::EmbeddedSchema& schema : io::embedded_schemas()) carried.emplace(schema.kind);
  EXPECT_EQ(carried, kinds());
}

TEST(EveryKind, IsWhatItsSchemaAsksFor) {
  for (const std::string& kind : kinds()) {
    const json schema = json::parse(text_of("specs/schema/" + kind + ".json"));
    EXPECT_EQ(schema["properties"]["kind"]["const"], kind);
  }
}

TEST(EveryKind, IsInTheIndexOfTheDocs) {
  EXPECT_EQ(named_in_first_column(section(text_of("docs/README.md"), "## Which document")),
            kinds());
}

TEST(EveryKind, HasAnExample) {
  Names missing = kinds();
  for (const fs::path& file : files_in("specs", ".json")) {
    if (file.parent_path() == "specs/schema") continue;
    const json document = json::parse(text_of(file));
    const std::string kind = document.value("kind", "");
    EXPECT_TRUE(kinds().contains(kind)) << file << " " << kind;
    missing.erase(kind);
  }
  expect_excused(missing, kWithoutExample, "no file in specs/ is an example of it");
}

}  // namespace
}  // namespace torquewright::gates
