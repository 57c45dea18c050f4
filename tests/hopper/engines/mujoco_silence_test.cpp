// SPDX-License-Identifier: Apache-2.0
// MuJoCo's way to report trouble: a file where the program runs, and the program's end.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <filesystem>
#include <stdexcept>

#include "tests/hopper/engines/hopper_states.hpp"

namespace torquewright::hopper {
namespace {

constexpr const char* kLog = "MUJOCO_LOG.TXT";

TEST(MujocoSilence, NeitherWritesNorEndsTheProgram) {
  std::filesystem::remove(kLog);
  const Robot robot = test::hopper_robot();
  const auto engine = mujoco_engine(robot, {});
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  mju_warning("of a test");
  EXPECT_THROW(mju_error("of a test"), std::runtime_error);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_FALSE(std::filesystem::exists(kLog));
}

}  // namespace
}  // namespace torquewright::hopper
