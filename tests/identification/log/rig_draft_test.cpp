// SPDX-License-Identifier: Apache-2.0
// A rig drafted from a log. Oracle: logs that are written here by closed form in known units, so
// that a velocity's unit follows from the derivative of its position.
#include "identification/draft/rig_draft.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "identification/draft/column_words.hpp"
#include "io/faults/spec_error.hpp"
#include "tests/actuator/check/refusal.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::identification::rig_draft_test {
namespace {

constexpr double kStep_s = 0.002;
constexpr double kRadPerSecondInRpm = 30.0 / std::numbers::pi;

double angle_rad(double t_s) { return 2.0 * std::sin(3.0 * t_s) + 5.0 * t_s; }
double speed_rad_s(double t_s) { return 6.0 * std::cos(3.0 * t_s) + 5.0; }
double current_A(double t_s) { return 4.0 * std::sin(7.0 * t_s); }

/// A log of 3 s with this header; a function of the time gives the cells of a row.
RigDraft drafted(const std::string& header, const std::function<std::string(double)>& row) {
  const test::ScratchFolder folder;
  std::string text = header + "\n";
  for (int i = 0; i < 1500; ++i) text += row(i * kStep_s) + "\n";
  return draft_rig(folder.write("log.csv", text));
}

const ColumnGuess& guess_of(const RigDraft& draft, const std::string& column) {
  for (const ColumnGuess& each : draft.columns) {
    if (each.column == column) return each;
  }
  ADD_FAILURE() << column;
  return draft.columns.front();
}

std::string taken_for(const RigDraft& draft, const std::string& column) {
  const ColumnGuess& guess = guess_of(draft, column);
  if (!guess.quantity) return "";
  return fmt::format("{} {}", name_of(*guess.quantity), guess.unit ? guess.unit->name : "-");
}

TEST(RigDraft, TakesNamesWithUnitsAsTheyAre) {
  const RigDraft draft =
      drafted("t_ms,q_deg,motor_speed_rpm,i_q [mA],tau_sensor_Nm,vbus_V,note", [](double t_s) {
        return fmt::format(
            "{},{},{},{},{},48,0", 1e3 * t_s, angle_rad(t_s) * 180.0 / std::numbers::pi,
            10.0 * speed_rad_s(t_s) * kRadPerSecondInRpm, 1e3 * current_A(t_s), std::sin(t_s));
      });
  EXPECT_EQ(taken_for(draft, "t_ms"), "time_s ms");
  EXPECT_EQ(taken_for(draft, "q_deg"), "output_position_rad deg");
  EXPECT_EQ(taken_for(draft, "motor_speed_rpm"), "motor_velocity_rad_s rpm");
  EXPECT_EQ(taken_for(draft, "i_q [mA]"), "motor_current_A mA");
  EXPECT_EQ(taken_for(draft, "tau_sensor_Nm"), "output_torque_Nm Nm");
  EXPECT_EQ(taken_for(draft, "vbus_V"), "bus_voltage_V V");
  EXPECT_EQ(taken_for(draft, "note"), "");
  EXPECT_TRUE(guess_of(draft, "q_deg").is_sure);
  EXPECT_TRUE(draft.is_dynamometer);
  EXPECT_TRUE(draft.joints.empty());
}

// A unit that contradicts the name, one that says whose ampere it is, a temperature of the
// electronics and counts: none of them passes for certain.
TEST(RigDraft, MarksWhatIsNotCertain) {
  const RigDraft draft =
      drafted("time_s,velocity_rad_s [rpm],Motor Current (Arms),FET_temp (degC),enc_counts",
              [](double t_s) {
                return fmt::format("{},{},{},40,{}", t_s, speed_rad_s(t_s) * kRadPerSecondInRpm,
                                   current_A(t_s), std::floor(1000.0 * angle_rad(t_s)));
              });
  EXPECT_EQ(taken_for(draft, "velocity_rad_s [rpm]"), "output_velocity_rad_s rpm");
  EXPECT_FALSE(guess_of(draft, "velocity_rad_s [rpm]").is_sure);
  EXPECT_NE(guess_of(draft, "velocity_rad_s [rpm]").why.find("rad/s stands there too"),
            std::string::npos);
  EXPECT_EQ(taken_for(draft, "Motor Current (Arms)"), "motor_current_A A");
  EXPECT_FALSE(guess_of(draft, "Motor Current (Arms)").is_sure);
  EXPECT_EQ(words_of("Phase Current RMS [A]", "").ampere, "rms");
  EXPECT_EQ(words_of("Speed RMS [rpm]", "").ampere, "");
  EXPECT_EQ(taken_for(draft, "FET_temp (degC)"), "");
  EXPECT_EQ(taken_for(draft, "enc_counts"), "");
}

TEST(RigDraft, ReadsALoggersGermanWithItsUnits) {
  const RigDraft draft =
      drafted("Zeit;Drehzahl;Drehmoment;Strom;Winkel\ns;1/min;N\u00b7m;A;\u00b0", [](double t_s) {
        return fmt::format("{};{};{};{};{}", t_s, speed_rad_s(t_s) * kRadPerSecondInRpm,
                           std::sin(t_s), current_A(t_s),
                           angle_rad(t_s) * 180.0 / std::numbers::pi);
      });
  EXPECT_EQ(taken_for(draft, "Zeit"), "time_s s");
  EXPECT_EQ(taken_for(draft, "Drehzahl"), "output_velocity_rad_s rpm");
  EXPECT_EQ(taken_for(draft, "Drehmoment"), "output_torque_Nm Nm");
  EXPECT_EQ(taken_for(draft, "Strom"), "motor_current_A A");
  EXPECT_EQ(taken_for(draft, "Winkel"), "output_position_rad deg");
}

// Names say what, and nothing says in what: microseconds by their step, rpm and the sign by the
// derivative of the position.
TEST(RigDraft, FindsUnitsAndASignByTheNumbers) {
  const RigDraft draft = drafted("stamp,position,velocity,current", [](double t_s) {
    return fmt::format("{},{},{},{}", 1e6 * t_s, angle_rad(t_s),
                       -speed_rad_s(t_s) * kRadPerSecondInRpm, current_A(t_s));
  });
  EXPECT_EQ(taken_for(draft, "stamp"), "time_s us");
  EXPECT_EQ(taken_for(draft, "velocity"), "output_velocity_rad_s rpm");
  EXPECT_TRUE(guess_of(draft, "velocity").is_reversed);
  EXPECT_FALSE(guess_of(draft, "velocity").is_sure);
  EXPECT_FALSE(draft.is_dynamometer);
  EXPECT_EQ(draft.open.size(), 2u);  // The encoder's side, and the load.
}

// An angle that jumps back at 360 is in degrees, and so is its velocity's unit told beside it.
TEST(RigDraft, TellsDegreesByTheirJumps) {
  const RigDraft draft = drafted("time,angle,speed", [](double t_s) {
    return fmt::format("{},{},{}", t_s, std::fmod(angle_rad(t_s) * 180.0 / std::numbers::pi, 360.0),
                       speed_rad_s(t_s));
  });
  EXPECT_EQ(taken_for(draft, "angle"), "output_position_rad deg");
}

// A column without a name that says so, which only grows in even steps, is the time; a counter that
// begins again is none.
TEST(RigDraft, TellsTimeByItsNumbers) {
  const RigDraft draft = drafted("x,q_rad,i_A", [](double t_s) {
    return fmt::format("{},{},{}", 12.5 + t_s, angle_rad(t_s), current_A(t_s));
  });
  EXPECT_EQ(taken_for(draft, "x"), "time_s s");
  const RigDraft without = drafted("x,q_rad,i_A", [](double t_s) {
    return fmt::format("{},{},{}", std::fmod(t_s, 1.0), angle_rad(t_s), current_A(t_s));
  });
  EXPECT_EQ(taken_for(without, "x"), "");
}

// Two runs of which each begins at 0: the column that changes there names them, whatever it is
// called; one that changes elsewhere too does not, and then the draft says where time begins again.
TEST(RigDraft, TellsRunsByWhereTimeBeginsAgain) {
  const auto log = [](double changes_after_s) {
    return drafted("Test,t_s,q_rad,i_A", [changes_after_s](double t_s) {
      return fmt::format("{},{},{},{}", t_s < changes_after_s ? "T1" : "T2", std::fmod(t_s, 1.5),
                         angle_rad(t_s), current_A(t_s));
    });
  };
  EXPECT_EQ(taken_for(log(1.5), "Test"), "run -");
  EXPECT_FALSE(guess_of(log(1.5), "Test").is_sure);
  const RigDraft other = log(1.0);
  EXPECT_EQ(taken_for(other, "Test"), "");
  EXPECT_EQ(other.unnamed_run, 750u);
  EXPECT_NE(other.open.front().find("row 751"), std::string::npos) << other.open.front();
}

// A driver's torque is its constant times the current, to the last digit; a sensor's is not.
TEST(RigDraft, TellsADriversTorqueFromASensors) {
  const auto log = [](double noise_Nm) {
    return drafted("t_s,q_rad,i_A,tau_Nm", [noise_Nm](double t_s) {
      return fmt::format("{},{},{},{}", t_s, angle_rad(t_s), current_A(t_s),
                         0.9 * current_A(t_s) + noise_Nm * std::sin(500.0 * t_s));
    });
  };
  EXPECT_EQ(taken_for(log(0.0), "tau_Nm"), "reported_torque_Nm Nm");
  EXPECT_EQ(taken_for(log(0.05), "tau_Nm"), "output_torque_Nm Nm");
}

TEST(RigDraft, TellsJointsByWhatIsLeftOfTheirNames) {
  const RigDraft draft = drafted(
      "time_s,FL_hip_rad,FL_calf_rad,FL_hip_commanded_rad,"
      "FL_calf_commanded_rad,FL_hip_rad_s,foot_force",
      [](double t_s) {
        return fmt::format("{0},{1},{1},{1},{1},{2},3", t_s, angle_rad(t_s), speed_rad_s(t_s));
      });
  EXPECT_EQ(draft.joints, (std::vector<std::string>{"FL_calf", "FL_hip"}));
  EXPECT_EQ(guess_of(draft, "FL_calf_commanded_rad").joint, "FL_calf");
  EXPECT_EQ(taken_for(draft, "FL_calf_commanded_rad"), "commanded_position_rad rad");
  EXPECT_EQ(taken_for(draft, "FL_hip_rad_s"), "output_velocity_rad_s rad/s");
  EXPECT_EQ(taken_for(draft, "foot_force"), "");
}

// The second position stays out and says beside which.
TEST(RigDraft, TakesOneColumnForAQuantity) {
  const RigDraft draft = drafted("t_s,q_rad,angle_rad,i_A", [](double t_s) {
    return fmt::format("{},{},{},{}", t_s, angle_rad(t_s), angle_rad(t_s), current_A(t_s));
  });
  EXPECT_EQ(taken_for(draft, "q_rad"), "output_position_rad rad");
  EXPECT_EQ(taken_for(draft, "angle_rad"), "");
  EXPECT_NE(guess_of(draft, "angle_rad").why.find("q_rad is taken"), std::string::npos);
}

TEST(RigDraft, RefusesALogOfWhichNothingIsKnown) {
  const test::ScratchFolder folder;
  const auto log = folder.write("log.csv", "apples,pears\n1,2\n2,1\n");
  const std::string refusal = test::refusal([&] { draft_rig(log); }, folder.path());
  EXPECT_NE(refusal.find("none of its columns (apples, pears) is known"), std::string::npos)
      << refusal;
}

}  // namespace
}  // namespace torquewright::identification::rig_draft_test
