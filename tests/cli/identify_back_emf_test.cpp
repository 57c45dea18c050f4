// SPDX-License-Identifier: Apache-2.0
// A motor whose back-EMF constant is another than its torque constant, from a document that states
// neither apart, on a dynamometer with a torque sensor. Oracle: what was put in.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test::back_emf {
namespace {

using nlohmann::json;

constexpr double kFactor = 1.15;
const char* const kNominal = "specs/actuator/d151_knee.json";

const json kRig = {{"kind", "rig"},
                   {"version", 1},
                   {"name", "with the winding's voltage"},
                   {"columns",
                    {{"run", "run"},
                     {"t_s", "time_s"},
                     {"q_rad", "output_position_rad"},
                     {"i_A", "motor_current_A"},
                     {"v_V", "winding_voltage_V"},
                     {"tau_Nm", "output_torque_Nm"}}},
                   {"load", {{"type", "dynamometer"}}}};

/// The report on a log of a motor with this in its document, and whether it was refined.
struct Found {
  json report;
  bool is_refined = false;
};

Found found(const char* key, double value) {
  const Workplace place;
  json truth = json::parse(text_of(in_repository(kNominal)));
  truth["motor"][key] = value;
  place.write("truth.json", truth.dump());
  place.write("rig.json", kRig.dump());
  const Outcome played = place.run(
      {"identify", "simulate", "truth.json", "--rig", "rig.json", "--excitation",
       in_repository("specs/excitation/knee_sweep.csv"), "--noise", "output_torque_Nm=0.2",
       "--noise", "winding_voltage_V=0.05", "--seed", "7", "-o", "log.csv"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  const Outcome said = place.run({"identify", "log.csv", "--rig", "rig.json", "--actuator",
                                  in_repository(kNominal), "--refined", "refined.json", "--json"});
  return {json::parse(said.out), place.has("refined.json")};
}

const json* constant_by(const json& report, const char* equation) {
  for (const json& added : report["effects_added"]) {
    if (added["equation"] == equation && added["effect"] == "torque_constant_error") return &added;
  }
  return nullptr;
}

TEST(IdentifyBackEmf, ApartFromTheTorqueConstantIsNotWrittenAsIt) {
  const Found apart = found("back_emf_constant_V_s_rad", kFactor * 0.32);
  EXPECT_EQ(apart.report["verdict"], "cannot_tell");
  EXPECT_FALSE(apart.is_refined);
  EXPECT_EQ(constant_by(apart.report, "output_torque_Nm"), nullptr);
  const json* voltage = constant_by(apart.report, "winding_voltage_V");
  ASSERT_NE(voltage, nullptr);
  EXPECT_EQ((*voltage)["certain"], false);
  EXPECT_NE((*voltage)["doubt"].get<std::string>().find("back_emf_constant_V_s_rad"),
            std::string::npos);
}

TEST(IdentifyBackEmf, ThatIsTheTorqueConstantIsWrittenOnce) {
  const Found both = found("torque_constant_Nm_A", kFactor * 0.32);
  EXPECT_TRUE(both.is_refined);
  for (const char* equation : {"output_torque_Nm", "winding_voltage_V"}) {
    const json* constant = constant_by(both.report, equation);
    ASSERT_NE(constant, nullptr) << equation;
    EXPECT_EQ((*constant)["certain"], true) << equation;
    EXPECT_NEAR((*constant)["parameters"]["factor"].get<double>(), kFactor, 0.01) << equation;
  }
}

}  // namespace
}  // namespace torquewright::cli_test::back_emf
