// SPDX-License-Identifier: Apache-2.0
// Profile shifts and a second module on the command line: evaluation, drawing, strength, and what
// they refuse.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/documents/schema.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

/// Matsuki's bilateral drive (reference section 12).
const char* const kDrive = R"({"kind": "gearbox_problem", "version": 1, "name": "drive",
 "topology": "3k", "target_ratio": 96, "ratio_tolerance": 0.01, "rotor_inner_diameter_mm": 90,
 "module_mm": [0.8, 0.8467], "planet_count": 3, "min_teeth": {"sun": 12, "planet_1": 12,
 "planet_2": 12}, "min_carrier_clearance_rad": 0, "constraints": "buildable",
 "objective": "forward_efficiency", "friction_coefficient": 0.1})";

Outcome evaluate(Workplace& place, std::vector<std::string> options) {
  options.insert(options.begin(), {"gearbox", "evaluate", "drive.json", "--teeth", "12,39,32,90,81",
                                   "--module", "0.8"});
  return place.run(options);
}

const std::vector<std::string> kShifted{"--profile-shift", "0.476,0.762,0.536", "--layer-2-module",
                                        "0.8467"};

std::vector<std::string> with_more(std::vector<std::string> options,
                                   const std::vector<std::string>& more) {
  options.insert(options.end(), more.begin(), more.end());
  return options;
}

TEST(ShiftedDesign, IsEvaluatedAndWritten) {
  Workplace place;
  place.write("drive.json", kDrive);
  const Outcome outcome = evaluate(place, with_more(kShifted, {"--json"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_TRUE(io::conforms(result, "gearbox_result"));
  const json& design = result["designs"][0];
  EXPECT_NEAR(design["profile_shift"]["fixed_ring"].get<double>(), 2.0, 5e-4);
  EXPECT_EQ(design["layer_2_module_mm"], 0.8467);
  EXPECT_NEAR(design["centre_distance_mm"].get<double>(), 21.26791, 5e-6);
  EXPECT_TRUE(result["rank"].is_null());
  EXPECT_EQ(result["status"], "limit");  // nobody has looked for a better one
}

// The command without the options, and with shifts of nothing, say the same bytes.
TEST(ShiftedDesign, OfNoShiftIsThePlainOne) {
  Workplace place;
  place.write("knee.json", knee());
  const std::vector<std::string> plain{"gearbox", "evaluate", "knee.json", "--teeth", "44,44,32"};
  EXPECT_EQ(place.run(with_more(plain, {"--profile-shift", "0,0,0"})).out, place.run(plain).out);
  EXPECT_EQ(place.run(with_more(plain, {"--layer-2-module", "0.6", "--json"})).out,
            place.run(with_more(plain, {"--json"})).out);
}

TEST(ShiftedDesign, RefusesWhatItCannotDo) {
  Workplace place;
  place.write("drive.json", kDrive);
  const auto refused = [&](const std::vector<std::string>& options, const std::string& words) {
    const Outcome outcome = evaluate(place, options);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  refused({"--profile-shift", "0.1,0.2"}, "has 2 numbers; 3k takes 3");
  refused({"--profile-shift", "-1,-1,0"}, "leave no working angle");
  refused({"--profile-shift", "nan,0,0"}, "");
  refused(with_more(kShifted, {"--rank"}), "the search knows gears without profile shift");
}

TEST(ShiftedDesign, OffersTheShiftThatCloses) {
  Workplace place;
  place.write("drive.json", kDrive);
  const Outcome outcome = evaluate(
      place, {"--profile-shift", "0.476,0.762,0.536,1.9,1.209", "--layer-2-module", "0.8467"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("needs the shift 2.000000"), std::string::npos) << outcome.out;
}

TEST(ShiftedDesign, IsDrawnWithItsShifts) {
  Workplace place;
  place.write("drive.json", kDrive);
  ASSERT_EQ(evaluate(place, with_more(kShifted, {"--draw", "drive.svg"})).exit_code, 0);
  const std::string svg = place.text("drive.svg");
  EXPECT_NE(svg.find("profile shift S 0.476, P1 0.762, P2 0.536, F 2, O 1.209 module"),
            std::string::npos);
  EXPECT_NE(svg.find("(layer 2: 0.8467 mm)"), std::string::npos);
  EXPECT_EQ(svg.find("no common centre distance"), std::string::npos);
  EXPECT_EQ(svg.find("cannot exist"), std::string::npos);
}

// Strength takes the shifts of a result: its forces are those of the evaluation at that load, which
// need not be said again.
TEST(ShiftedDesign, IsLoadedAsItWasEvaluated) {
  Workplace place;
  place.write("drive.json",
              with(kDrive, "\"friction_coefficient\": 0.1",
                   "\"friction_coefficient\": 0.1, \"load\": {\"output_torque_Nm\": 50}"));
  ASSERT_EQ(evaluate(place, with_more(kShifted, {"-o", "result.json"})).exit_code, 0);
  const json evaluated = json::parse(place.text("result.json"));
  const Outcome outcome =
      place.run({"gearbox", "strength", "result.json", "--torque", "50", "--side", "joint",
                 "--steel", "case_hardened", "--face-width", "10", "--json"});
  EXPECT_EQ(outcome.err, "");
  const json report = json::parse(outcome.out);
  EXPECT_TRUE(io::conforms(report, "strength_report"));
  const json& gears = report["gearbox"]["loadings"][0]["gears"];
  const json& meshes = evaluated["designs"][0]["meshes"];
  for (std::size_t mesh = 0; mesh < 3; ++mesh) {
    EXPECT_NEAR(gears[2 * mesh]["tangential_force_N"].get<double>(),
                meshes[mesh]["tangential_force_N"].get<double>(), 1e-9 * 500);
  }
  const Outcome unasked = place.run({"gearbox", "strength", "result.json", "--steel",
                                     "case_hardened", "--face-width", "10", "--json"});
  const json by_load = json::parse(unasked.out);
  EXPECT_EQ(by_load["gearbox"], report["gearbox"]);
  EXPECT_EQ(by_load["statements"].back(),
            "The torque is the load of its problem, 50 Nm at the joint (--torque).");
}

}  // namespace
}  // namespace torquewright::cli_test
