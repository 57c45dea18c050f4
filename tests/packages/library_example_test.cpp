// SPDX-License-Identifier: Apache-2.0
// The library, installed below a prefix, as the program of examples/library uses it: found by CMake
// and by pkg-config. Oracle: the installed program, asked the same (actuator mor --at-speed); the
// linker, which must find every symbol of the whole archive; the compiler, which must find every
// header.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <regex>

#include "tests/io/scratch_folder.hpp"
#include "tests/packages/shell.hpp"

namespace torquewright::packages_test {
namespace {

namespace fs = std::filesystem;

// The example prints twelve digits, the program fourteen.
constexpr double kPrinted = 1e-11;

/// The first and second torque of a line, whatever separates them.
struct Torques {
  double least_Nm = NAN;
  double greatest_Nm = NAN;
};

class LibraryExample : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = std::make_unique<test::ScratchFolder>();
    text_by(sh_word(TORQUEWRIGHT_CMAKE) + " --install " + sh_word(TORQUEWRIGHT_BUILD_DIR) +
            " --prefix " + sh_word(prefix()));
  }
  static void TearDownTestSuite() { scratch_.reset(); }

  static fs::path prefix() { return scratch_->path() / "prefix"; }
  static fs::path place(const std::string& name) { return scratch_->path() / name; }
  static fs::path program() { return prefix() / "bin/torquewright"; }
  static fs::path archive() { return prefix() / TORQUEWRIGHT_LIBRARY_FOLDER / "libtorquewright.a"; }
  static std::string document(const std::string& name) {
    return sh_word(prefix() / "share/torquewright/specs/actuator" / name);
  }

  /// The compiler with what pkg-config says, of the installed package and no other of its name.
  static std::string compile(const std::string& what) {
    const fs::path files = prefix() / TORQUEWRIGHT_LIBRARY_FOLDER / "pkgconfig";
    return "export PKG_CONFIG_PATH=" + sh_word(files) +
           "; flags=$(pkg-config --cflags --libs torquewright) && " +
           sh_word(TORQUEWRIGHT_COMPILER) + " -std=c++20 -Wall -Wextra -Werror " + what + " $flags";
  }

  /// As a user would, out of the tree.
  static fs::path built_by_cmake(const std::string& folder, const std::string& options = "") {
    const std::string cmake = sh_word(TORQUEWRIGHT_CMAKE);
    text_by(cmake + " -S " + sh_word(example()) + " -B " + sh_word(place(folder)) + " -G " +
            sh_word(TORQUEWRIGHT_GENERATOR) + " -DCMAKE_PREFIX_PATH=" + sh_word(prefix()) +
            " -DCMAKE_CXX_COMPILER=" + sh_word(TORQUEWRIGHT_COMPILER) + " " + options);
    text_by(cmake + " --build " + sh_word(place(folder)));
    return place(folder) / "can_it_push";
  }
  static fs::path example() { return fs::path(TORQUEWRIGHT_SOURCE_DIR) / "examples/library"; }

  static Torques said_by_example(const fs::path& built, const std::string& file, double speed) {
    Torques torques;
    const std::string text =
        text_by(sh_word(built) + " " + document(file) + " " + std::to_string(speed) + " 0");
    std::sscanf(text.c_str(), "%lf %lf", &torques.least_Nm, &torques.greatest_Nm);
    return torques;
  }
  static Torques said_by_program(const std::string& file, double speed) {
    Torques torques;
    const std::string text = text_by(sh_word(program()) + " actuator mor " + document(file) +
                                     " --at-speed=" + std::to_string(speed));
    const std::string row = lines_of(text).back();
    std::sscanf(row.c_str(), "%*[^,],%lf,%lf", &torques.least_Nm, &torques.greatest_Nm);
    return torques;
  }

  static void expect_same_answers(const fs::path& built) {
    for (const std::string file : {"d110a_ankle.json", "ak80_9.json"}) {
      for (const double speed : {0.0, 5.0, -15.0}) {
        const Torques ours = said_by_example(built, file, speed);
        const Torques theirs = said_by_program(file, speed);
        ASSERT_LT(theirs.least_Nm, 0) << file;
        EXPECT_NEAR(ours.least_Nm, theirs.least_Nm, kPrinted * std::abs(theirs.least_Nm)) << file;
        EXPECT_NEAR(ours.greatest_Nm, theirs.greatest_Nm, kPrinted * std::abs(theirs.greatest_Nm));
      }
    }
  }

 private:
  static inline std::unique_ptr<test::ScratchFolder> scratch_;
};

TEST_F(LibraryExample, IsBuiltByFindPackage) {
  const fs::path built = built_by_cmake("found");
  expect_same_answers(built);
  // The D110A's torque ends at 176 Nm, of which 175 is one and 177 is none.
  const std::string ask = sh_word(built) + " " + document("d110a_ankle.json") + " 0 ";
  EXPECT_EQ(said_by(ask + "175").exit_code, 0);
  EXPECT_EQ(said_by(ask + "177").exit_code, 1);
  // Faster than the D151 turns.
  EXPECT_TRUE(std::isnan(said_by_program("d151_knee.json", -15).least_Nm));
  EXPECT_EQ(said_by(sh_word(built) + " " + document("d151_knee.json") + " -15 0").text, "none\n");
  const Said refused = said_by(sh_word(built) + " /nowhere.json 0 0");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.text.find("/nowhere.json"), std::string::npos) << refused.text;
}

TEST_F(LibraryExample, IsBuiltByPkgConfig) {
  if (const std::string missing = missing_programs({"pkg-config"}); !missing.empty()) {
    GTEST_SKIP() << "not installed:" << missing;
  }
  const fs::path built = place("by_pkg_config");
  text_by(compile("-o " + sh_word(built) + " " + sh_word(example() / "can_it_push.cpp")));
  expect_same_answers(built);
}

/// All of the archive in a program, and not only what the example happens to use.
std::string whole(const fs::path& archive) {
  return "-Wl,--whole-archive," + archive.string() + ",--no-whole-archive";
}

TEST_F(LibraryExample, LacksNoSymbolInAnyPartOfTheLibrary) {
  built_by_cmake("whole");
  built_by_cmake("whole", "-DCMAKE_EXE_LINKER_FLAGS=" + sh_word(whole(archive())));
  if (const std::string missing = missing_programs({"pkg-config"}); !missing.empty()) {
    GTEST_SKIP() << "not installed:" << missing;
  }
  text_by(compile("-o " + sh_word(place("whole_by_pkg_config")) + " " +
                  sh_word(example() / "can_it_push.cpp") + " " + sh_word(whole(archive()))));
}

TEST_F(LibraryExample, FindsEveryHeader) {
  if (const std::string missing = missing_programs({"pkg-config"}); !missing.empty()) {
    GTEST_SKIP() << "not installed:" << missing;
  }
  std::string source;
  std::size_t count = 0;
  for (const std::string& header : files_below(prefix() / "include/torquewright")) {
    const bool is_mujoco =
        text_of(prefix() / "include/torquewright" / header).find("<mujoco/") != std::string::npos;
    if (is_mujoco && !fs::exists("/usr/include/mujoco")) continue;
    source += "#include \"" + header + "\"\n";
    ++count;
  }
  EXPECT_GT(count, 500u);
  std::ofstream(place("all.cpp")) << source;
  text_by(compile("-fsyntax-only " + sh_word(place("all.cpp"))));
}

TEST_F(LibraryExample, IsRefusedAnotherVersion) {
  std::ofstream(place("CMakeLists.txt"))
      << "cmake_minimum_required(VERSION 3.22)\nproject(later LANGUAGES CXX)\n"
         "find_package(Torquewright 99 REQUIRED)\n";
  const Said said =
      said_by(sh_word(TORQUEWRIGHT_CMAKE) + " -S . -B later -G " + sh_word(TORQUEWRIGHT_GENERATOR) +
                  " -DCMAKE_PREFIX_PATH=" + sh_word(prefix()),
              place(""));
  EXPECT_NE(said.exit_code, 0);
  EXPECT_NE(said.text.find("version: " TORQUEWRIGHT_VERSION), std::string::npos) << said.text;
}

TEST_F(LibraryExample, HasNothingOfTestsBesideIt) {
  for (const std::string& file : files_below(prefix())) {
    EXPECT_FALSE(std::regex_search(file, std::regex("test|bench/|gtest|oracle"))) << file;
  }
  EXPECT_EQ(files_below(prefix() / "bin"), std::vector<std::string>{"torquewright"});
}

}  // namespace
}  // namespace torquewright::packages_test
