// SPDX-License-Identifier: Apache-2.0
#include "tests/layers/layers.hpp"

#include <gtest/gtest.h>

#include "tests/io/scratch_folder.hpp"

namespace torquewright::layers {
namespace {

namespace fs = std::filesystem;

std::string objection(std::string_view file, const std::string& included) {
  return objection(file, Include{included, true});
}

std::string objection_to_foreign(std::string_view file, const std::string& included) {
  return objection(file, Include{included, false});
}

TEST(Sources, IncludeOnlyDownward) {
  for (const std::string& sentence : find_objections(TORQUEWRIGHT_SOURCE_DIR)) {
    ADD_FAILURE() << sentence;
  }
}

TEST(Objection, IsRaisedUpwardAndSideways) {
  EXPECT_EQ(objection("io/a.cpp", "gearbox/b.hpp"), "io/ does not stand above gearbox/");
  for (const auto& [file, included] : std::vector<std::pair<std::string, std::string>>{
           {"io/a.cpp", "optimization/b.hpp"},
           {"optimization/a.cpp", "gearbox/b.hpp"},
           {"gearbox/a.cpp", "src/b.hpp"},
           {"gearbox/a.cpp", "actuator/b.hpp"},
           {"actuator/a.cpp", "dynamics/b.hpp"},
           {"dynamics/a.cpp", "actuator/b.hpp"},
           {"simulation/a.cpp", "identification/b.hpp"},
           {"simulation/a.cpp", "hopper/b.hpp"},
           {"actuator/a.cpp", "simulation/b.hpp"},
           {"dynamics/a.cpp", "simulation/b.hpp"},
           {"hopper/a.cpp", "identification/b.hpp"},
           {"identification/a.cpp", "hopper/b.hpp"},
           {"hopper/a.cpp", "src/b.hpp"},
           {"src/a.cpp", "python/b.hpp"}}) {
    EXPECT_NE(objection(file, included), "") << file << " " << included;
  }
}

TEST(Objection, IsNotRaisedDownward) {
  for (const auto& [file, included] : std::vector<std::pair<std::string, std::string>>{
           {"io/a.cpp", "io/b.hpp"},
           {"gearbox/a.cpp", "optimization/b.hpp"},
           {"gearbox/search/a.cpp", "gearbox/topologies/b.hpp"},
           {"hopper/a.cpp", "actuator/b.hpp"},
           {"hopper/a.cpp", "dynamics/b.hpp"},
           {"simulation/a.cpp", "actuator/b.hpp"},
           {"simulation/a.cpp", "dynamics/b.hpp"},
           {"hopper/a.cpp", "simulation/run/b.hpp"},
           {"identification/a.cpp", "simulation/run/b.hpp"},
           {"src/report/a.cpp", "gearbox/proof/result/b.hpp"},
           {"python/a.cpp", "src/b.hpp"}}) {
    EXPECT_EQ(objection(file, included), "") << file << " " << included;
  }
}

TEST(Objection, IsRaisedBetweenRooms) {
  EXPECT_EQ(objection("actuator/motor/a.cpp", "actuator/region/b.hpp"),
            "actuator/motor/ does not stand above actuator/region/");
  EXPECT_EQ(objection("gearbox/problem.cpp", "gearbox/teeth/b.hpp"),
            "what lies beside the rooms of gearbox/ does not stand above gearbox/teeth/");
  EXPECT_EQ(objection("gearbox/cellar/a.cpp", "gearbox/problem.hpp"),
            "the layer test does not know the room gearbox/cellar");
  EXPECT_NE(objection("src/options/a.cpp", "src/commands/b.hpp"), "");
  EXPECT_NE(objection("simulation/joint/a.cpp", "simulation/stepper/b.hpp"), "");
  EXPECT_NE(objection("simulation/stepper/a.cpp", "simulation/plants/b.hpp"), "");
  EXPECT_NE(objection("actuator/heat/a.cpp", "actuator/region/b.hpp"), "");
  EXPECT_NE(objection("hopper/check/rules/a.cpp", "hopper/candidates/b.hpp"), "");
}

TEST(Objection, IsNotRaisedFromRoomToRoomDownward) {
  for (const auto& [file, included] : std::vector<std::pair<std::string, std::string>>{
           {"actuator/region/a.cpp", "actuator/motor/b.hpp"},
           {"actuator/region/a.cpp", "actuator/severity.hpp"},
           {"actuator/region/a.cpp", "actuator/heat/b.hpp"},
           {"simulation/run/a.cpp", "simulation/stepper/b.hpp"},
           {"simulation/stepper/a.cpp", "simulation/plant.hpp"},
           {"gearbox/teeth/a.cpp", "gearbox/teeth/b.hpp"},
           {"hopper/check/rules/a.cpp", "hopper/check/b.hpp"},
           {"hopper/check/a.cpp", "hopper/check/rules/b.hpp"},
           {"src/main.cpp", "src/commands/b.hpp"},
           {"src/program.cpp", "src/commands/b.hpp"}}) {
    EXPECT_EQ(objection(file, included), "") << file << " " << included;
  }
}

TEST(Objection, KeepsTheCheckerOfProofsApart) {
  EXPECT_EQ(objection("gearbox/proof/tree/a.cpp", "gearbox/proof/gears/b.hpp"), "");
  EXPECT_NE(objection("gearbox/proof/gears/a.cpp", "gearbox/proof/tree/b.hpp"), "");
  EXPECT_EQ(objection("gearbox/proof/tree/a.cpp", "gearbox/problem.hpp"), "");
  EXPECT_EQ(objection("gearbox/proof/tree/a.cpp", "gearbox/problem_spec.hpp"), "");
  EXPECT_EQ(objection("gearbox/proof/tree/a.cpp", "io/text/rational.hpp"), "");
  EXPECT_NE(objection("gearbox/proof/tree/a.cpp", "gearbox/train/efficiency.hpp"), "");
  EXPECT_NE(objection("gearbox/proof/tree/a.cpp", "gearbox/verification/verification.hpp"), "");
  EXPECT_NE(objection("gearbox/proof/tree/a.cpp", "optimization/expressions/interval.hpp"), "");
  EXPECT_NE(objection("gearbox/proof/tree/a.cpp", "../efficiency.hpp"), "");
  EXPECT_NE(objection("gearbox/proof/tree/a.cpp", "gearbox/proof/../train/efficiency.hpp"), "");
}

TEST(Objection, KeepsSolversInOptimization) {
  for (const char* solver : {"IpTNLP.hpp", "coin/IpTNLP.hpp", "coin-or/IpTNLP.hpp", "nlopt.hpp"}) {
    EXPECT_EQ(objection_to_foreign("optimization/a.cpp", solver), "") << solver;
    EXPECT_EQ(objection_to_foreign("gearbox/a.cpp", solver), "only optimization/ includes a solver")
        << solver;
  }
}

TEST(Objection, KeepsTheParserOfCommandLinesInItsRoom) {
  EXPECT_EQ(objection_to_foreign("src/command_line/a.cpp", "CLI/CLI.hpp"), "");
  for (const char* file : {"src/main.cpp", "src/commands/a.cpp", "src/options/a.hpp"}) {
    EXPECT_EQ(objection_to_foreign(file, "CLI/CLI.hpp"), "only src/command_line/ includes CLI11")
        << file;
  }
  EXPECT_NE(objection("src/command_line/a.cpp", "src/options/b.hpp"), "");
}

TEST(Objection, IsRaisedToWhatIsNotForTheLibrary) {
  EXPECT_EQ(objection("io/a.cpp", "tests/io/b.hpp"), "tests/ is not for the library");
  EXPECT_EQ(objection("src/main.cpp", "bench/b.hpp"), "bench/ is not for the library");
}

TEST(Objection, IsRaisedToPathsThatDoNotBeginAtTheRoot) {
  for (const char* included : {"b.hpp", "region/b.hpp", "../region/b.hpp", "actuator/../b.hpp"}) {
    EXPECT_NE(objection("actuator/motor/a.cpp", included), "") << included;
  }
  for (const char* included : {"vector", "nlohmann/json.hpp"}) {
    EXPECT_EQ(objection_to_foreign("io/a.cpp", included), "") << included;
  }
}

TEST(IncludesIn, AreFoundHoweverTheyAreSpaced) {
  const std::vector<Include> found =
      includes_in("#include \"a/b.hpp\"\n  #  include <c>\nint x;\n// #include \"d\"\n");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].name, "a/b.hpp");
  EXPECT_TRUE(found[0].is_quoted);
  EXPECT_EQ(found[1].name, "c");
  EXPECT_FALSE(found[1].is_quoted);
}

TEST(FindObjections, CatchesAnUpwardIncludeInATree) {
  const test::ScratchFolder folder;
  fs::create_directories(folder.path() / "io" / "deep");
  fs::create_directories(folder.path() / "actuator" / "motor");
  folder.write("io/fine.cpp", "#include \"io/fine.hpp\"\n");
  EXPECT_TRUE(find_objections(folder.path()).empty());
  folder.write("io/deep/bad.hpp", "#pragma once\n#include \"src/main.hpp\"\n");
  folder.write("actuator/motor/bad.cpp", "#include \"actuator/region/region.hpp\"\n");
  EXPECT_EQ(find_objections(folder.path()),
            (std::vector<std::string>{
                "actuator/motor/bad.cpp includes actuator/region/region.hpp: actuator/motor/ does "
                "not stand above actuator/region/",
                "io/deep/bad.hpp includes src/main.hpp: io/ does not stand above src/"}));
}

}  // namespace
}  // namespace torquewright::layers
