// SPDX-License-Identifier: Apache-2.0
// The Debian packages that cpack makes. Oracle: dpkg-deb, which reads them; dpkg, which knows whose
// libraries the program needs; lintian, which knows Debian's rules; and the tree, whose schemas and
// examples must be in them.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <sstream>

#include "tests/io/scratch_folder.hpp"
#include "tests/long_run.hpp"
#include "tests/packages/shell.hpp"

namespace torquewright::packages_test {
namespace {

namespace fs = std::filesystem;

constexpr bool kHasPython = TORQUEWRIGHT_HAS_PYTHON;

class DebianPackage : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    missing_ = missing_programs({"dpkg-deb", "dpkg-shlibdeps", "file", "gzip"});
    if (!missing_.empty()) return;
    scratch_ = std::make_unique<test::ScratchFolder>();
    // What the packages hold does not depend on how hard they are pressed; gzip takes a third.
    text_by(sh_word(TORQUEWRIGHT_CPACK) +
            " -G DEB -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip --config " +
            sh_word(fs::path(TORQUEWRIGHT_BUILD_DIR) / "CPackConfig.cmake") + " -B " +
            sh_word(scratch_->path()));
    for (const std::string& package : packages()) {
      text_by("dpkg-deb -x " + file_of(package) + " " + sh_word(root()));
    }
  }
  static void TearDownTestSuite() { scratch_.reset(); }
  void SetUp() override {
    if (!missing_.empty()) GTEST_SKIP() << "not installed:" << missing_;
  }

  /// Of Python only where it is built.
  static std::vector<std::string> packages() {
    std::vector<std::string> names{"torquewright", "libtorquewright-dev"};
    if (kHasPython) names.emplace_back("python3-torquewright");
    return names;
  }
  /// Where all packages are unpacked.
  static fs::path root() { return scratch_->path() / "root"; }
  static fs::path program() { return root() / "usr/bin/torquewright"; }
  /// The package's file, for sh.
  static std::string file_of(const std::string& package) {
    return sh_word(scratch_->path()) + "/" + package + "_" TORQUEWRIGHT_VERSION "_*.deb";
  }
  /// The names in a field, without versions.
  static std::set<std::string> names_in(const std::string& package, const std::string& field) {
    std::set<std::string> names;
    std::istringstream stream(text_by("dpkg-deb -f " + file_of(package) + " " + field));
    for (std::string part; std::getline(stream, part, ',');) {
      std::istringstream words(part);
      std::string name;
      words >> name;
      names.insert(name);
    }
    return names;
  }

 private:
  static inline std::string missing_;
  static inline std::unique_ptr<test::ScratchFolder> scratch_;
};

// scripts/check-package asks the same.
TEST_F(DebianPackage, IsInLintiansOrder) {
  if (!test::is_long_run()) GTEST_SKIP() << test::kLeftOut;
  if (const std::string missing = missing_programs({"lintian"}); !missing.empty()) {
    GTEST_SKIP() << "not installed:" << missing;
  }
  std::string files;
  for (const std::string& package : packages()) files += " " + file_of(package);
  const Said said = said_by("lintian --allow-root --fail-on error,warning" + files);
  EXPECT_EQ(said.exit_code, 0) << said.text;
}

TEST_F(DebianPackage, DependsOnWhoseLibrariesTheProgramNeeds) {
  const std::set<std::string> depends = names_in("torquewright", "Depends");
  EXPECT_TRUE(depends.contains("gnuplot-nox"));
  const std::string needed =
      text_by("objdump -p " + sh_word(program()) + " | sed -n 's/^ *NEEDED *//p'");
  std::string patterns;
  for (const std::string& library : lines_of(needed)) patterns += " '*/" + library + "'";
  std::set<std::string> found;  // package/library; several where it is here for other processors
  for (const std::string& line : lines_of(text_by("dpkg-query --search" + patterns))) {
    found.insert(line.substr(0, line.find(':')) + line.substr(line.rfind('/')));
  }
  EXPECT_GT(lines_of(needed).size(), 5u);
  for (const std::string& library : lines_of(needed)) {
    EXPECT_TRUE(std::any_of(depends.begin(), depends.end(), [&](const std::string& package) {
      return found.contains(package + "/" + library);
    })) << library;
  }
}

TEST_F(DebianPackage, IsOfOneVersionAndItsChangelogToo) {
  for (const std::string& package : packages()) {
    EXPECT_EQ(text_by("dpkg-deb -f " + file_of(package) + " Version"), TORQUEWRIGHT_VERSION "\n");
    const fs::path papers = root() / "usr/share/doc" / package;
    const std::string changelog = text_by("gzip -dc " + sh_word(papers / "changelog.gz"));
    EXPECT_TRUE(changelog.starts_with("torquewright (" TORQUEWRIGHT_VERSION ")")) << changelog;
    EXPECT_NE(text_of(papers / "copyright").find("Apache-2.0"), std::string::npos);
  }
}

TEST_F(DebianPackage, HasAPageForManOfEveryCommand) {
  std::set<std::string> expected;
  for (const std::string& words : commands_of(program())) {
    std::string name = "torquewright" + (words.empty() ? "" : " " + words);
    std::replace(name.begin(), name.end(), ' ', '-');
    expected.insert(name + ".1.gz");
    const std::string page =
        text_by("gzip -dc " + sh_word(root() / "usr/share/man/man1" / (name + ".1.gz")));
    EXPECT_EQ(page, text_by(sh_word(program()) + " man " + words)) << name;
  }
  const auto pages = files_below(root() / "usr/share/man");
  EXPECT_EQ(pages.size(), expected.size());
  EXPECT_GT(pages.size(), 20u);
}

TEST_F(DebianPackage, HasCompletionsWhereShellsLook) {
  for (const auto& [shell, file] : std::vector<std::pair<std::string, std::string>>{
           {"bash", "bash-completion/completions/torquewright"},
           {"zsh", "zsh/vendor-completions/_torquewright"},
           {"fish", "fish/vendor_completions.d/torquewright.fish"}}) {
    EXPECT_EQ(text_of(root() / "usr/share" / file),
              text_by(sh_word(program()) + " completion " + shell));
  }
}

TEST_F(DebianPackage, HasAllSchemasAndExamples) {
  const fs::path specs = fs::path(TORQUEWRIGHT_SOURCE_DIR) / "specs";
  const fs::path packed = root() / "usr/share/torquewright/specs";
  const auto files = files_below(specs);
  EXPECT_EQ(files_below(packed), files);
  for (const std::string& file : files) EXPECT_EQ(text_of(packed / file), text_of(specs / file));
}

TEST_F(DebianPackage, WorksOnItsExamples) {
  const Said said = said_by(sh_word(program()) + " gearbox optimize specs/gearbox/d151_knee.json",
                            root() / "usr/share/torquewright");
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_NE(said.text.find("44"), std::string::npos) << said.text;
}

TEST_F(DebianPackage, IsStrippedAndHoldsNothingElse) {
  EXPECT_NE(text_by("objdump -t " + sh_word(program())).find("no symbols"), std::string::npos);
  EXPECT_EQ(files_below(root() / "usr/bin"), std::vector<std::string>{"torquewright"});
  for (const std::string& file : files_below(root())) {
    const bool is_known = file.starts_with("usr/bin/") || file.starts_with("usr/share/") ||
                          file.starts_with("usr/include/torquewright/") ||
                          file.starts_with("usr/lib/python3/dist-packages/torquewright/") ||
                          file.starts_with("usr/" TORQUEWRIGHT_LIBRARY_FOLDER "/");
    EXPECT_TRUE(is_known) << file;
  }
}

// Oracle: Debian's Python, which finds it below the packages' root alone.
TEST_F(DebianPackage, WorksInPython) {
  if (!kHasPython) GTEST_SKIP() << "built without Python";
  const std::set<std::string> depends = names_in("python3-torquewright", "Depends");
  for (const char* package : {"python3", "python3-numpy", "coinor-libipopt1v5", "libc6"}) {
    EXPECT_TRUE(depends.contains(package)) << package;
  }
  const fs::path place = root() / "usr/lib/python3/dist-packages";
  const Said said =
      said_by("PYTHONPATH=" + sh_word(place) +
                  " /usr/bin/python3 -B -c 'import torquewright as t; print(t.__file__, "
                  "t.actuator(\"specs/actuator/d151_knee.json\").clip([400.0, 10.0], 0.0))'",
              root() / "usr/share/torquewright");
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_EQ(said.text, (place / "torquewright/__init__.py").string() + " [320.  10.]\n");
}

// The program's own folder is not the library's.
TEST_F(DebianPackage, HasNoHeadersOfTheProgram) {
  EXPECT_FALSE(fs::exists(root() / "usr/include/torquewright/src"));
  EXPECT_FALSE(fs::exists(root() / "usr/include/torquewright/python"));
}

}  // namespace
}  // namespace torquewright::packages_test
