// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/trajectory_reader.hpp"

#include <gtest/gtest.h>

#include "tests/actuator/check/refusal.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

struct Read {
  std::vector<Row> rows;
  std::string refusal;
};

Read read(const std::string& text, const std::vector<std::string>& mappings,
          const std::vector<std::string>& joints, const Window& window = {}) {
  const test::ScratchFolder folder;
  const auto file = folder.write("m.csv", text);
  Read result;
  result.refusal = test::refusal(
      [&] {
        std::vector<ColumnMapping> columns;
        for (const std::string& mapping : mappings) columns.push_back(read_mapping(mapping));
        TrajectoryReader reader(file, columns, joints, window);
        Row row;
        while (reader.next(row)) result.rows.push_back(row);
      },
      folder.path());
  return result;
}

TEST(TrajectoryReader, FindsCanonicalColumnsInAnyOrder) {
  const Read result =
      read("b_torque_Nm,time_s,a_position_rad,b_velocity_rad_s,other\n5,0,1,3,x\n6,0.5,2,4,y\n", {},
           {"a", "b"});
  EXPECT_EQ(result.refusal, "");
  ASSERT_EQ(result.rows.size(), 2u);
  EXPECT_EQ(result.rows[1].time_s, 0.5);
  EXPECT_EQ(result.rows[1].values, (std::vector<double>{2, 0, 0, 0, 0, 4, 6, 0}));
}

TEST(TrajectoryReader, PrefersMappingsAndAppliesThem) {
  const Read result = read("stamp,w,k_velocity_rad_s,tau2\n0,60,9,10\n1000,120,9,20\n",
                           {"stamp=time:ms", "w=k.velocity:rpm", "tau2=k.torque*0.5"}, {"k"});
  EXPECT_EQ(result.refusal, "");
  ASSERT_EQ(result.rows.size(), 2u);
  EXPECT_EQ(result.rows[1].time_s, 1.0);
  EXPECT_DOUBLE_EQ(result.rows[0].values[kVelocityAt], 2.0 * 3.14159265358979323846);
  EXPECT_EQ(result.rows[1].values[kTorqueAt], 10.0);
}

// A column whose name says degrees is neither read as radians nor left aside.
TEST(TrajectoryReader, RefusesANameThatSaysAnotherUnit) {
  const std::string text = "time_s,k_position_rad,k_velocity_deg_s,k_torque_Nm\n0,0,90,1\n";
  const std::string why =
      "the column \"k_velocity_deg_s\" says deg/s; state its unit, --column "
      "k_velocity_deg_s=k.velocity:deg/s";
  EXPECT_NE(read(text, {}, {"k"}).refusal.find(why), std::string::npos);
  EXPECT_NE(read(text, {"k_velocity_deg_s=k.velocity"}, {"k"}).refusal.find(why),
            std::string::npos);
  EXPECT_EQ(read(text, {}, {"k_velocity"}).refusal.find(why), std::string::npos);
  const Read stated = read(text, {"k_velocity_deg_s=k.velocity:deg/s"}, {"k"});
  EXPECT_EQ(stated.refusal, "");
  EXPECT_DOUBLE_EQ(stated.rows.at(0).values[kVelocityAt], 0.5 * 3.14159265358979323846);
  EXPECT_EQ(read(text, {"k_velocity_deg_s=k.velocity:rad/s"}, {"k"}).refusal, "");
}

// However it is written: a torque 1000 times too great fails every drive.
TEST(TrajectoryReader, RefusesAForeignUnitInBracketsToo) {
  for (const std::string name : {"tau [mNm]", "tau(N*mm)", "tau / mNm", "tau_mNm"}) {
    const std::string text = "t,w," + name + "\n0,1,2000\n";
    const std::vector<std::string> bare = {"w=k.velocity", name + "=k.torque"};
    EXPECT_NE(read(text, bare, {"k"}).refusal.find("says mNm; state its unit"), std::string::npos)
        << name;
    const Read stated = read(text, {"w=k.velocity", name + "=k.torque:mNm"}, {"k"});
    EXPECT_EQ(stated.rows.at(0).values.at(kTorqueAt), 2.0) << name;
  }
  const std::string in_SI = "time [s],w [rad/s],tau [Nm],load [mNm]\n0,1,2,3\n";
  EXPECT_EQ(
      read(in_SI, {"time [s]=time", "w [rad/s]=k.velocity", "tau [Nm]=k.torque"}, {"k"}).refusal,
      "");
}

TEST(TrajectoryReader, WindowIncludesItsEnds) {
  const std::string text = "t,k_velocity_rad_s\n0,1\n0.1,2\n0.2,3\n0.3,4\n";
  const Read result = read(text, {}, {"k"}, {0.1, 0.2});
  ASSERT_EQ(result.rows.size(), 2u);
  EXPECT_EQ(result.rows[0].time_s, 0.1);
  EXPECT_EQ(result.rows[1].time_s, 0.2);
}

// A row counter "t" beside the time: neither is taken in silence, whichever stands first.
TEST(TrajectoryReader, RefusesTwoColumnsThatMayBeTheTime) {
  for (const std::string name : {"t", "time"}) {
    const std::string why = "m.csv: \"" + name +
                            "\" and \"time_s\" may both be the time; say which it is, --column "
                            "time_s=time:s or --column " +
                            name + "=time:s";
    const std::string before = name + ",time_s,k_velocity_rad_s\n3,0.5,1\n";
    const std::string behind = "time_s," + name + ",k_velocity_rad_s\n0.5,3,1\n";
    for (const std::string& text : {before, behind}) {
      EXPECT_EQ(read(text, {}, {"k"}).refusal, why);
      EXPECT_EQ(read(text, {"time_s=time:s"}, {"k"}).rows.at(0).time_s, 0.5);
      EXPECT_EQ(read(text, {name + "=time:ms"}, {"k"}).rows.at(0).time_s, 0.003);
    }
  }
  const auto refusal = [](const std::string& header) {
    return read(header + "\n0,0,1\n", {}, {"k"}).refusal;
  };
  EXPECT_NE(refusal("t,time,k_velocity_rad_s").find("\"t\" and \"time\" may both"),
            std::string::npos);
  EXPECT_NE(refusal("t,time_ms,k_velocity_rad_s").find("--column time_ms=time:ms or"),
            std::string::npos);
  EXPECT_EQ(refusal("t,time_to_fall,k_velocity_rad_s"), "");
  EXPECT_EQ(refusal("time_s,t_torque_Nm,k_velocity_rad_s"), "");
}

// What the command line maps is meant for this check; a document may describe a whole robot.
TEST(TrajectoryReader, RefusesAMappingOfAJointThatIsNotChecked) {
  const std::string text = "time_s,knee_velocity_rad_s,knee_torque_Nm\n0,1,2\n";
  EXPECT_EQ(read(text, {"knee_torque_Nm=kneee.torque*3"}, {"knee"}).refusal,
            "--column: \"knee_torque_Nm=kneee.torque*3\": no joint \"kneee\" is checked; did you "
            "mean \"knee\"?");
  const test::ScratchFolder folder;
  const ColumnMapping of_document{"knee_torque_Nm", "ankle", Quantity::kTorque, 3.0, true, ""};
  EXPECT_EQ(test::refusal([&] {
              TrajectoryReader(folder.write("m.csv", text), {of_document}, {"knee"}, {});
            }),
            "");
}

// A column that is said to be the ankle's is not the knee's as well, whatever it is called.
TEST(TrajectoryReader, TakesAMappedColumnByItsMappingAlone) {
  const std::string text =
      "time_s,knee_velocity_rad_s,ankle_velocity_rad_s,knee_torque_Nm\n0,1,2,3\n";
  const Read result = read(text, {"knee_torque_Nm=ankle.torque"}, {"knee", "ankle"});
  EXPECT_EQ(result.refusal, "");
  EXPECT_EQ(result.rows.at(0).values, (std::vector<double>{0, 1, 0, 0, 0, 2, 3, 0}));
  const Read both =
      read(text, {"knee_torque_Nm=ankle.torque", "knee_torque_Nm=knee.torque"}, {"knee", "ankle"});
  EXPECT_EQ(both.rows.at(0).values, (std::vector<double>{0, 1, 3, 0, 0, 2, 3, 0}));
}

struct MistakenRequest {
  std::string text;
  std::vector<std::string> mappings;
  std::vector<std::string> joints;
  std::string sentence;
};

TEST(TrajectoryReader, RefusesWithThePlace) {
  const std::string good = "time_s,left_knee_velocity_rad_s,left_knee_torque_Nm\n0,1,2\n";
  const MistakenRequest mistakes[] = {
      {good, {}, {"left_kne"}, "no joint \"left_kne\"; did you mean \"left_knee\"?"},
      {good, {}, {"ankle"}, "no joint \"ankle\"; there are left_knee"},
      {good,
       {"tau=k.torque"},
       {"k"},
       "no column \"tau\"; there are time_s, left_knee_velocity_rad_s, left_knee_torque_Nm"},
      {good, {"times=time"}, {"left_knee"}, "no column \"times\"; did you mean \"time_s\"?"},
      {"a,b,t\n1,2,3\n",
       {"a=k.torque", "b=k.torque"},
       {"k"},
       "\"a\" and \"b\" are both mapped to k.torque"},
      {"a,t\n1,3\n", {"a=k.torque", "a=k.torque*2"}, {"k"}, "\"a\" is mapped to k.torque twice"},
      {"a,t\n1,3\n",
       {"a=k.torque", "a=k.velocity"},
       {"k"},
       "\"a\" is mapped to k.torque and to k.velocity; one column is one quantity"},
      {"a,b,k_velocity_rad_s\n1,2,3\n",
       {"a=time", "b=time:ms"},
       {"k"},
       "\"a\" and \"b\" are both mapped to time"},
      {"time_s\n0\n", {}, {"k"}, "no joint \"k\""},
      {"time_s,k_torque_Nm\n0,1\n",
       {},
       {"k"},
       "joint \"k\" has neither k_position_rad nor k_velocity_rad_s; its torque alone cannot be "
       "checked"},
      {"stamp,k_velocity_rad_s\n0,1\n",
       {},
       {"k"},
       "no column time_s; name the time with --column NAME=time[:unit]"},
      {"time_s,k_velocity_rad_s\n0,1\n0.1,1\n0.1,1\n",
       {},
       {"k"},
       "line 4, column 1 (time_s): time repeats: 0.1 s follows 0.1 s of line 3"},
      {"time_s,k_velocity_rad_s\n0,1\n0.2,1\n0.1,1\n",
       {},
       {"k"},
       "line 4, column 1 (time_s): time runs backwards: 0.1 s follows 0.2 s of line 3"},
      {"time_s,k_velocity_rad_s\n0,1e300\n",
       {"k_velocity_rad_s=k.velocity*1e300"},
       {"k"},
       "line 2, column 2 (k_velocity_rad_s): too large in SI units, in which 1e+09 is the "
       "most; is its unit the one that is stated?"},
  };
  for (const MistakenRequest& mistake : mistakes) {
    EXPECT_EQ(read(mistake.text, mistake.mappings, mistake.joints).refusal,
              "m.csv: " + mistake.sentence);
  }
}

// Twenty names are listed, of more the first twenty.
TEST(TrajectoryReader, ListsManyNamesInPart) {
  std::string header = "t";
  std::string listed = "t";
  for (int i = 1; i < 20; ++i) {
    header += ",c" + std::to_string(100 + i);
    listed += ", c" + std::to_string(100 + i);
  }
  const std::string start = "m.csv: no column \"torque\"; there are ";
  EXPECT_EQ(read(header + "\n", {"torque=k.torque"}, {"k"}).refusal, start + listed);
  EXPECT_EQ(read(header + ",c200\n", {"torque=k.torque"}, {"k"}).refusal, start + listed + ", ...");
}

TEST(TrajectoryReader, ChecksTimeOutsideOfTheWindowToo) {
  const Read result = read("t,k_velocity_rad_s\n0,1\n1,1\n0.5,1\n", {}, {"k"}, {0.0, 0.1});
  EXPECT_NE(result.refusal.find("time runs backwards"), std::string::npos);
}

}  // namespace
}  // namespace torquewright::actuator
