// SPDX-License-Identifier: Apache-2.0
// Kinds of documents: each that the program reads or writes has a schema, a line in docs/README.md
// and an example in specs/. Oracle: the sources and the files of specs/.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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
    {"plan_report", kWritten},
    {"gearbox", "read as a part of actuators and gear_strength; a problem stands for it"},
    {"identification_report", kWritten},
    {"lint_report", kWritten},
    {"drive_shortlist", kWritten},
    {"gearbox_front", kWritten},
    {"tolerance_report", kWritten},
    {"drive_design", kWritten},
    {"mor_need", kWritten},
    {"mor_ratios", kWritten},
    {"mor_table", kWritten},
    {"region_comparison", kWritten},
    {"replay_report", kWritten},
    {"simulator_file", kWritten},
    {"strength_report", kWritten},
    {"sweep_result", kWritten},
    {"verification_report", kWritten},
};

Names kinds() {
  Names names;
  for (const fs::path& file : files_in("specs/schema", ".json")) names.insert(file.stem().string());
  return names;
}

/// Kinds that code reads: those in the arguments of read_document and check_document.
Names kinds_read_by(const std::string& code) {
  Names kinds;
  for (const std::string& call : matches(code, R"((?:read|check)_document(\([^;]*;))")) {
    kinds.merge(matches(call, R"re([,{]\s*"(\w+)")re"));
  }
  return kinds;
}

/// Kinds that code writes: {"kind", "rig"} and ["kind"] = "rig".
Names kinds_written_by(const std::string& code) {
  Names kinds = matches(code, R"re(\{"kind", "(\w+)"\})re");
  kinds.merge(matches(code, R"re(\["kind"\] = "(\w+)")re"));
  return kinds;
}

TEST(EveryKind, IsReadOrWrittenAndNoOther) {
  Names used;
  for (const char* folder :
       {"gearbox", "actuator", "dynamics", "simulation", "identification", "hopper", "src"}) {
    for (const fs::path& file : files_in(folder, ".cpp")) {
      const std::string code = text_of(file);
      used.merge(kinds_read_by(code));
      used.merge(kinds_written_by(code));
    }
  }
  EXPECT_EQ(used, kinds());
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
