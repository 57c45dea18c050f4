// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "identification/rig/rig.hpp"
#include "io/documents/document.hpp"
#include "tests/identification/log/written_log.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::json;

Rig read_file(const std::filesystem::path& file) {
  return read_rig(io::read_document(file, "rig"));
}

std::string refusal_of(const json& rig) {
  return test::refusal([&] { test::rig_of(rig); });
}

json plain() { return test::rig_json({{"t_s", "time_s"}, {"q_rad", "output_position_rad"}}); }

// Oracle: the definitions of the units. Of a temperature in degC, 0 is 273.15 K.
TEST(ReadRig, TakesColumnsInTheirUnits) {
  const auto use = [](const json& column) {
    json rig = plain();
    rig["columns"]["x"] = column;
    if (column["quantity"] == "time_s") rig["columns"].erase("t_s");
    for (const ColumnUse& each : test::rig_of(rig).columns) {
      if (each.column == "x") return each;
    }
    return ColumnUse{};
  };
  constexpr double kTurn = 2.0 * 3.14159265358979323846;
  struct Stated {
    const char* quantity;
    const char* unit;
    double scale, offset;
  };
  for (const Stated& stated :
       {Stated{"motor_velocity_rad_s", "rpm", kTurn / 60.0, 0.0},
        Stated{"output_velocity_rad_s", "deg/s", kTurn / 360.0, 0.0},
        Stated{"motor_position_rad", "deg", kTurn / 360.0, 0.0},
        Stated{"winding_temperature_K", "degC", 1.0, 273.15}, Stated{"time_s", "ms", 1e-3, 0.0},
        Stated{"motor_current_A", "mA", 1e-3, 0.0}, Stated{"output_torque_Nm", "mNm", 1e-3, 0.0},
        Stated{"bus_voltage_V", "mV", 1e-3, 0.0}}) {
    const ColumnUse found = use({{"quantity", stated.quantity}, {"unit", stated.unit}});
    EXPECT_DOUBLE_EQ(found.scale, stated.scale) << stated.unit;
    EXPECT_DOUBLE_EQ(found.offset, stated.offset) << stated.unit;
  }
  // 2 (column + 273.15) + 5
  const ColumnUse both =
      use({{"quantity", "case_temperature_K"}, {"unit", "degC"}, {"scale", 2.0}, {"offset", 5.0}});
  EXPECT_DOUBLE_EQ(both.scale, 2.0);
  EXPECT_DOUBLE_EQ(both.offset, 551.3);
}

TEST(ReadRig, RefusesUnitsOfAnotherKind) {
  json rig = plain();
  rig["columns"]["q_rad"] = {{"quantity", "output_position_rad"}, {"unit", "rpm"}};
  EXPECT_EQ(
      refusal_of(rig),
      "rig.json#/columns/q_rad/unit: \"rpm\" is no unit of output_position_rad, which must be "
      "rad, deg or rev");
  rig["columns"]["q_rad"] = "output_position_rad";
  rig["columns"]["d"] = {{"quantity", "duty"}, {"unit", "V"}};
  EXPECT_EQ(refusal_of(rig), "rig.json#/columns/d/unit: duty has no unit");
}

// The document of the contract (reference, 1.1), word for word.
TEST(ReadRig, ReadsTheContractsExample) {
  const Rig rig =
      test::rig_of(json::parse(R"({"kind": "rig", "version": 1, "name": "knee on the bench",
 "columns": {"t_s": "time_s", "i_A": "motor_current_A", "q_rad": "output_position_rad", "tau_Nm": "output_torque_Nm"},
 "ignore": ["note"],
 "load": {"type": "dynamometer"},
 "holdout_runs": ["step_70"],
 "uncertain": ["/load/inertia_kg_m2"]})"));
  EXPECT_EQ(rig.name, "knee on the bench");
  EXPECT_EQ(rig.columns.size(), 4u);
  EXPECT_EQ(rig.load.type, LoadType::kDynamometer);
  // A dynamometer has no such value: there is nothing to correct, and the log's findings say so.
  EXPECT_EQ(rig.uncertain, std::vector<std::string>{"/load/inertia_kg_m2"});
  EXPECT_EQ(rig.joints, std::vector<std::string>{""});
  EXPECT_EQ(rig.holdout_runs, std::vector<std::string>{"step_70"});
}

TEST(ReadRig, ReadsTheExamples) {
  const std::filesystem::path folder = TORQUEWRIGHT_SOURCE_DIR "/specs/rig";
  EXPECT_EQ(read_file(folder / "pendulum.json").load.type, LoadType::kPendulum);
  EXPECT_EQ(read_file(folder / "dynamometer_knee.json").load.type, LoadType::kDynamometer);
  EXPECT_EQ(read_file(folder / "free_flywheel.json").load.type, LoadType::kFree);
  const Rig arm = read_file(folder / "serial_arm.json");
  EXPECT_EQ(arm.joints, (std::vector<std::string>{"shoulder", "elbow"}));
  EXPECT_FALSE(arm.joints_by_columns);
}

json arm() {
  json rig = test::rig_json({{"t_s", "time_s"}});
  const json link = {
      {"mass_kg", 1}, {"length_m", 1}, {"center_of_mass_m", 0.5}, {"inertia_kg_m2", 0.1}};
  rig["load"] = {{"type", "serial_arm"}, {"links", {link, link}}};
  rig["columns"]["z"] = {{"quantity", "output_position_rad"}, {"joint", "shoulder"}};
  rig["columns"]["a"] = {{"quantity", "output_position_rad"}, {"joint", "elbow"}};
  return rig;
}

// The contract's links bear no names: the columns' order in the file tells which is which, and a
// JSON object in memory has forgotten it.
TEST(ReadRig, TakesJointsInTheOrderOfTheFilesColumns) {
  const test::ScratchFolder folder;
  const auto file = folder.write("arm.json", R"({"kind": "rig", "version": 1, "columns":
    {"t_s": "time_s", "z": {"quantity": "output_position_rad", "joint": "shoulder"},
     "a": {"quantity": "output_position_rad", "joint": "elbow"}},
    "load": {"type": "serial_arm", "links": [
     {"mass_kg": 1, "length_m": 1, "center_of_mass_m": 0.5, "inertia_kg_m2": 0.1},
     {"mass_kg": 2, "length_m": 1, "center_of_mass_m": 0.5, "inertia_kg_m2": 0.1}]}})");
  const Rig rig = read_file(file);
  EXPECT_EQ(rig.joints, (std::vector<std::string>{"shoulder", "elbow"}));
  EXPECT_TRUE(rig.joints_by_columns);
  EXPECT_NE(refusal_of(arm()).find("which joint moves each?"), std::string::npos);
}

TEST(ReadRig, RefusesJointsAndLinksThatDoNotMeet) {
  json rig = arm();
  rig["load"]["links"][0]["joint"] = "shoulder";
  EXPECT_NE(refusal_of(rig).find("some links name their \"joint\""), std::string::npos);
  rig["load"]["links"][1]["joint"] = "elbov";
  EXPECT_NE(refusal_of(rig).find("no link's joint is named \"elbow\"; did you mean \"elbov\"?"),
            std::string::npos);
  rig["load"]["links"][1]["joint"] = "shoulder";
  EXPECT_NE(refusal_of(rig).find("\"shoulder\" stands twice"), std::string::npos);
  rig["load"]["links"][1]["joint"] = "elbow";
  EXPECT_EQ(refusal_of(rig), "");
  rig["columns"]["i_A"] = "motor_current_A";
  EXPECT_NE(refusal_of(rig).find("which joint's?"), std::string::npos);
  rig["columns"]["i_A"] = "bus_voltage_V";
  EXPECT_EQ(refusal_of(rig), "");
}

struct Mistake {
  const char* patch;  ///< JSON merge patch on plain().
  std::string sentence;
};

TEST(ReadRig, RefusesWithThePlace) {
  for (
      const Mistake& mistake : std::vector<Mistake>{
          {R"({"columns": {"q_rad": "output_positon_rad"}})",
           R"(/columns/q_rad: "output_positon_rad" is no quantity; did you mean "output_position_rad"?)"},
          {R"({"columns": {"a/b": {"quantity": "speed"}}})", "/columns/a~1b/quantity: \"speed\""},
          {R"({"columns": {"q2": "output_position_rad"}})",
           R"(is output_position_rad as "q2" is; name one)"},
          {R"({"columns": {"q_rad": {"quantity": "output_position_rad", "scale": 0}}})",
           "/columns/q_rad/scale: 0 would leave nothing"},
          {R"({"columns": {"q_rad": {"quantity": "output_position_rad", "scale": -5e-324}}})",
           "/columns/q_rad/scale: 4.94066e-324 is less than 1e-15 in magnitude"},
          {R"({"columns": {"q_rad": {"quantity": "output_position_rad", "joint": "a"}}})",
           "only a serial_arm and a robot have several joints"},
          {R"({"columns": {"t_s": {"quantity": "time_s", "scale": -1}}})", "is negative; time"},
          {R"({"columns": {"r": {"quantity": "run", "offset": 1}}})", "neither scale nor offset"},
          {R"({"columns": {"q_rad": null, "t_s": null}})", "/columns: is empty"},
          {R"({"columns": {"t_s": null, "w": "output_velocity_rad_s"}})", "but one is a velocity"},
          {R"({"columns": {"t_s": null, "q_rad": "motor_current_A"}})", "and none is a position"},
          {R"({"ignore": ["q_rad"]})", "/ignore/0: \"q_rad\" stands under \"columns\" too"},
          {R"({"ignore": ["x", "x"]})", "/ignore/1: \"x\" stands twice"},
          {R"({"holdout_runs": ["x", "x"]})", "/holdout_runs/1: \"x\" stands twice"},
          {R"({"load": {"type": "pendulum", "mass_kg": 1, "inertia_kg_m2": 0}})",
           "/load/length_m: missing; a load of type \"pendulum\" needs it"},
          {R"({"load": {"mass_kg": 1}})",
           "/load/mass_kg: has no meaning for a load of type \"dynamometer\""},
          {R"({"load": {"type": "crane"}})", "/load/type: \"crane\" is not one of"},
          {R"({"load": {"type": "linear_axis", "mass_kg": 1}, "uncertain": ["/load/mass"]})",
           R"(/uncertain/0: "/load/mass" leads to no value; did you mean /load/mass_kg?)"},
          {R"({"uncertain": ["/motor/torque_constant_Nm"]})",
           "did you mean /motor/torque_constant_Nm_A?"},
          {R"({"uncertain": ["/motor/torque_constant_convention"]})", "leads to no value"},
          {R"({"uncertain": ["motor"]})", "leads to no value; must be a number of this rig's"},
      }) {
    json rig = plain();
    rig.merge_patch(json::parse(mistake.patch));
    const std::string refusal = refusal_of(rig);
    EXPECT_NE(refusal.find(mistake.sentence), std::string::npos) << mistake.patch << "\n"
                                                                 << refusal;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << mistake.patch << "\n" << refusal;
  }
}

json with_loads() {
  json rig = plain();
  rig["load"] = {{"type", "free"}, {"inertia_kg_m2", 0.01}};
  rig["loads"] = {{"a", {{"type", "free"}, {"inertia_kg_m2", 0.02}}},
                  {"x/b", {{"type", "free"}, {"inertia_kg_m2", 0.03}}}};
  return rig;
}

TEST(ReadRig, KnowsLoadsByRun) {
  const Rig rig = test::rig_of(with_loads());
  EXPECT_EQ(load_of(rig, "other").inertia_kg_m2, 0.01);
  EXPECT_EQ(load_of(rig, "a").inertia_kg_m2, 0.02);
  EXPECT_EQ(load_of(rig, "a (first two thirds)").inertia_kg_m2, 0.02);
  EXPECT_EQ(load_of(rig, "x/b (last third)").inertia_kg_m2, 0.03);
  EXPECT_TRUE(rig.states_load);
  json alone = with_loads();
  alone.erase("load");
  EXPECT_FALSE(test::rig_of(alone).states_load);
  EXPECT_EQ(test::rig_of(alone).load.type, LoadType::kFree);
}

TEST(ReadRig, RefusesLoadsThatAreNotOneRig) {
  json rig = with_loads();
  rig["loads"]["x/b"] = {{"type", "linear_axis"}};
  const std::string refusal = refusal_of(rig);
  EXPECT_NE(refusal.find("/loads/x~1b/mass_kg: missing; a load of type \"linear_axis\""),
            std::string::npos);
  EXPECT_NE(refusal.find("/loads/x~1b/type: all loads of a rig must be of one type"),
            std::string::npos);
  rig = plain();
  rig.erase("load");
  EXPECT_NE(refusal_of(rig).find("/load: missing; what does the actuator move?"),
            std::string::npos);
  json arms = arm();
  arms["load"]["links"][0]["joint"] = "shoulder";
  arms["load"]["links"][1]["joint"] = "elbow";
  arms["loads"]["a"] = arms["load"];
  EXPECT_EQ(refusal_of(arms), "");
  arms["loads"]["a"]["links"].erase(1);
  EXPECT_NE(refusal_of(arms).find("/loads/a/links: its joints are not those"), std::string::npos);
  arms["loads"]["a"] = arms["load"];
  arms["loads"]["a"]["links"][1]["joint"] = "wrist";
  EXPECT_NE(refusal_of(arms).find("/loads/a/links: its joints are not those"), std::string::npos);
}

TEST(ReadRig, PointsToTheLoadOfARun) {
  json rig = with_loads();
  rig["uncertain"] = {"/loads/a/inertia_kg_m2", "/loads/x~1b/inertia_kg_m2"};
  EXPECT_EQ(refusal_of(rig), "");
  rig["uncertain"] = {"/load/inertia_kg_m2"};
  EXPECT_NE(refusal_of(rig).find("say of which run, /loads/RUN/inertia_kg_m2"), std::string::npos);
  rig["uncertain"] = {"/loads/c/inertia_kg_m2"};
  EXPECT_NE(refusal_of(rig).find("did you mean /loads/a/inertia_kg_m2?"), std::string::npos);
  rig.erase("loads");
  EXPECT_NE(refusal_of(rig).find("leads to no value"), std::string::npos);
}

TEST(ReadLog, RefusesRunsWithoutALoadAndLoadsWithoutARun) {
  json rig = test::rig_json({{"t_s", "time_s"}, {"q_rad", "output_position_rad"}, {"run", "run"}});
  rig["load"] = {{"type", "free"}, {"inertia_kg_m2", 1}};
  rig["loads"]["run_1"] = rig["load"];
  const std::string log = "run,t_s,q_rad\nrun_1,0,0\nrun_1,1,1\nrun_2,0,0\nrun_2,1,1\n";
  EXPECT_EQ(test::read({{"m.csv", log}}, rig).refusal, "");
  rig.erase("load");
  EXPECT_EQ(test::read({{"m.csv", log}}, rig).refusal.find("rig.json#/loads/run_2: missing"), 0u);
  rig["loads"]["runn_2"] = rig["loads"]["run_1"];
  rig["loads"]["run_2"] = rig["loads"]["run_1"];
  EXPECT_EQ(test::read({{"m.csv", log}}, rig).refusal,
            "rig.json#/loads/runn_2: no run \"runn_2\"; did you mean \"run_2\"?");
}

TEST(ReadRig, AcceptsPointersIntoRigAndActuator) {
  json rig = plain();
  rig["load"] = {{"type", "pendulum"}, {"mass_kg", 1}, {"length_m", 1}, {"inertia_kg_m2", 0}};
  rig["uncertain"] = {"/load/mass_kg", "/motor/torque_constant_Nm_A", "/motor/resistance_ohm",
                      "/gearbox/ratio", "/gearbox/forward_efficiency"};
  EXPECT_EQ(refusal_of(rig), "");
}

TEST(ReadRig, SaysAllFaultsAtOnce) {
  json rig = plain();
  rig["columns"]["q_rad"] = "nothing";
  rig["ignore"] = {"t_s"};
  rig["uncertain"] = {"/load/x"};
  const std::string refusal = refusal_of(rig);
  EXPECT_EQ(std::count(refusal.begin(), refusal.end(), '\n'), 2) << refusal;
}

// A holding map has no time: positions and what holds them.
TEST(ReadRig, NeedsNoTimeForAMap) {
  EXPECT_EQ(refusal_of(test::rig_json({{"q", "motor_position_rad"}, {"i", "motor_current_A"}})),
            "");
}

}  // namespace
}  // namespace torquewright::identification
