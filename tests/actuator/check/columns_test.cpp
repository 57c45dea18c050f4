// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/columns.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "actuator/trajectory/columns_spec.hpp"
#include "io/documents/document.hpp"
#include "tests/actuator/check/refusal.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

TEST(Columns, ReadTheWholeForm) {
  const ColumnMapping mapping = read_mapping("tau=2 [x]=left.knee.torque:mNm*-0.5");
  EXPECT_EQ(mapping.column, "tau=2 [x]");
  EXPECT_EQ(mapping.joint, "left.knee");
  EXPECT_EQ(mapping.quantity, Quantity::kTorque);
  EXPECT_DOUBLE_EQ(mapping.factor, -0.0005);
}

TEST(Columns, ReadUnitsTimesAndCanonicalNames) {
  EXPECT_DOUBLE_EQ(read_mapping("v=knee.velocity:deg/s").factor, std::numbers::pi / 180.0);
  EXPECT_DOUBLE_EQ(read_mapping("n=knee.velocity_rad_s:rpm*2").factor, std::numbers::pi / 15.0);
  EXPECT_EQ(read_mapping("stamp=time:ms").quantity, Quantity::kTime);
  EXPECT_DOUBLE_EQ(read_mapping("stamp=time:ms").factor, 0.001);
  EXPECT_EQ(canonical_mapping("left_knee_velocity_rad_s")->joint, "left_knee");
  for (const char* time : {"t", "time", "time_s"}) {
    const ColumnMapping mapping = canonical_mapping(time).value();
    EXPECT_EQ(mapping.quantity, Quantity::kTime);
    EXPECT_EQ(mapping.joint, "");
    EXPECT_EQ(mapping.factor, 1.0);
  }
  EXPECT_EQ(canonical_mapping("k_torque_Nm").value().factor, 1.0);
  EXPECT_FALSE(canonical_mapping("k_time_s").has_value());  // time is no joint's
  EXPECT_FALSE(canonical_mapping("_torque_Nm").has_value());
  EXPECT_FALSE(canonical_mapping("knee_torque").has_value());
}

struct MistakenColumn {
  const char* text;
  const char* why;
};

TEST(Columns, RefuseWithTheForm) {
  const MistakenColumn mistakes[] = {
      {"tau", "no NAME=JOINT.QUANTITY"},
      {"=knee.torque", "no NAME=JOINT.QUANTITY"},
      {"tau=", "no NAME=JOINT.QUANTITY"},
      {"tau=torque", "whose torque? JOINT.torque names it"},
      {"tau=.torque", "whose torque? JOINT.torque names it"},
      {"tau=knee.torqe",
       "\"torqe\" is no quantity (did you mean \"torque\"?); they are time, "
       "position, velocity or torque"},
      {"n=knee.time:ms", "time is no joint's; leave \"knee.\" out"},
      {"n=knee.time_s", "time is no joint's; leave \"knee.\" out"},
      {"tau=knee.torque*0", "the factor \"0\" is not a finite number other than 0"},
      {"tau=knee.torque*2x", "the factor \"2x\" is not a finite number other than 0"},
      {"tau=knee.torque*", "the factor \"\" is not a finite number other than 0"},
      {"tau=knee.torque:", "\"\" is no unit"},
      {"tau=knee.torque*nan", "the factor \"nan\" is not a finite number other than 0"},
      {"q=knee.position:rad/s", "\"rad/s\" is no unit of position, which must be rad, deg or rev"},
  };
  for (const MistakenColumn& mistake : mistakes) {
    EXPECT_EQ(test::refusal([&] { read_mapping(mistake.text); }),
              std::string("--column: \"") + mistake.text + "\": " + mistake.why +
                  "; the form is NAME=JOINT.QUANTITY[:unit][*factor]");
  }
}

std::string faults_of_columns(const std::string& columns) {
  const test::ScratchFolder folder;
  const auto file = folder.write(
      "c.json", R"({"kind": "trajectory_columns", "version": 1, "columns": )" + columns + "}");
  return test::refusal([&] { read_columns(io::read_document(file, "trajectory_columns")); },
                       folder.path());
}

TEST(ColumnsDocument, SaysTheSameAsTheOptions) {
  const test::ScratchFolder folder;
  const auto file =
      folder.write("c.json", R"({"kind": "trajectory_columns", "version": 1, "columns": [
        {"column": "F", "quantity": "force"},
        {"column": "stamp", "quantity": "time", "unit": "ms"},
        {"column": "tau", "joint": "knee", "quantity": "torque", "factor": 0.6},
        {"column": "q", "joint": "knee", "quantity": "position", "unit": "rev"},
        {"column": "w", "joint": "knee", "quantity": "velocity", "unit": "rpm", "factor": -1},
        {"column": "T", "joint": "knee", "quantity": "torque", "unit": "mNm"}]})");
  const auto mappings = read_columns(io::read_document(file, "trajectory_columns"));
  ASSERT_EQ(mappings.size(), 5u);  // forces are of whole-body motions
  EXPECT_DOUBLE_EQ(mappings[2].factor, 2.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(mappings[3].factor, -std::numbers::pi / 30.0);
  EXPECT_DOUBLE_EQ(mappings[4].factor, 0.001);
  EXPECT_EQ(mappings[0].factor, 0.001);
  EXPECT_EQ(mappings[1].joint, "knee");
  EXPECT_EQ(mappings[1].factor, 0.6);
}

TEST(ColumnsDocument, RefusesWithThePath) {
  EXPECT_EQ(faults_of_columns(R"([{"column": "a", "quantity": "torque"}])"),
            "c.json#/columns/0/joint: missing; whose quantity?");
  EXPECT_EQ(faults_of_columns(R"([{"column": "a", "quantity": "time", "joint": "k"}])"),
            "c.json#/columns/0/joint: time is no joint's; leave it out");
  EXPECT_EQ(
      faults_of_columns(R"([{"column": "a", "joint": "k", "quantity": "torque", "factor": 0}])"),
      "c.json#/columns/0/factor: 0 would leave nothing of the column");
  EXPECT_EQ(
      faults_of_columns(R"([{"column": "a", "joint": "k", "quantity": "torque", "unit": "deg"}])"),
      "c.json#/columns/0/unit: \"deg\" is no unit of torque, which must be Nm, mNm, kNm, Ncm, "
      "kgf_cm, ozf_in, lbf_in or lbf_ft");
}

TEST(ColumnsDocument, ExamplesAreGood) {
  for (const char* name : {"mini_cheetah_columns.json", "cassie_columns.json"}) {
    const std::filesystem::path file =
        std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "specs/trajectory" / name;
    EXPECT_FALSE(read_columns(io::read_document(file, "trajectory_columns")).empty());
  }
}

}  // namespace
}  // namespace torquewright::actuator
