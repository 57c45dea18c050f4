// SPDX-License-Identifier: Apache-2.0
// A picture is whole, or there is none. Oracle: programs that stand in gnuplot's place, and end as
// a full disk, a crash, or a missing screen make it end.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/cli/well_formed.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

Outcome draw(const Workplace& place, const std::string& picture) {
  return place.run(
      {"actuator", "mor", in_repository("specs/actuator/d151_knee.json"), "--plot", picture});
}

/// In the place of gnuplot, a script of the shell.
void install(Workplace& place, const std::string& script) {
  place.write("gnuplot", "#!/bin/sh\ncat > /dev/null\n" + script + "\n");
  fs::permissions(place.path("gnuplot"), fs::perms::owner_all);
  place.here.environment = {"PATH=" + place.path().string() + ":" + std::getenv("PATH")};
}

TEST(PictureByGnuplot, IsNoneWhereGnuplotFails) {
  struct Failure {
    std::string script, said;
  };
  for (const auto& [script, said] : {
           Failure{"echo '<svg>'", "drew half of it"},
           Failure{"echo 'out of ink' >&2; exit 3", "ended with 3: out of ink"},
           Failure{"echo '<svg></svg>'; kill -SEGV $$", "was ended by signal 11"},
       }) {
    Workplace place;
    install(place, script);
    const Outcome outcome = draw(place, "region.svg");
    EXPECT_EQ(outcome.exit_code, 2) << script;
    EXPECT_NE(outcome.err.find("--plot: gnuplot, which draws the picture, " + said),
              std::string::npos)
        << outcome.err;
    EXPECT_FALSE(place.has("region.svg")) << script;
  }
}

TEST(PictureByGnuplot, HoldsAnyName) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "gnuplot is absent";
  const std::string knee = text_of(in_repository("specs/actuator/ak80_9.json"));
  const std::string key = "\"name\": \"";
  const std::size_t from = knee.find(key) + key.size();
  const std::string own = knee.substr(from, knee.find('"', from) - from);
  for (const char* name : {"'tis", "x''", "it's", "k]]>nee", "a'\\\\]]>'"}) {
    Workplace place;
    place.write("knee.json", with(knee, key + own, key + name));
    const Outcome outcome = place.run({"actuator", "mor", "knee.json", "--plot", "knee.svg"});
    ASSERT_EQ(outcome.exit_code, 0) << name << outcome.err;
    EXPECT_EQ(fault_in(place.text("knee.svg")), "") << name;
  }
}

/// What PATH calls gnuplot writes without end: so much is no picture.
TEST(PictureByGnuplot, IsNotWithoutEnd) {
  Workplace place;
  install(place, "exec yes");
  const Outcome outcome = draw(place, "region.svg");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("was ended by signal"), std::string::npos) << outcome.err;
}

TEST(PictureByGnuplot, NeedsNoScreen) {
  Workplace place;
  install(place, R"(test -z "$GNUTERM" && echo '<svg></svg>')");
  place.here.environment.emplace_back("GNUTERM=qt");
  EXPECT_EQ(draw(place, "region.svg").exit_code, 0);
  EXPECT_EQ(place.text("region.svg"), "<svg></svg>\n");
}

TEST(PictureByGnuplot, IsNotCutOffByTheLimitOfAFile) {
  for (const std::string picture : {"region.svg", "region.png"}) {
    Workplace place;
    place.here.file_size_limit = 16384;  // More than what gnuplot is told, less than a picture.
    const Outcome outcome = draw(place, picture);
    EXPECT_EQ(outcome.exit_code, 2) << picture;
    EXPECT_TRUE(outcome.err.starts_with("--plot: gnuplot")) << outcome.err;
    EXPECT_FALSE(place.has(picture));
  }
}

}  // namespace
}  // namespace torquewright::cli_test
