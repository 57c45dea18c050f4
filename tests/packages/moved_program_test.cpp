// SPDX-License-Identifier: Apache-2.0
// The program needs nothing of the tree that it was built from. Oracle: the system, which shows it
// none: a copy of the program alone in a folder of its own, with the tree hidden where the system
// allows that; and the bytes of the program, which do not know where the tree is.
#include <gtest/gtest.h>

#include "tests/io/scratch_folder.hpp"
#include "tests/packages/shell.hpp"

namespace torquewright::packages_test {
namespace {

namespace fs = std::filesystem;

/// The program, copied, and the examples, copied.
struct Elsewhere {
  Elsewhere() {
    fs::create_directories(folder.path() / "bin");
    fs::copy_file(TORQUEWRIGHT_PROGRAM, program());
    fs::copy(fs::path(TORQUEWRIGHT_SOURCE_DIR) / "specs", folder.path() / "examples",
             fs::copy_options::recursive);
    fs::remove_all(folder.path() / "examples/schema");
  }
  fs::path program() const { return folder.path() / "bin/program"; }

  /// The program with these arguments, as words of sh, in the folder, where no tree is.
  Said run(const std::string& arguments) const {
    const std::string line = sh_word(program()) + " " + arguments;
    const std::string hidden = "mount -t tmpfs none " + sh_word(TORQUEWRIGHT_SOURCE_DIR) + " && ";
    static const bool can_hide =
        said_by("unshare --user --map-root-user --mount sh -c " + sh_word(hidden + "true"))
            .exit_code == 0;
    if (!can_hide) return said_by(line, folder.path());
    return said_by("unshare --user --map-root-user --mount sh -c " + sh_word(hidden + line),
                   folder.path());
  }

  test::ScratchFolder folder;
};

TEST(MovedProgram, DoesNotKnowWhereItWasBuilt) {
  const std::string bytes = text_of(TORQUEWRIGHT_PROGRAM);
  EXPECT_EQ(bytes.find(TORQUEWRIGHT_SOURCE_DIR), std::string::npos);
  EXPECT_EQ(bytes.find(TORQUEWRIGHT_BUILD_DIR), std::string::npos);
}

TEST(MovedProgram, HasItsSchemasHelpAndPages) {
  const Elsewhere elsewhere;
  for (const std::string& command : commands_of(elsewhere.program())) {
    EXPECT_EQ(elsewhere.run("help " + command).exit_code, 0) << command;
  }
  std::size_t count = 0;
  for (const std::string& file : files_below(fs::path(TORQUEWRIGHT_SOURCE_DIR) / "specs/schema")) {
    const std::string command = "schema " + fs::path(file).stem().string();
    EXPECT_EQ(elsewhere.run(command).text, text_by(sh_word(TORQUEWRIGHT_PROGRAM) + " " + command));
    ++count;
  }
  EXPECT_GT(count, 20u);
}

TEST(MovedProgram, WritesADocumentToStartFromAndReadsIt) {
  const Elsewhere elsewhere;
  EXPECT_EQ(elsewhere.run("init actuator -o mine.json").exit_code, 0);
  const Said said = elsewhere.run("actuator mor mine.json --at-speed 0");
  EXPECT_EQ(said.exit_code, 0) << said.text;
}

TEST(MovedProgram, RefusesByItsSchema) {
  const Elsewhere elsewhere;
  elsewhere.folder.write("wrong.json", R"({"kind": "actuator", "version": 1, "motr": {}})");
  const Said said = elsewhere.run("actuator mor wrong.json");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_NE(said.text.find("motr"), std::string::npos) << said.text;
}

// Searches, pages with their scripts and styles, and processes that it starts of itself.
TEST(MovedProgram, DoesItsWork) {
  const Elsewhere elsewhere;
  for (const std::string arguments :
       {"gearbox optimize examples/gearbox/d151_knee.json --draw knee.svg",
        "gearbox verify examples/gearbox/d151_knee_result.json",
        "hopper check examples/robot/hopper.json examples/trajectory/hopper_squat.csv"
        " --report page.html",
        "hopper check examples/robot/hopper.json examples/trajectory/hopper_squat.csv"
        " --sweep knee_ratio=15:25:5 --jobs 2",
        "robot export examples/robot/rabbit.json --format urdf"}) {
    const Said said = elsewhere.run(arguments);
    EXPECT_TRUE(said.exit_code == 0 || said.exit_code == 1) << arguments << "\n" << said.text;
    EXPECT_EQ(said.text.find("error"), std::string::npos) << said.text;
  }
}

}  // namespace
}  // namespace torquewright::packages_test
