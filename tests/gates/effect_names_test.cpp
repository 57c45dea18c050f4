// SPDX-License-Identifier: Apache-2.0
// Whoever wants to know something of an effect asks its record (actuator/effects/effect.hpp), not
// its name: else a further effect costs a branch in each place that asks. Oracle: the sources
// themselves, against the names that the library answers.
#include <gtest/gtest.h>

#include "actuator/effects/library.hpp"
#include "tests/gates/excuses.hpp"
#include "tests/gates/source_tree.hpp"

namespace torquewright::gates {
namespace {

namespace fs = std::filesystem;

/// Everything above the library of effects.
const std::vector<fs::path> kFoldersThatAsk = {"actuator", "dynamics",       "simulation", "robot",
                                               "hopper",   "identification", "src"};
constexpr std::string_view kLibrary = "actuator/effects/";

const std::vector<Excuse> kMayNameEffects = {
    {"actuator/exporters/isaac_lab.cpp", "writes the key `viscous_friction` of Isaac Lab"},
    {"actuator/exporters/isaac_lab_remotized.cpp",
     "writes the key `viscous_friction` of Isaac Lab"},
    {"actuator/source_text/python_classes.cpp", "writes the key `viscous_friction` of Isaac Lab"},
    {"actuator/source_text/python_newton.cpp", "writes the key `viscous_friction` of Isaac Lab"},
    {"identification/outputs/bam_json.cpp", "translates effects into the parameters of BAM"},
    {"identification/outputs/frc.cpp",
     "translates effects into the constants of FRC's feedforward"},
    {"robot/draft/limit_drives_json.cpp", "translates the drag of a file's crank into effects"},
    {"src/report/gearbox/design_text.cpp",
     "reports the play of a gearbox's teeth, which is no effect"},
};

/// Whether the name of an effect stands as a string literal of its own.
bool names_an_effect(const std::string& text) {
  const auto library = actuator::effect_library();
  return std::any_of(library.begin(), library.end(), [&](const actuator::EffectKind* kind) {
    return text.find('"' + std::string(kind->name) + '"') != std::string::npos;
  });
}

TEST(NamesOfEffects, StandInTheLibraryAndInTranslatorsOnly) {
  Names naming;
  for (const fs::path& folder : kFoldersThatAsk) {
    ASSERT_TRUE(fs::is_directory(root() / folder)) << folder;
    for (const char* extension : {".cpp", ".hpp"}) {
      for (const fs::path& file : files_in(folder, extension)) {
        const std::string name = file.generic_string();
        if (!name.starts_with(kLibrary) && names_an_effect(text_of(file))) naming.insert(name);
      }
    }
  }
  expect_excused(naming, kMayNameEffects,
                 "an effect's name as a string literal; ask its record (effect.hpp) instead");
}

// Oracle: both sides of the rule, by hand.
TEST(NamesOfEffects, AreFoundAsWholeLiteralsOnly) {
  EXPECT_TRUE(names_an_effect(R"(if (kind.name == "torque_lag") return;)"));
  EXPECT_FALSE(names_an_effect(R"(// torque_lag, "a torque_lag", "torque_lags")"));
}

}  // namespace
}  // namespace torquewright::gates
