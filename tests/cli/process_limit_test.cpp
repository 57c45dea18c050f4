// SPDX-License-Identifier: Apache-2.0
// What needs another process says so where the system starts none. Oracle: the words of the system
// for EAGAIN, and the folder as it was.
#include <gtest/gtest.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using Words = std::vector<std::string>;

void expect_refused(const Words& command, const std::string& said) {
  Workplace place;
  place.here.environment = {std::string("LD_PRELOAD=") + TORQUEWRIGHT_PROCESS_LIMIT_STAND_IN,
                            "ASAN_OPTIONS=exitcode=99:verify_asan_link_order=0"};
  const Outcome outcome = place.run(command);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err.substr(0, said.size()), said);
  EXPECT_NE(outcome.err.find(std::generic_category().message(EAGAIN)), std::string::npos)
      << outcome.err;
  EXPECT_TRUE(place.files().empty());
}

TEST(ProcessLimit, RefusesPictures) {
  expect_refused({"actuator", "mor", in_specs("actuator/d151_knee.json"), "--plot", "a.svg"},
                 "--plot: gnuplot, which draws the picture, cannot be started: ");
}

TEST(ProcessLimit, RefusesSweeps) {
  expect_refused(
      {"hopper", "check", in_specs("robot/hopper.json"), in_specs("trajectory/hopper_squat.csv"),
       "--sweep", "mass_factor=0.9,1.1", "--jobs", "2"},
      "--jobs: the system starts no further process: ");
}

}  // namespace
}  // namespace torquewright::cli_test
