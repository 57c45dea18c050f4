// SPDX-License-Identifier: Apache-2.0
// What computes knows no JSON: it is read and written in io/, in files called *_spec or *_json, and
// by the checker of proofs, whose input is documents. Oracle: the files.
#include <gtest/gtest.h>

#include "tests/gates/excuses.hpp"
#include "tests/gates/source_tree.hpp"

namespace torquewright::layers {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kReadsADocument = "reads a document beside what it computes";
constexpr std::string_view kWritesADocument = "writes a document beside what it computes";
constexpr std::string_view kMovesAValue = "finds a value by its pointer in the robot's document";
constexpr std::string_view kMechanism = "a type of mechanism reads and writes keys of its own";
constexpr std::string_view kBattery = "a robot holds its battery as it was stated, for its drives";
constexpr std::string_view kNamedEffect = "a named effect holds parameters as documents state them";
constexpr std::string_view kTextAndJson = "the text and the JSON of one report stand side by side";

/// They may only become fewer: a file that no longer needs its line fails the test.
const std::vector<gates::Excuse> kExcused = {
    {"actuator/exporters/simulator_file.cpp", kWritesADocument},
    {"actuator/exporters/simulator_file.hpp", kWritesADocument},
    {"actuator/motor/gearbox_source.cpp", kReadsADocument},
    {"actuator/motor/gearbox_source.hpp", kReadsADocument},
    {"hopper/calibration/free_value.cpp", kMovesAValue},
    {"hopper/mechanisms/constant_jacobian.cpp", kMechanism},
    {"hopper/mechanisms/constant_jacobian.hpp", kMechanism},
    {"hopper/mechanisms/four_bar.cpp", kMechanism},
    {"hopper/mechanisms/four_bar.hpp", kMechanism},
    {"hopper/mechanisms/mechanism.hpp", kMechanism},
    {"hopper/mechanisms/mechanism_type.hpp", kMechanism},
    {"hopper/mechanisms/parallel_ankle.hpp", kMechanism},
    {"hopper/motion/motion_reader.cpp", kReadsADocument},
    {"hopper/robot/robot.hpp", kBattery},
    {"identification/identify.cpp", kWritesADocument},
    {"identification/identify.hpp", kWritesADocument},
    {"identification/naming.cpp", kNamedEffect},
    {"identification/plain_equations.cpp", kNamedEffect},
    {"identification/result.hpp", kNamedEffect},
    {"src/commands/actuator_export.hpp", kWritesADocument},
    {"src/commands/proof_check.hpp", kWritesADocument},
    {"src/report/actuator_text.hpp", kTextAndJson},
    {"src/report/calibration_text.hpp", kTextAndJson},
    {"src/report/comparison_text.hpp", kTextAndJson},
    {"src/report/strength_text.hpp", kTextAndJson},
};

bool may_know_json(const fs::path& file) {
  const std::string name = file.generic_string();
  const std::string stem = file.stem().string();
  return name.starts_with("io/") || name.starts_with("gearbox/proof/") ||
         name.starts_with("gearbox/verification/") || stem.ends_with("_spec") ||
         stem.ends_with("_json");
}

/// Commands put together what the libraries wrote, so they may name its types; they include it no
/// more than others do.
bool knows_json(const fs::path& file) {
  const std::string text = gates::text_of(file);
  return text.find("#include <nlohmann/") != std::string::npos ||
         (*file.begin() != "src" && text.find("nlohmann") != std::string::npos);
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
  gates::expect_excused(broken, kExcused,
                        "only io/, the checker of proofs and files called *_spec or *_json know "
                        "nlohmann/json");
}

}  // namespace
}  // namespace torquewright::layers
