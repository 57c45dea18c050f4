// SPDX-License-Identifier: Apache-2.0
// `identify import`: logs as other programs write them become log.csv and rig.json, which
// `identify` reads. Oracle: the formats' documentation, by hand, and closed forms of motions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/documents/schema.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

constexpr double kTurn_rad = 2.0 * std::numbers::pi;

struct Imported {
  Outcome outcome;
  std::string log;
  json rig;
};

Imported imported(const Workplace& place, std::vector<std::string> command) {
  command.insert(command.begin(), {"identify", "import"});
  command.insert(command.end(), {"-o", "made"});
  Imported result{place.run(command), "", {}};
  if (!place.has("made/log.csv")) return result;
  result.log = place.text("made/log.csv");
  result.rig = json::parse(place.text("made/rig.json"));
  return result;
}

Imported imported_text(const std::string& format, const std::string& name, const std::string& text,
                       const std::vector<std::string>& more = {}) {
  const Workplace place;
  place.write(name, text);
  std::vector<std::string> command{format, name};
  command.insert(command.end(), more.begin(), more.end());
  return imported(place, command);
}

void expect_refused(const Imported& result, const std::string& said) {
  EXPECT_EQ(result.outcome.exit_code, 2);
  EXPECT_NE(result.outcome.err.find(said), std::string::npos) << result.outcome.err;
  EXPECT_TRUE(result.log.empty());
}

json sysid() {
  return {{"sysid", true},
          {"test", "Arm"},
          {"units", "Degrees"},
          {"unitsPerRotation", 360.0},
          {"slow-forward", {{0.0, 0.0, 0.0, 0.0}, {0.02, 0.25, 0.125, 1}}},
          {"fast-backward", {{1.0, -7.0, 0.5, -2.5}}}};
}

// Folders that were made for files that cannot be written then are removed; one that was there is
// not.
TEST(Import, LeavesNoFolderWhereItFails) {
  Workplace place;
  place.write("arm.json", sysid().dump());
  place.here.file_size_limit = 50;  // as on a full disk
  const auto import_into = [&](const std::string& folder) {
    return place.run({"identify", "import", "sysid", "arm.json", "-o", folder}).exit_code;
  };
  EXPECT_EQ(import_into("made"), 2);
  EXPECT_EQ(import_into("made/within/another"), 2);
  EXPECT_EQ(import_into("made/within/another/"), 2);
  EXPECT_FALSE(place.has("made"));
  fs::create_directory(place.path("there"));
  EXPECT_EQ(import_into("there/made"), 2);
  EXPECT_TRUE(place.has("there"));
  EXPECT_FALSE(place.has("there/made"));
  place.here.file_size_limit.reset();
  EXPECT_EQ(import_into("made/within"), 0);
  EXPECT_TRUE(place.has("made/within/log.csv"));
}

TEST(Import, ReadsSysId) {
  const Imported result = imported_text("sysid", "arm.json", sysid().dump());
  EXPECT_EQ(result.outcome.exit_code, 0) << result.outcome.err;
  EXPECT_EQ(result.log,
            "run,timestamp,voltage,position,velocity\nslow-forward,0.0,0.0,0.0,0.0\n"
            "slow-forward,0.02,0.25,0.125,1\nfast-backward,1.0,-7.0,0.5,-2.5\n");
  EXPECT_EQ(result.rig["columns"]["voltage"], "winding_voltage_V");
  EXPECT_EQ(result.rig["columns"]["position"]["quantity"], "output_position_rad");
  EXPECT_NEAR(result.rig["columns"]["velocity"]["scale"].get<double>(), kTurn_rad, 1e-14);
  EXPECT_FALSE(result.rig.contains("load"));
  EXPECT_NE(result.outcome.out.find("state in made/rig.json what the actuator moved"),
            std::string::npos);
}

// Found by the fuzzer: a rig that its own reader refuses was written.
TEST(Import, WritesNoRigThatIsNone) {
  json arm = sysid();
  arm["unitsPerRotation"] = 67714885;
  expect_refused(imported_text("sysid", "arm.json", arm.dump()),
                 "made/rig.json is not written#/columns/position/scale: ");
}

TEST(Import, KeepsTheRigThatSomebodyHasEdited) {
  const Workplace place;
  place.write("arm.json", sysid().dump());
  const std::vector<std::string> command{"sysid", "arm.json"};
  const Imported first = imported(place, command);
  ASSERT_EQ(first.outcome.exit_code, 0) << first.outcome.err;
  EXPECT_EQ(imported(place, command).outcome.exit_code, 0);  // as it is already
  json edited = first.rig;
  edited["load"] = {{"kind", "locked"}};
  place.write("made/rig.json", edited.dump());
  const Imported again = imported(place, command);
  EXPECT_EQ(again.outcome.exit_code, 2);
  EXPECT_EQ(again.outcome.err.find("made/rig.json: is there already and says something else"), 0u);
  EXPECT_EQ(again.rig, edited);
}

// What is in it: tests/identification/log/recordings_test.cpp.
TEST(Import, WritesARecordingThatIsNotThereYet) {
  const Workplace place;
  const std::string legs = in_repository("tests/fuzz/corpus/imports/legs.mcap").string();
  std::vector<std::string> command{"identify", "import", "mcap", legs, "--topic", "/joint_states"};
  command.insert(command.end(), {"-o", "made"});
  EXPECT_EQ(place.run(command).exit_code, 0);
  EXPECT_EQ(place.run(command).exit_code, 0);  // as it is already
  const std::string log = place.text("made/log.csv");
  EXPECT_EQ(log.substr(0, log.find(',', 4)), "run,time_s");
  command.insert(command.end(), {"--joint", "knee_joint"});
  EXPECT_EQ(place.run(command).exit_code, 2);
  EXPECT_EQ(place.text("made/log.csv"), log);
  expect_refused(imported_text("moteus", "a.csv", "time,position\n0,0\n", {"--clock", "stamp"}),
                 "moteus's files have no topics");
}

// Nobody named the file that a link of that name leads to.
TEST(Import, KeepsALogThatIsThere) {
  const Workplace place;
  place.write("arm.json", sysid().dump());
  fs::create_directory(place.path("made"));
  fs::create_symlink(place.path("measured.csv"), place.path("made/log.csv"));
  place.write("measured.csv", "time_s\n0\n");
  const Outcome refused = place.run({"identify", "import", "sysid", "arm.json", "-o", "made"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.err.find("made/log.csv: is there already and says something else"), 0u);
  EXPECT_EQ(place.text("measured.csv"), "time_s\n0\n");
  EXPECT_FALSE(place.has("made/rig.json"));
}

TEST(Import, ReadsSysIdOfALinearMechanism) {
  json file = sysid();
  file["test"] = "Elevator";
  file["units"] = "Inches";
  file["unitsPerRotation"] = 5.0;
  const json rig = imported_text("sysid", "lift.json", file.dump()).rig;
  EXPECT_EQ(rig["columns"]["position"]["quantity"], "linear_position_m");
  EXPECT_NEAR(rig["columns"]["position"]["scale"].get<double>(), 0.127, 1e-15);
}

TEST(Import, RefusesSysIdByName) {
  const auto changed = [](const char* key, const json& value) {
    json file = sysid();
    file[key] = value;
    return imported_text("sysid", "arm.json", file.dump());
  };
  expect_refused(changed("test", "Drivetrain"), "arm.json#/test: \"Drivetrain\"");
  expect_refused(changed("units", "Furlongs"), "arm.json#/units: \"Furlongs\" is not known");
  expect_refused(changed("extra", 1), "arm.json#/extra: not understood");
  expect_refused(changed("fast-forward", {{1, 2, 3}}), "arm.json#/fast-forward/0: must be");
  expect_refused(changed("fast-forward", {{1, 2, 3, "x"}}), "\"x\" is no number");
  expect_refused(imported_text("sysid", "arm.json", "[1]"), "arm.json: is no JSON object");
  for (const json& no_list : {json(true), json(nullptr), json{{"0", 1}}}) {
    expect_refused(changed("fast-backward", no_list), "/fast-backward: must be a list");
  }
  expect_refused(imported_text("sysyd", "arm.json", "{}"), "did you mean \"sysid\"?");
}

/// A table as AdvantageScope exports it: a row for each value that a loop appends, the others held.
const char* const kSysIdTable =
    "Timestamp,/battery,/position-arm-lift,/sysid-test-state-lift,/velocity-arm-lift,"
    "/voltage-arm-lift\n"
    "9.99,12.1,null,null,null,null\n"
    "10.0000,12.1,null,none,null,null\n"
    "10.0200,12.1,0.0,none,null,1.0\n"
    "10.0201,12.1,0.0,quasistatic-forward,0.5,1.0\n"
    "10.0400,12.1,0.0,quasistatic-forward,0.5,2.0\n"
    "10.0401,12.1,0.25,quasistatic-forward,0.5,2.0\n"
    "10.0402,12.1,0.25,quasistatic-forward,0.75,2.0\n"
    "10.0500,12.2,0.25,quasistatic-forward,0.75,2.0\n"
    "10.0600,12.2,0.5,none,0.75,2.0\n"
    "12.0000,12.2,0.5,quasistatic-forward,0.0,-1.0\n"
    "13.0000,12.2,0.5,dynamic-reverse,0.0,-7.0\n"
    "13.0200,12.2,0.375,dynamic-reverse,-2.5,-7.0\n";

TEST(Import, ReadsATableOfSysIdsEntries) {
  const Imported result =
      imported_text("sysid_csv", "lift.csv", kSysIdTable, {"--units", "Rotations"});
  EXPECT_EQ(result.outcome.exit_code, 0) << result.outcome.err;
  EXPECT_EQ(result.log,
            "run,timestamp,voltage,position,velocity\n"
            "quasistatic-forward,10.0201,1.0,0.0,0.5\n"
            "quasistatic-forward,10.0402,2.0,0.25,0.75\n"
            "quasistatic-forward 2,12.0000,-1.0,0.5,0.0\n"
            "dynamic-reverse,13.0000,-7.0,0.5,0.0\n"
            "dynamic-reverse,13.0200,-7.0,0.375,-2.5\n");
  EXPECT_NEAR(result.rig["columns"]["position"]["scale"].get<double>(), kTurn_rad, 1e-14);
}

TEST(Import, RefusesATableThatItDoesNotUnderstandByName) {
  const auto changed = [](const std::string& from, const std::string& to,
                          const std::vector<std::string>& more = {"--units", "Meters"}) {
    std::string text = kSysIdTable;
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from)) {
      text.replace(at, from.size(), to);
    }
    return imported_text("sysid_csv", "lift.csv", text, more);
  };
  expect_refused(changed("12.1,", "12,", {}), "--units: is needed");
  expect_refused(changed("12.1,", "12,", {"--units", "Furlongs"}),
                 "\"Furlongs\" is not a known unit");
  expect_refused(changed("velocity-arm", "speed-arm"), "no motor has voltage-MOTOR-TEST");
  expect_refused(changed("sysid-test-state", "state"), "has no sysid-test-state-TEST");
  expect_refused(changed("dynamic-reverse", "sideways"), "\"sideways\" is no state of a test");
  expect_refused(changed("quasistatic-forward,0.75", "quasistatic-forward,x"), "lift.csv");
  expect_refused(changed("12.1,", "12,", {"--units", "Meters", "--joint", "leg"}),
                 "has no motor leg; say --joint, one of arm-lift");
  expect_refused(imported_text("sysid", "arm.json", sysid().dump(), {"--units", "Meters"}),
                 "sysid's files say themselves");
}

json bam(double arm_kg) {
  json file = {{"mass", 0.5}, {"length", 0.2}, {"kp", 32}, {"vin", 7.4}, {"motor", "x"}};
  file["trajectory"] = "sin_sin";
  if (arm_kg > 0.0) file["arm_mass"] = arm_kg;
  file["entries"] = json::array();
  for (int i = 0; i < 3; ++i) {
    file["entries"].push_back({{"timestamp", 0.01 * i},
                               {"position", 0.1 * i},
                               {"speed", 10.0},
                               {"load", 0.25 * i},
                               {"input_volts", 7.5},
                               {"temp", 30},
                               {"goal_position", 0.2},
                               {"torque_enable", true}});
  }
  return file;
}

// Oracle: BAM's test bench, inertia (m + a/3) L^2 about the axis, gravity's lever (m + a/2) L.
TEST(Import, ReadsBamsPendulum) {
  const Imported result = imported_text("bam", "a.json", bam(0.3).dump());
  EXPECT_EQ(result.outcome.exit_code, 0) << result.outcome.err;
  const json load = result.rig["loads"]["a"];
  EXPECT_EQ(load["type"], "pendulum");
  const double mass = load["mass_kg"], length = load["length_m"], inertia = load["inertia_kg_m2"];
  EXPECT_NEAR(mass * length, (0.5 + 0.15) * 0.2, 1e-15);
  EXPECT_NEAR(inertia + mass * length * length, (0.5 + 0.1) * 0.04, 1e-15);
  EXPECT_EQ(result.rig["columns"]["load"], "duty");
  EXPECT_EQ(result.rig["columns"]["torque_enable"], "enabled");
  EXPECT_EQ(result.rig["columns"]["temp"]["offset"], 273.15);
  EXPECT_EQ(result.log.substr(0, result.log.find('\n')),
            "run,timestamp,position,speed,goal_position,torque_enable,input_volts,temp,load");
  EXPECT_FALSE(result.rig.contains("assumed"));
  EXPECT_TRUE(imported_text("bam", "a.json", bam(0.0).dump()).rig.contains("assumed"));
}

TEST(Import, LeavesOutWhatBamDoesNotScale) {
  json file = bam(0.3);
  for (json& entry : file["entries"]) entry["load"] = 300;
  const Imported counts = imported_text("bam", "a.json", file.dump());
  EXPECT_FALSE(counts.rig["columns"].contains("load"));
  EXPECT_NE(counts.outcome.out.find("its scale is not said: load"), std::string::npos);
  file["entries"][0]["colour"] = 1;
  expect_refused(imported_text("bam", "a.json", file.dump()), "/entries/0/colour: not understood");
  file["entries"].erase(0);
  file["entries"][1].erase("temp");
  expect_refused(imported_text("bam", "a.json", file.dump()), "a.json#/entries/1/temp: missing");
}

TEST(Import, ReadsRostopicsJointStates) {
  const std::string text =
      "%time,field.header.seq,field.name0,field.name1,field.position0,field.position1,"
      "field.velocity0,field.velocity1,field.effort0,field.effort1\n"
      "1612345678000000000,1,hip,knee,0.1,0.2,1,2,3,4\n"
      "1612345678004000000,2,hip,knee,0.3,0.4,1,2,3,4\n";
  expect_refused(imported_text("ros", "js.csv", text), "holds several joints; say --joint");
  expect_refused(imported_text("ros", "js.csv", text, {"--joint", "7"}), "has no joint 7");
  const Imported result = imported_text("ros", "js.csv", text, {"--joint", "1"});
  EXPECT_EQ(result.outcome.exit_code, 0) << result.outcome.err;
  EXPECT_EQ(result.rig["columns"]["field.position1"], "output_position_rad");
  EXPECT_EQ(result.rig["columns"]["field.effort1"], "reported_torque_Nm");
  EXPECT_EQ(result.rig["columns"]["%time"], "time_s");
  EXPECT_NE(result.log.find("js,0.004000000,2,0.3"), std::string::npos) << result.log;
  EXPECT_EQ(result.rig["ignore"].size(), 4u);  // names, which are no numbers, are left out
  const Imported named = imported_text("ros", "js.csv", text, {"--joint", "knee"});
  EXPECT_EQ(named.rig["columns"], result.rig["columns"]);
}

// Two publishers of one topic: what stands first is another joint in every other row.
TEST(Import, RefusesJointStatesWhoseOrderChanges) {
  const std::string text =
      "%time,field.name0,field.name1,field.position0,field.position1\n"
      "1,hip,knee,0.1,0.2\n2,knee,hip,0.4,0.3\n";
  expect_refused(imported_text("ros", "js.csv", text, {"--joint", "hip"}),
                 "line 3, column 2 (field.name0): \"knee\", before \"hip\": the joints' order");
}

// PlotJuggler's tables have the rows of every topic; drivers without a sensor say nan.
TEST(Import, LeavesOutWhatIsNotThere) {
  const std::string header = "__time,/cmd/data,/js/knee/position,/js/knee/velocity,/js/knee/effort";
  const std::string text = header + "\n0,,1,2,nan\n0.5,7,,,\n1,,2,3,nan\n";
  const Imported result = imported_text("ros", "js.csv", text);
  EXPECT_EQ(result.outcome.exit_code, 0) << result.outcome.err;
  EXPECT_EQ(result.log, "run,__time,/js/knee/position,/js/knee/velocity\njs,0,1,2\njs,1,2,3\n");
  EXPECT_NE(result.outcome.out.find("1 rows, in which nothing stands that is read"),
            std::string::npos);
  EXPECT_NE(result.outcome.out.find("numbers: /cmd/data, /js/knee/effort"), std::string::npos)
      << result.outcome.out;
  expect_refused(imported_text("ros", "js.csv", header + "\n0,,1,2,3\n1,,2,3,nan\n"),
                 "line 3, column 5 (/js/knee/effort): \"nan\" is not a finite number");
  expect_refused(imported_text("ros", "js.csv", header + "\n0,,x,2,3\n1,,x,3,4\n"),
                 "line 2, column 3 (/js/knee/position): \"x\" is not a number");
}

TEST(Import, ReadsPlotJugglersJointStates) {
  for (const char* header : {"__time,/joint_states/position[0],/joint_states/velocity[0]",
                             "__time,/joint_states/knee/position,/joint_states/knee/velocity"}) {
    const Imported result =
        imported_text("ros", "js.csv", fmt::format("{}\n0,1,2\n1,2,3\n", header));
    EXPECT_EQ(result.outcome.exit_code, 0) << result.outcome.err;
    EXPECT_EQ(result.rig["columns"].size(), 4u);
  }
}

TEST(Import, ReadsOdrive) {
  const std::string text =
      "t,axis0.encoder.pos_estimate,axis0.encoder.vel_estimate,"
      "axis0.motor.current_control.Iq_measured,axis0.motor.current_control.Iq_setpoint,vbus_"
      "voltage\n"
      "0,0.5,1,2,2,24\n0.01,0.51,1,2,2,24\n";
  const Imported result = imported_text("odrive", "o.csv", text);
  EXPECT_EQ(result.outcome.exit_code, 0) << result.outcome.err;
  const json& columns = result.rig["columns"];
  EXPECT_EQ(columns["axis0.encoder.pos_estimate"]["quantity"], "motor_position_rad");
  EXPECT_NEAR(columns["axis0.encoder.vel_estimate"]["scale"].get<double>(), kTurn_rad, 1e-15);
  EXPECT_EQ(columns["axis0.motor.current_control.Iq_measured"], "motor_current_A");
  EXPECT_EQ(columns["vbus_voltage"], "bus_voltage_V");
  EXPECT_EQ(result.rig["ignore"], json({"axis0.motor.current_control.Iq_setpoint"}));
  const std::string both =
      "t,axis0.encoder.pos_estimate,axis1.encoder.pos_estimate\n0,1,2\n1,2,3\n";
  expect_refused(imported_text("odrive", "o.csv", both),
                 "are both motor_position_rad; say --joint");
  expect_refused(imported_text("odrive", "o.csv", both, {"--joint", "axis7"}),
                 "o.csv: has no axis axis7 among its columns: ");
  EXPECT_TRUE(imported_text("odrive", "o.csv", both, {"--joint", "axis1"})
                  .rig["columns"]
                  .contains("axis1.encoder.pos_estimate"));
}

TEST(Import, ReadsMoteus) {
  const Imported result = imported_text(
      "moteus", "m.csv",
      "timestamp,mode,position,velocity,torque,q_current,d_current,voltage,temperature,"
      "motor_temperature,control_position\n0,10,0.25,1,2,3,0,24,40,50,0.3\n");
  EXPECT_EQ(result.outcome.exit_code, 0) << result.outcome.err;
  const json& columns = result.rig["columns"];
  EXPECT_EQ(columns["position"]["quantity"], "output_position_rad");
  EXPECT_EQ(columns["torque"], "reported_torque_Nm");
  EXPECT_EQ(columns["q_current"], "motor_current_A");
  EXPECT_EQ(columns["motor_temperature"]["offset"], 273.15);
  EXPECT_EQ(result.rig["ignore"], json({"mode", "d_current", "temperature", "control_position"}));
  expect_refused(imported_text("moteus", "m.csv", "a,b\n1,2\n"), "no time among its columns: a, b");
  expect_refused(imported_text("moteus", "m.csv", "t,position\n1,2\n", {"--joint", "knee"}),
                 "--joint: moteus's files are read as those of one joint; leave \"knee\" out");
  expect_refused(imported_text("moteus", "m.csv", "t,b\n1,2\n"), "nothing known but the time");
}

// Columns that nobody reads are copied, but for words, states and readings that are no numbers.
TEST(Import, LeavesOutColumnsThatAreNotNumbersThroughout) {
  const Imported result = imported_text("moteus", "m.csv",
                                        "timestamp,mode,position,fault,temperature,d_current\n"
                                        "0,10,0.25,none,40,1\n0.1,10,0.5,none,inf,2\n");
  EXPECT_EQ(result.outcome.exit_code, 0) << result.outcome.err;
  EXPECT_EQ(result.log, "run,timestamp,mode,position,d_current\nm,0,10,0.25,1\nm,0.1,10,0.5,2\n");
  EXPECT_EQ(result.rig["ignore"], json({"mode", "d_current"}));
  EXPECT_NE(result.outcome.out.find(
                "left out, for not all that they hold are numbers: fault, temperature"),
            std::string::npos)
      << result.outcome.out;
}

// What was written is what `identify` reads; the load is asked for until it is stated. Oracle: a
// flywheel of 0.02 kg m^2 driven by V = R i + Ke N w, N Kt i = J a, in rotations.
TEST(Import, LeadsToAnIdentification) {
  json file = sysid();
  file["test"] = "Simple";
  file["units"] = "Rotations";
  file["unitsPerRotation"] = 1.0;
  int k = 0;
  for (const char* test : {"slow-forward", "slow-backward", "fast-forward", "fast-backward"}) {
    file[test] = json::array();
    for (int i = 0; i < 2400; ++i) {
      const double t = 0.005 * i, q = 0.8 * std::sin(2.0 * t + k) + 0.3 * std::sin(5.3 * t);
      const double w = 1.6 * std::cos(2.0 * t + k) + 1.59 * std::cos(5.3 * t);
      const double a = -3.2 * std::sin(2.0 * t + k) - 8.427 * std::sin(5.3 * t);
      file[test].push_back({t, 0.5 * 0.02 * a + w, q / kTurn_rad, w / kTurn_rad});
    }
    ++k;
  }
  const Workplace place;
  place.write("wheel.json", file.dump());
  Imported result = imported(place, {"sysid", "wheel.json"});
  place.write("actuator.json", R"({"kind": "actuator", "version": 1, "name": "drive",
    "motor": {"torque_constant_Nm_A": 0.1, "torque_constant_convention": "dc", "resistance_ohm": 0.5,
      "resistance_convention": "dc", "rotor_inertia_kg_m2": 1e-12},
    "drive": {"bus_voltage_V": 48, "peak_current_A": 100},
    "gearbox": {"ratio": 10, "forward_efficiency": 1, "backward_efficiency": 1}})");
  const std::vector<std::string> command{"identify",   "made/log.csv",  "--rig", "made/rig.json",
                                         "--actuator", "actuator.json", "--json"};
  const Outcome without_load = place.run(command);
  EXPECT_EQ(without_load.exit_code, 2);
  EXPECT_NE(without_load.err.find("made/rig.json#/load: missing; what does the actuator move?"),
            std::string::npos);
  result.rig["load"] = {{"type", "free"}, {"inertia_kg_m2", 0.02}};
  place.write("made/rig.json", result.rig.dump());
  const Outcome outcome = place.run(command);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["verdict"], "nothing_missing") << outcome.out.substr(0, 3000);
}

TEST(ImportOfNamedColumns, RefusesCellsThatAreNoNumbersWhereTheyAreRead) {
  const auto with = [](const std::string& mode, const std::string& velocity) {
    return imported_text(
        "moteus", "wheel.csv",
        fmt::format("timestamp,mode,position,velocity\n0.00,10,0.1,0.2\n0.02,{},0.2,{}\n", mode,
                    velocity));
  };
  for (const std::string cell : {"nan", "inf", "", "1e999", "stop"}) {
    expect_refused(with("10", cell), "wheel.csv: line 3, column 4 (velocity)");
  }
  EXPECT_EQ(with("position", "0.3").outcome.exit_code, 0);
}

}  // namespace
}  // namespace torquewright::cli_test
