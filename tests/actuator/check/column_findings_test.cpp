// SPDX-License-Identifier: Apache-2.0
// Columns that a check does not read, or reads in another unit than they are named in. Oracle: the
// headers, by eye.
#include "actuator/check/column_findings.hpp"

#include <gtest/gtest.h>

#include "tests/actuator/check/simple_actuator.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

class ColumnFindings : public testing::Test {
 protected:
  /// Of joint knee; the sentences, one a line.
  std::string notes(const std::string& header, const std::vector<std::string>& mappings = {}) {
    CheckRequest request;
    request.trajectory = folder_.write("m.csv", header + "\n");
    request.drives = {{"knee", &actuator_, {}}};
    for (const std::string& mapping : mappings) request.columns.push_back(read_mapping(mapping));
    std::string lines;
    for (const Finding& finding : column_findings(request)) {
      EXPECT_EQ(finding.severity, Severity::kNote);
      lines += finding.rule + ": " + finding.sentence + "\n";
    }
    return lines;
  }

 private:
  test::ScratchFolder folder_;
  Actuator actuator_ = test::simple_actuator();
};

TEST_F(ColumnFindings, NameWhatIsNotReadAndWhatItIsNear) {
  EXPECT_EQ(notes("time_s,knee_velocity_rad_s,label,knee_torqe_Nm"),
            "columns-unread: not read: \"knee_torqe_Nm\" (is near knee_torque_Nm, which is "
            "missing), \"label\"; --column says what a column is\n");
  EXPECT_EQ(notes("time_s,knee_velocity_rad_s,kneee_torque_Nm"),
            "columns-unread: not read: \"kneee_torque_Nm\" (is near knee_torque_Nm, which is "
            "missing); --column says what a column is\n");
}

TEST_F(ColumnFindings, AreNoneWhereAllIsRead) {
  EXPECT_EQ(notes("t,knee_position_rad,knee_velocity_rad_s,knee_torque_Nm"), "");
  EXPECT_EQ(notes("time_s,knee_velocity_rad_s,tau", {"tau=knee.torque"}), "");
  // A log of a whole robot, of which one joint is checked.
  EXPECT_EQ(notes("time_s,knee_position_rad,hip_position_rad,hip_torque_Nm"), "");
}

TEST_F(ColumnFindings, NameTheColumnThatAStatedOneReplaces) {
  EXPECT_EQ(notes("time_s,knee_velocity_rad_s,knee_torque_Nm,tau", {"tau=knee.torque"}),
            "columns-unread: not read: \"knee_torque_Nm\"; --column says what a column is\n");
}

TEST_F(ColumnFindings, AreNotLongerThanOneReads) {
  std::string header = "time_s,knee_velocity_rad_s";
  for (int i = 0; i < 21; ++i) header += ",c" + std::to_string(i);
  const std::string long_note = notes(header);
  EXPECT_NE(long_note.find("\"c19\", ...;"), std::string::npos) << long_note;
}

TEST_F(ColumnFindings, NameAUnitThatContradictsTheName) {
  const std::string header = "time_s,knee_velocity_rad_s,knee_torque_Nm";
  EXPECT_EQ(notes(header, {"knee_torque_Nm=knee.torque:mNm"}),
            "column-unit: \"knee_torque_Nm\" is read in mNm, as is stated, though its name ends "
            "in Nm\n");
  EXPECT_EQ(notes(header, {"knee_velocity_rad_s=knee.velocity:deg/s"}),
            "column-unit: \"knee_velocity_rad_s\" is read in deg/s, as is stated, though its name "
            "ends in rad/s\n");
  EXPECT_EQ(notes(header, {"knee_torque_Nm=knee.torque:Nm*-1"}), "");
  EXPECT_EQ(notes(header, {"knee_torque_Nm=knee.torque*1.2"}), "");
  EXPECT_EQ(notes("time_ms,knee_velocity_rad_s", {"time_ms=time:ms"}), "");
}

}  // namespace
}  // namespace torquewright::actuator
