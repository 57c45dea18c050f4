// SPDX-License-Identifier: Apache-2.0
// The archive for every Linux. Oracles: the program that was built, which must answer alike; the
// loader, which says whose libraries it takes; ldd, which says which the program needs; an empty
// root, where nothing but the archive is. scripts/check-portable asks the same on other systems.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "tests/io/scratch_folder.hpp"
#include "tests/packages/shell.hpp"

namespace torquewright::packages_test {
namespace {

namespace fs = std::filesystem;

const std::string kName = "torquewright-" TORQUEWRIGHT_VERSION "-linux-x86_64";
const std::string kNoLibraries = "env -i PATH=/usr/bin:/bin ";

class PortableArchive : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    missing_ = missing_programs({"dpkg-query", "ldd", "tar"});
    if (!missing_.empty()) return;
    scratch_ = std::make_unique<test::ScratchFolder>();
    text_by(sh_word(TORQUEWRIGHT_CPACK) + " -G TGZ --config " +
            sh_word(fs::path(TORQUEWRIGHT_BUILD_DIR) / "CPackConfig.cmake") + " -B " +
            sh_word(scratch_->path()));
    fs::create_directories(root());
    text_by("tar -xzf " + sh_word(scratch_->path() / (kName + ".tar.gz")) + " -C " +
            sh_word(root()));
  }
  static void TearDownTestSuite() { scratch_.reset(); }
  void SetUp() override {
    if (!missing_.empty()) GTEST_SKIP() << "not installed:" << missing_;
  }

  static fs::path root() { return scratch_->path() / "a root"; }
  static fs::path folder() { return root() / kName; }
  static fs::path libraries() { return folder() / "lib/torquewright"; }
  static std::string launcher() { return sh_word(folder() / "bin/torquewright"); }

  /// The same words by the archive and by the program that was built, in the archive's folder.
  static void expect_alike(const std::string& words) {
    const Said said = said_by(kNoLibraries + launcher() + " " + words, folder());
    const Said expected =
        said_by(kNoLibraries + sh_word(TORQUEWRIGHT_PROGRAM) + " " + words, folder());
    EXPECT_EQ(said.exit_code, expected.exit_code) << words;
    EXPECT_EQ(said.text, expected.text) << words;
  }

 private:
  static inline std::string missing_;
  static inline std::unique_ptr<test::ScratchFolder> scratch_;
};

const std::string kSweep =
    "hopper check share/torquewright/specs/robot/hopper.json "
    "share/torquewright/specs/trajectory/hopper_squat.csv --sweep knee_ratio=15:25:5 --jobs 2";

TEST_F(PortableArchive, AnswersAsTheProgramDoes) {
  expect_alike("--version");
  expect_alike("actuator mor share/torquewright/specs/actuator/d151_knee.json");
  expect_alike("gearbox optimize share/torquewright/specs/gearbox/d151_knee.json");
  expect_alike("gearbox optimize nothing.json");
  expect_alike(kSweep);
}

TEST_F(PortableArchive, TakesItsOwnLibrariesAlone) {
  std::size_t count = 0;
  const std::string listed =
      text_by(sh_word(libraries() / "ld-linux-x86-64.so.2") + " --inhibit-cache --library-path " +
              sh_word(libraries()) + " --list " + sh_word(libraries() / "torquewright"));
  for (const std::string& line : lines_of(listed)) {
    if (line.find("=> ") == std::string::npos) continue;
    EXPECT_NE(line.find("=> " + libraries().string() + "/"), std::string::npos) << line;
    ++count;
  }
  const std::string needed = text_by("ldd " + sh_word(TORQUEWRIGHT_PROGRAM));
  std::size_t needed_files = 0;  // the loader among them, but not what the kernel maps
  for (const std::string& line : lines_of(needed)) needed_files += line.find('/') < line.size();
  EXPECT_EQ(count, needed_files);
  EXPECT_GT(count, 10u);
}

// Nothing but the archive, and what the system itself shows of processes.
TEST_F(PortableArchive, WorksInAnEmptyRoot) {
  fs::create_directories(root() / "proc");
  const std::string inside = "unshare --map-root-user --fork --pid --mount --root " +
                             sh_word(root()) + " --mount-proc --wd /" + kName + " /" + kName +
                             "/bin/torquewright ";
  if (const Said said = said_by(inside + "--version"); said.text.starts_with("unshare: ")) {
    GTEST_SKIP() << said.text;
  }
  EXPECT_EQ(text_by(inside + "--version"), text_by(sh_word(TORQUEWRIGHT_PROGRAM) + " --version"));
  const std::string words = "gearbox optimize share/torquewright/specs/gearbox/finger_joint.json";
  EXPECT_EQ(said_by(inside + words).text,
            said_by(sh_word(TORQUEWRIGHT_PROGRAM) + " " + words, folder()).text);
}

TEST_F(PortableArchive, IsStartedByALinkAndFromAnywhere) {
  const fs::path link = root() / "link";
  fs::create_symlink(folder() / "bin/torquewright", link);
  const std::string version = text_by(sh_word(TORQUEWRIGHT_PROGRAM) + " --version");
  EXPECT_EQ(text_by(sh_word(link) + " --version", "/"), version);
  EXPECT_EQ(text_by("PATH=" + sh_word(folder() / "bin") + " && torquewright --version"), version);
  EXPECT_EQ(text_by("bin/torquewright --version", folder()), version);
}

// A new start of itself before main, as where OpenBLAS has little room (src/limited_address_space).
TEST_F(PortableArchive, StartsAgainAsItWasStarted) {
  const std::string limited =
      "ulimit -v 420000; LD_PRELOAD=" + sh_word(TORQUEWRIGHT_OPENBLAS_STAND_IN) + " " + launcher() +
      " --version";
  EXPECT_EQ(text_by(limited), text_by(sh_word(TORQUEWRIGHT_PROGRAM) + " --version"));
}

TEST_F(PortableArchive, SaysWhatIsMissingOrInTheWay) {
  const fs::path part = root() / "part";
  fs::create_directories(part / "bin");
  fs::copy(folder() / "bin/torquewright", part / "bin/torquewright");
  const Said torn = said_by(sh_word(part / "bin/torquewright") + " --version");
  EXPECT_EQ(torn.exit_code, 2);
  EXPECT_NE(torn.text.find("part/lib/torquewright/ld-linux-x86-64.so.2: No such file"),
            std::string::npos)
      << torn.text;
  const fs::path colon = root() / "a:b";
  fs::create_symlink(folder(), root() / "whole");
  fs::create_directories(colon / "bin");
  fs::copy(folder() / "bin/torquewright", colon / "bin/torquewright");
  const Said cut = said_by(sh_word(colon / "bin/torquewright") + " --version");
  EXPECT_EQ(cut.exit_code, 2);
  EXPECT_NE(cut.text.find("holds ':'"), std::string::npos) << cut.text;
}

TEST_F(PortableArchive, ListsWhatItCarriesWithALicenceOfEach) {
  const fs::path papers = folder() / "share/doc/torquewright";
  const std::string list = text_of(papers / "CARRIED");
  for (const auto& entry : fs::directory_iterator(libraries())) {
    const std::string name = entry.path().filename().string();
    if (name == "torquewright") continue;
    EXPECT_NE(list.find("\n" + name + " "), std::string::npos) << name;
  }
  const std::string before = "LICENSE.\n\n";
  const std::string rows = list.substr(list.find(before) + before.size());
  for (const std::string& row : lines_of(rows)) {
    if (row.empty()) continue;
    constexpr std::size_t kPackageColumn = 32;
    const std::string package =
        row.substr(kPackageColumn, row.find(' ', kPackageColumn) - kPackageColumn);
    EXPECT_GT(fs::file_size(papers / "licences" / package), 200u) << row;
  }
  EXPECT_TRUE(fs::exists(papers / "licences/common/GPL-3"));
  EXPECT_EQ(text_of(papers / "LICENSE"), text_of(fs::path(TORQUEWRIGHT_SOURCE_DIR) / "LICENSE"));
}

// The GPL asks of what is given away in one piece what Ipopt's licence does not allow.
TEST_F(PortableArchive, HoldsNothingOfTheGplBesideIpopt) {
  EXPECT_FALSE(fs::exists(libraries() / "libdxflib.so.3"));
}

TEST_F(PortableArchive, HasAllSchemasAndExamples) {
  const fs::path specs = fs::path(TORQUEWRIGHT_SOURCE_DIR) / "specs";
  EXPECT_EQ(files_below(folder() / "share/torquewright/specs"), files_below(specs));
}

}  // namespace
}  // namespace torquewright::packages_test
