// SPDX-License-Identifier: Apache-2.0
// `gearbox strength` as a user runs it: exit codes, both sides of a torque, and its JSON.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/documents/schema.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

const std::string kAnkle = in_repository("specs/gearbox/d110a_strength.json").string();

Outcome strength(std::vector<std::string> options) {
  options.insert(options.begin(), {"gearbox", "strength", kAnkle});
  return run(options);
}

TEST(Strength, ShowsATorqueOnBothSides) {
  const Outcome motor = strength({"--torque", "21"});
  EXPECT_EQ(motor.exit_code, 0);
  EXPECT_EQ(motor.err, "");
  EXPECT_NE(motor.out.find("\n21 Nm at the motor, 168 Nm at the joint: borne\n"), std::string::npos)
      << motor.out;
  EXPECT_EQ(strength({"--torque", "168", "--side", "joint"}).out, motor.out);
}

TEST(Strength, FailsWhereASafetyIsBelowTheDemandedOne) {
  const Outcome outcome = strength({"--torque", "17,60"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("\n17 Nm at the motor, 136 Nm at the joint: borne\n"),
            std::string::npos);
  EXPECT_NE(outcome.out.find("\n60 Nm at the motor, 480 Nm at the joint: below"),
            std::string::npos);
}

TEST(Strength, AsksForATorqueThatNoDocumentStates) {
  EXPECT_EQ(strength({}).exit_code, 2);
  EXPECT_EQ(strength({}).err,
            "--torque: missing; only a gearbox_result whose problem has a load states one\n");
}

// 132 teeth of 5 mm are a ring of 660 mm: no size of a gearbox for 79.4 mm.
TEST(Strength, SaysWhichSizesDoNotFit) {
  const std::string knee = in_repository("specs/gearbox/d151_knee_result.json").string();
  const Outcome outcome =
      run({"gearbox", "strength", knee, "--steel", "case_hardened", "--face-width", "10",
           "--torque", "16", "--modules", "0.5,5", "--json"});
  const json report = json::parse(outcome.out);
  ASSERT_EQ(report["other_sizes"].size(), 1u);
  ASSERT_EQ(report["left_out"].size(), 1u);
  EXPECT_EQ(report["left_out"][0],
            "module 5 mm: with the teeth 44/44/32/132/120 the roots of a ring lie on 672.5 mm, "
            "which does not fit into 79.4 mm");
}

TEST(Strength, GoesOverSizes) {
  const Outcome outcome = strength(
      {"--torque", "21,17", "--face-widths", "6,8,10,12", "--modules", "0.5,0.6,1", "--json"});
  EXPECT_EQ(outcome.exit_code, 0);
  const json report = json::parse(outcome.out);
  EXPECT_TRUE(io::conforms(report, "strength_report"));
  ASSERT_EQ(report["other_sizes"].size(), 8u);  // a module of 1 mm leaves too few teeth
  EXPECT_EQ(report["left_out"].size(), 1u);
  for (const json& size : report["other_sizes"]) {
    EXPECT_EQ(size["loadings"][0]["joint_torque_Nm"], 168.0);
    EXPECT_EQ(size["loadings"][1]["joint_torque_Nm"], 136.0);
  }
}

// More loads are borne less well; the document's number gives way to the option's.
TEST(Strength, TakesTheNumberOfLoads) {
  const auto life = [](const char* cycles) {
    const json report = json::parse(strength({"--torque", "21", "--json", "--cycles", cycles}).out);
    return report["gearbox"]["greatest_torque"]["for_cycles"]["motor_torque_Nm"].get<double>();
  };
  EXPECT_GT(life("1"), life("1000000"));
}

TEST(Strength, RefusesWhatIsNoLoad) {
  for (const auto& [option, value] :
       std::vector<std::pair<std::string, std::string>>{{"--torque", "0"},
                                                        {"--torque", "nan"},
                                                        {"--torque", "-21"},
                                                        {"--face-widths", "inf"},
                                                        {"--modules", "0"},
                                                        {"--cycles", "0.5"},
                                                        {"--cycles", "0"},
                                                        {"--cycles", "-0"},
                                                        {"--cycles", "1e-400"},
                                                        {"--load-sharing", "0"},
                                                        {"--load-sharing", "-0.0"}}) {
    std::vector<std::string> options{option, value};
    if (option != "--torque") options.insert(options.end(), {"--torque", "21"});
    const Outcome outcome = strength(options);
    EXPECT_EQ(outcome.exit_code, 2) << option << " " << value;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err, "");
  }
}

// Torques, face widths and modules multiply.
TEST(Strength, RefusesVeryManyRows) {
  const auto list = [](int count) {
    std::string numbers = "1";
    for (int i = 2; i <= count; ++i) numbers += "," + std::to_string(i);
    return numbers;
  };
  const Outcome outcome = strength({"--torque", list(101), "--face-widths", list(100)});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "--torque, --face-widths, --modules: 101 torques on 100 face widths of 1 modules are "
            "10100 rows; at most 10000\n");
  EXPECT_EQ(strength({"--torque", list(20), "--face-widths", list(20)}).exit_code, 0);
}

TEST(Strength, AsksForRoomWhereModulesAreTried) {
  const Workplace place;
  place.write("ankle.json", with(text_of(kAnkle), "\"rotor_inner_diameter_mm\": 90,", ""));
  const std::string document = with(place.text("ankle.json"), "\"/rotor_inner_diameter_mm\",", "");
  place.write("ankle.json", document);
  const Outcome outcome =
      place.run({"gearbox", "strength", "ankle.json", "--torque", "21", "--modules", "0.5"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "ankle.json#/rotor_inner_diameter_mm: missing; --modules chooses teeth that fit into "
            "it\n");
}

const std::string kResult = in_repository("specs/gearbox/d151_knee_result.json").string();

Outcome strength_of_result(std::vector<std::string> options) {
  options.insert(options.begin(), {"gearbox", "strength", kResult, "--torque", "16"});
  return run(options);
}

// Oracle: `gearbox strength` of the result, told the steel and the face width that are assumed.
TEST(StrengthOfAResult, StandsOnTheSearchesScreen) {
  const Workplace place;
  const std::string problem = in_repository("specs/gearbox/d151_knee.json").string();
  const std::string screen = place.run({"gearbox", "optimize", problem, "-o", "r.json"}).out;
  EXPECT_LE(std::count(screen.begin(), screen.end(), '\n'), 24) << screen;
  EXPECT_NE(screen.find("Assumed: steel case_hardened, face widths of 6 mm"), std::string::npos);
  const std::string told =
      place.run({"gearbox", "strength", "r.json", "--steel", "case_hardened", "--face-width", "6"})
          .out;
  const std::string bears = "the teeth bear ";
  const std::size_t begin = screen.find(bears);
  ASSERT_NE(begin, std::string::npos) << screen;
  const std::size_t number = begin + bears.size();
  const std::string joint_Nm = screen.substr(number, screen.find(' ', number) - number);
  const std::size_t loads = told.find("  10000 loads");
  ASSERT_NE(loads, std::string::npos) << told;
  EXPECT_NE(told.find(" " + joint_Nm + " Nm at the joint", loads), std::string::npos) << screen;
  const std::string all = place.run({"gearbox", "optimize", problem, "--all"}).out;
  EXPECT_NE(all.find("Bound that nothing beats: 17360.112"), std::string::npos);
}

// Oracle: the document of the same gearbox, steel aside, which states what is assumed here; the
// bending limits of the two steels are 430 and 425 MPa.
TEST(StrengthOfAResult, IsThatOfTheDocumentThatNamesIt) {
  const Outcome outcome =
      strength_of_result({"--steel", "case_hardened", "--face-width", "10", "--json"});
  EXPECT_EQ(outcome.err, "");
  const json report = json::parse(outcome.out);
  EXPECT_TRUE(io::conforms(report, "strength_report"));
  const std::string knee = in_repository("specs/gearbox/d151_strength.json").string();
  const json document =
      json::parse(run({"gearbox", "strength", knee, "--torque", "16", "--json"}).out);
  const json& gears = report["gearbox"]["loadings"][0]["gears"];
  const json& same = document["gearbox"]["loadings"][0]["gears"];
  ASSERT_EQ(gears.size(), 6U);
  for (std::size_t i = 0; i < gears.size(); ++i) {
    EXPECT_EQ(gears[i]["flank"], same[i]["flank"]);
    EXPECT_EQ(gears[i]["root"]["stress_MPa"], same[i]["root"]["stress_MPa"]);
    EXPECT_NEAR(gears[i]["root"]["life_limit_MPa"].get<double>() * 425.0,
                same[i]["root"]["life_limit_MPa"].get<double>() * 430.0, 1e-9 * 430.0 * 1000.0);
  }
  EXPECT_EQ(report["assumed"], json({"/factors", "/safety_factor", "/cycles"}));
  EXPECT_EQ(report["statements"].size(), 3U);
}

TEST(StrengthOfAResult, SaysWhatItTookFromWhere) {
  const Outcome outcome =
      strength_of_result({"--steel", "case_hardened", "--face-width", "10,8", "--cycles", "500"});
  EXPECT_NE(outcome.out.find("\nDesign 1 of 1 in "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\nSteel case_hardened: bending endurance 430 MPa"),
            std::string::npos);
  EXPECT_NE(outcome.out.find("K_gamma 1.25 (of 4 planets)"), std::string::npos);
  EXPECT_NE(outcome.out.find("face width 10 and 8 mm"), std::string::npos);
  EXPECT_EQ(outcome.out.find("(--cycles)"), std::string::npos);
}

TEST(StrengthOfAResult, RefusesWhatHoldsNoGearbox) {
  const auto refused = [](const Outcome& outcome, const std::string& words) {
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  refused(strength_of_result({"--face-width", "10"}),
          "says no steel; say --steel (case_hardened, ");
  const Outcome bare = strength_of_result({});
  refused(bare, "says no steel; say --steel (case_hardened, ");
  refused(bare, "#/problem/face_width_mm: missing; say --face-width MM");
  refused(strength_of_result({"--steel", "cheese", "--face-width", "10"}), "is not known; one of:");
  refused(strength_of_result({"--steel", "case_hardened"}), "missing; say --face-width MM");
  refused(strength_of_result({"--steel", "case_hardened", "--face-width", "1,2,3"}), "two layers");
  refused(strength_of_result({"--steel", "case_hardened", "--face-width", "10", "--design", "2"}),
          "--design 2 is not there; the number of designs is 1");
  refused(strength({"--torque", "21", "--steel", "case_hardened"}), "goes with a gearbox_result");
}

json loads_with(const std::vector<std::string>& more) {
  std::vector<std::string> options{"--steel", "case_hardened", "--face-width", "10", "--json"};
  options.insert(options.end(), more.begin(), more.end());
  const Outcome outcome = strength_of_result(options);
  EXPECT_EQ(outcome.err, "");
  const json report = json::parse(outcome.out);
  EXPECT_TRUE(io::conforms(report, "strength_report"));
  return report["gearbox"]["loadings"][0]["gears"];
}

// K_gamma is 1.25 of four planets where it is not stated; root stress goes with it.
TEST(StrengthOfAResult, TakesLoadSharingAndRims) {
  const json before = loads_with({});
  const json shared = loads_with({"--load-sharing", "1.5"});
  const json rimmed = loads_with({"--rim", "sun=1.35,output_ring=3"});
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double plain_MPa = before[i]["root"]["stress_MPa"].get<double>();
    EXPECT_NEAR(shared[i]["root"]["stress_MPa"].get<double>(), plain_MPa * 1.5 / 1.25, 1e-9 * 1e3);
    // One tooth height behind the sun: 1.6 ln(2.242); five modules behind the ring: nothing.
    const double factor = before[i]["gear"] == "sun" ? 1.6 * std::log(2.242) : 1.0;
    EXPECT_NEAR(rimmed[i]["rim_factor"].get<double>(), factor, 1e-5);
    EXPECT_NEAR(rimmed[i]["root"]["stress_MPa"].get<double>(), plain_MPa * factor, 1e-2);
  }
}

// The steels' own numbers: 1450 and 1500 MPa of contact endurance.
TEST(StrengthOfAResult, TakesASteelForEachGear) {
  const Outcome outcome =
      strength_of_result({"--steel", "case_hardened,output_ring=nitriding_steel_best",
                          "--face-width", "10", "--json", "--cycles", "1000000000"});
  EXPECT_EQ(outcome.err, "");
  const json report = json::parse(outcome.out);
  for (const json& gear : report["gearbox"]["loadings"][0]["gears"]) {
    EXPECT_EQ(gear["flank"]["life_limit_MPa"], gear["gear"] == "output_ring" ? 1450.0 : 1500.0);
  }
  const auto refused = [](const std::vector<std::string>& options, const std::string& words) {
    const Outcome bad = strength_of_result(options);
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_NE(bad.err.find(words), std::string::npos) << bad.err;
  };
  refused({"--steel", "sun=case_hardened", "--face-width", "10"}, "names no steel for planet_1");
  refused({"--steel", "case_hardened,moon=case_hardened", "--face-width", "10"}, "names no gear");
  refused({"--steel", "case_hardened", "--face-width", "10", "--rim", "sun=nan"}, "needs a length");
  refused({"--steel", "case_hardened", "--face-width", "10", "--rim", "sun=0.5"}, "too thin");
  refused({"--steel", "case_hardened", "--face-width", "10", "--rim", "sun=0x2"}, "needs a length");
  refused({"--steel", "case_hardened", "--face-width", "10", "--rim", "sun=2,sun=3"},
          "--rim: \"sun\" is given twice");
  refused({"--steel", "case_hardened", "--face-width", "10", "--load-sharing", "0.9"},
          "\"0.9\" is not a number from 1 to 10");
  refused({"--steel", "case_hardened", "--face-width", "10", "--load-sharing", "0"},
          "\"0\" is not a number from 1 to 10");
}

TEST(StrengthOfAResult, RefusesAResultThatIsInfeasible) {
  Workplace place;
  place.write("tight.json", tight_knee());
  place.write("knee.json", knee());
  ASSERT_EQ(place.run({"gearbox", "optimize", "tight.json", "-o", "none.json"}).exit_code, 1);
  ASSERT_EQ(
      place.run({"gearbox", "evaluate", "tight.json", "--teeth", "44,44,32", "-o", "bad.json"})
          .exit_code,
      1);
  const auto refusal = [&](const char* file) {
    const Outcome outcome = place.run({"gearbox", "strength", file, "--torque", "16", "--steel",
                                       "case_hardened", "--face-width", "10"});
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  EXPECT_EQ(refusal("none.json"),
            "none.json#/designs: holds no design: the problem is infeasible\n");
  EXPECT_EQ(refusal("bad.json"),
            "bad.json#/status: infeasible: its design violates the problem's constraints\n");
  EXPECT_NE(refusal("knee.json").find("gear_strength"), std::string::npos);
  // A document that names such a result: the same.
  const std::string document = text_of(in_repository("specs/gearbox/d151_strength.json").string());
  place.write("strength.json", with(document, "d151_knee_result.json", "bad.json"));
  const Outcome named = place.run({"gearbox", "strength", "strength.json", "--torque", "16"});
  EXPECT_EQ(named.exit_code, 2);
  EXPECT_EQ(named.err,
            "bad.json#/status: infeasible: its design violates the problem's constraints\n");
}

}  // namespace
}  // namespace torquewright::cli_test
