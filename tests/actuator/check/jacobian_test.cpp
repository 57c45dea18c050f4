// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/jacobian.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "actuator/trajectory/jacobian_spec.hpp"
#include "io/documents/document.hpp"
#include "tests/actuator/check/refusal.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

// Oracle: conservation. Power at the joints is power at the actuators, for random matrices, speeds
// and torques; the tolerance is rounding times the condition (|det| > 0.1 here).
TEST(Jacobian, KeepsPower) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-2.0, 2.0);
  int checked = 0;
  while (checked < 1000) {
    const Matrix2 J{number(random), number(random), number(random), number(random)};
    if (std::abs(J[0] * J[3] - J[1] * J[2]) < 0.1) continue;
    ++checked;
    const std::array<double, 2> joint_rad_s{number(random), number(random)};
    const std::array<double, 2> joint_Nm{number(random), number(random)};
    const auto rad_s = actuator_speeds(J, joint_rad_s);
    const auto Nm = *actuator_torques(J, joint_Nm);
    EXPECT_NEAR(rad_s[0] * Nm[0] + rad_s[1] * Nm[1],
                joint_rad_s[0] * joint_Nm[0] + joint_rad_s[1] * joint_Nm[1], 1e-12);
  }
}

// Oracle: closed form. Two equal rods at +-b beside the ankle's middle: pitch moves both alike,
// roll one against the other, so each carries tau_pitch/2 +- tau_roll/(2 b).
TEST(Jacobian, SplitsPitchAndRollOfASymmetricAnkle) {
  const Matrix2 J{1.0, 0.5, 1.0, -0.5};
  const auto Nm = *actuator_torques(J, {40.0, 6.0});
  EXPECT_NEAR(Nm[0], 20.0 + 6.0, 1e-13);
  EXPECT_NEAR(Nm[1], 20.0 - 6.0, 1e-13);
  EXPECT_EQ(actuator_speeds(J, {3.0, 2.0}), (std::array<double, 2>{4.0, 2.0}));
}

TEST(Jacobian, SingularMatricesCarryNoTorque) {
  EXPECT_FALSE(actuator_torques({1.0, 2.0, 2.0, 4.0}, {1.0, 1.0}).has_value());
  EXPECT_FALSE(actuator_torques({0.0, 0.0, 0.0, 0.0}, {1.0, 1.0}).has_value());
  // Just inside and just outside of the threshold: det / |J|^2 = 2e-6 / 2 and 4e-6 / 2.
  EXPECT_FALSE(actuator_torques({1.0, 0.0, 1.0, 1.9e-6}, {1.0, 1.0}).has_value());
  EXPECT_TRUE(actuator_torques({1.0, 0.0, 1.0, 2.1e-6}, {1.0, 1.0}).has_value());
}

// Oracle: invariance. Whether a matrix is singular is no matter of units, nor of which row or
// column is called the first: scaled, and with rows and columns exchanged, it is the same
// threshold.
TEST(Jacobian, IsSingularWhateverTheScale) {
  for (const double scale : {1e-4, 1.0, 1e4}) {
    for (const double share : {0.95, 1.05}) {
      const double one = scale;
      const double small = scale * 2e-6 * share;
      for (const Matrix2& J : {Matrix2{one, 0, one, small}, Matrix2{0, one, small, one},
                               Matrix2{one, small, one, 0}, Matrix2{one, one, 0, small}}) {
        EXPECT_EQ(actuator_torques(J, {1.0, 1.0}).has_value(), share > 1.0) << scale;
      }
    }
  }
}

ParallelDrive bilinear_table() {
  ParallelDrive drive;
  drive.first_rad = {-1.0, 0.0, 2.0};
  drive.second_rad = {0.0, 0.5};
  for (const double x : drive.first_rad) {
    for (const double y : drive.second_rad) {
      drive.matrices.push_back({1.0 + x, y, x * y, 3.0 - 2.0 * y});
    }
  }
  return drive;
}

// Oracle: closed form. What is bilinear in the two angles is interpolated exactly.
TEST(Jacobian, InterpolatesInBothAngles) {
  const ParallelDrive drive = bilinear_table();
  for (const double x : {-1.0, -0.3, 0.0, 1.7, 2.0}) {
    for (const double y : {0.0, 0.2, 0.5}) {
      const Matrix2 J = *jacobian_at(drive, x, y);
      EXPECT_NEAR(J[0], 1.0 + x, 1e-15);
      EXPECT_NEAR(J[1], y, 1e-15);
      EXPECT_NEAR(J[2], x * y, 1e-15);
      EXPECT_NEAR(J[3], 3.0 - 2.0 * y, 1e-15);
    }
  }
  EXPECT_FALSE(jacobian_at(drive, -1.001, 0.2).has_value());
  EXPECT_FALSE(jacobian_at(drive, 0.0, 0.501).has_value());
}

std::string faults_of_jacobian(const std::string& keys) {
  const test::ScratchFolder folder;
  const auto file = folder.write("j.json", R"({"kind": "jacobian", "version": 1, )" + keys + "}");
  return test::refusal([&] { read_parallel_drive(io::read_document(file, "jacobian")); },
                       folder.path());
}

ParallelDrive jacobian_of(const std::string& keys) {
  const test::ScratchFolder folder;
  const auto file = folder.write("j.json", R"({"kind": "jacobian", "version": 1, )" + keys + "}");
  return read_parallel_drive(io::read_document(file, "jacobian"));
}

// Oracle: the numbers as written, row by row.
TEST(JacobianDocument, KeepsItsOrder) {
  const std::string names = R"("joints": ["p", "r"], "actuators": ["a", "b"])";
  const ParallelDrive constant = jacobian_of(names + R"(, "matrix": [[1, 2], [3, 5]])");
  EXPECT_EQ(constant.name, "j");  // the file's
  EXPECT_EQ(constant.joints, (std::array<std::string, 2>{"p", "r"}));
  EXPECT_EQ(constant.actuators, (std::array<std::string, 2>{"a", "b"}));
  ASSERT_TRUE(constant.is_constant());
  EXPECT_EQ(constant.matrices, (std::vector<Matrix2>{{1, 2, 3, 5}}));
  const ParallelDrive table = jacobian_of(names + R"(, "name": "ankle", "table": {
      "first_angle_rad": [0, 1], "second_angle_rad": [-1, 0, 2], "matrices": [[[1,0],[0,1]],
      [[2,0],[0,1]], [[3,0],[0,1]], [[4,0],[0,1]], [[5,0],[0,1]], [[6,0],[0,1]]]})");
  EXPECT_EQ(table.name, "ankle");
  EXPECT_EQ(table.first_rad, (std::vector<double>{0, 1}));
  EXPECT_EQ(table.second_rad, (std::vector<double>{-1, 0, 2}));
  ASSERT_EQ(table.matrices.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(table.matrices[i][0], static_cast<double>(i + 1));
}

TEST(JacobianDocument, RefusesWithThePath) {
  const std::string names = R"("joints": ["p", "r"], "actuators": ["a", "b"])";
  EXPECT_EQ(faults_of_jacobian(names),
            "j.json: needs either \"matrix\" (constant) or \"table\" (over both angles)");
  EXPECT_EQ(faults_of_jacobian(
                R"("joints": ["p", "p"], "actuators": ["a", "b"], "matrix": [[1,0],[0,1]])"),
            "j.json#/joints/1: \"p\" stands twice");
  EXPECT_EQ(faults_of_jacobian(names + R"(, "matrix": [[1,0],[0,1]], "table": {
                "first_angle_rad": [0, 1], "second_angle_rad": [0, 1], "matrices": [[[1,0],[0,1]],
                [[1,0],[0,1]], [[1,0],[0,1]], [[1,0],[0,1]]]})"),
            "j.json: needs either \"matrix\" (constant) or \"table\" (over both angles)");
  EXPECT_EQ(faults_of_jacobian(names + R"(, "table": {"first_angle_rad": [0, 1],
                "second_angle_rad": [0, 1], "matrices": [[[1,0],[0,1]], [[1,0],[0,1]],
                [[1,1],[1,1]], [[1,0],[0,1]]]})"),
            "j.json#/table/matrices/2: is singular: some joint torque could be carried by no "
            "actuator torques");
  EXPECT_EQ(
      faults_of_jacobian(names + R"(, "matrix": [[1,2],[2,4]])"),
      "j.json#/matrix: is singular: some joint torque could be carried by no actuator torques");
  const std::string one = "[[1,0],[0,1]]";
  const std::string four = "[" + one + "," + one + "," + one + "," + one + "]";
  EXPECT_EQ(faults_of_jacobian(names +
                               R"(, "table": {"first_angle_rad": [0, 0], "second_angle_rad": [0, 1],
                      "matrices": )" +
                               four + "}"),
            "j.json#/table/first_angle_rad: must ascend");
  EXPECT_EQ(faults_of_jacobian(names + R"(, "table": {"first_angle_rad": [0, 1, 2],
                      "second_angle_rad": [0, 1], "matrices": )" +
                               four + "}"),
            "j.json#/table/matrices: has 4 entries, the grid has 3 x 2 points");
}

TEST(JacobianDocument, ExamplesAreGood) {
  for (const char* name : {"parallel_ankle.json", "parallel_ankle_table.json"}) {
    const std::filesystem::path file =
        std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "specs/trajectory" / name;
    EXPECT_EQ(read_parallel_drive(io::read_document(file, "jacobian")).joints[0], "ankle_pitch");
  }
}

}  // namespace
}  // namespace torquewright::actuator
