// SPDX-License-Identifier: Apache-2.0
// The table of nasty inputs (nasty_inputs_test.cpp) times the commands that plan, sweep, try and
// import. Searches are cut to a few iterations: nasty is what they are given.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/nasty.hpp"

namespace torquewright::cli_test {
namespace {

using Words = std::vector<std::string>;

const std::string kRobot = in_repository("specs/robot/hopper.json").string();
const std::string kSquat = in_repository("specs/trajectory/hopper_squat.csv").string();
const std::string kDraws = in_repository("specs/randomisation/hopper.json").string();

const std::string kDriven = in_repository("specs/actuator/d151_knee.json").string();

Words joined(Words command, const Words& more) {
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

/// A jump that is hardly searched for. What stands at its outputs is replaced or stays.
Words short_plan(const std::string& robot, const Words& more) {
  return joined({"hopper", "flip", robot, "--task", "jump", "--contacts", "flat,flight,flat",
                 "--intervals", "10", "--rounds", "0", "--iterations", "2", "-o", "plan.csv"},
                more);
}

struct PlansPlace : Workplace {
  PlansPlace() {
    for (const char* output : {"plan.csv", "best.csv", "d.svg", "s.svg"}) write(output, "old");
  }
};
constexpr std::size_t kOutputs = 4;

const Words kPictures{"--write-best", "best.csv", "--plot-momentum", "d.svg", "--time-limit", "1"};

/// What a motion is given to, and for which option.
const std::vector<Words> kReadersOfMotions{
    short_plan(kRobot, joined({"--warm", "hop.csv"}, kPictures)),
    {"hopper", "check", kRobot, "hop.csv", "--sweep", "knee_ratio=18,22", "--jobs", "2",
     "--plot-sweep", "s.svg"},
    {"hopper", "replay", kRobot, "hop.csv", "--step", "0.0005", "--stand", "0", "--until", "0.1",
     "--trials", "1", "--randomise", kDraws}};

TEST(NastyPlans, FromMotions) {
  const PlansPlace place;
  const std::string good = text_of(in_repository("specs/trajectory/hopper_hop.csv"));
  place.write("hop.csv", good);
  for (const Words& command : kReadersOfMotions) expect_sound(place, command, kOutputs + 1);
  for (const Nasty& nasty : nasty_tables()) {
    place.write("hop.csv", nasty.spoil(good));
    for (const Words& command : kReadersOfMotions) {
      expect_judged(place, command, std::string(nasty.what) + ", " + command[1], kOutputs + 1,
                    nasty.is_refused);
    }
  }
}

const std::string kRobotHere = "specs/robot/hopper.json";

const std::vector<Words> kReadersOfRobots{
    short_plan(kRobotHere, joined({"--explain"}, kPictures)),
    short_plan(kRobotHere, {"--sweep", "voltage=60,67", "--jobs", "2"}),
    {"hopper", "check", kRobotHere, kSquat, "--sweep", "mass=12,14", "--jobs", "2"}};

void remove_journal(const Workplace& place) {
  place.write("plan.csv", "old");
  fs::remove(place.path("plan.csv.journal"));
}

TEST(NastyPlans, OfRobots) {
  const PlansPlace place;
  fs::copy(in_repository("specs"), place.path("specs"), fs::copy_options::recursive);
  for (const Words& command : kReadersOfRobots) {
    // What a sweep has done stays in its journal, which a refused one does not begin.
    const bool has_journal = command[1] == "flip" && command != kReadersOfRobots[0];
    expect_sound(place, command, kOutputs + 1 + (has_journal ? 1 : 0));
    remove_journal(place);
  }
  for (const std::string& file : {kRobotHere, std::string("specs/actuator/d151_knee.json")}) {
    const std::string good = place.text(file);
    for (const Nasty& nasty : nasty_documents()) {
      place.write(file, nasty.spoil(good));
      for (const Words& command : kReadersOfRobots) {
        expect_refused(place, command, std::string(nasty.what) + " in " + file, kOutputs + 1);
      }
    }
    place.write(file, good);
  }
}

TEST(NastyPlans, OfDraws) {
  const PlansPlace place;
  const std::string good = text_of(kDraws);
  const Words command{"hopper",   "replay",  kRobot,        kSquat,      "--step",
                      "0.0005",   "--stand", "0",           "--until",   "0.1",
                      "--trials", "1",       "--randomise", "draws.json"};
  place.write("draws.json", good);
  expect_sound(place, command, kOutputs + 1);
  for (const Nasty& nasty : nasty_documents()) {
    place.write("draws.json", nasty.spoil(good));
    expect_refused(place, command, nasty.what, kOutputs + 1);
  }
}

struct PlanNumber {
  const char* option;
  const char* sound;
};

TEST(NastyPlans, OfNumbers) {
  const PlansPlace place;
  for (const auto& [option, sound] : std::vector<PlanNumber>{{"--rise", "0.05"},
                                                             {"--voltage-margin", "0.1"},
                                                             {"--current-margin", "0.1"},
                                                             {"--friction-margin", "0.1"},
                                                             {"--center-of-pressure-margin", "0.1"},
                                                             {"--gear-margin", "0.1"},
                                                             {"--position-margin", "0.1"},
                                                             {"--speed-margin", "0.1"},
                                                             {"--bus-voltage", "60"},
                                                             {"--winding-temperature", "300"},
                                                             {"--integration-error", "0.1"},
                                                             {"--time-limit", "5"},
                                                             {"--guess-noise", "0.01"},
                                                             {"--load-window", "0.01"},
                                                             {"--sample-step", "0.005"},
                                                             {"--objective", "effort=1"}}) {
    expect_sound(place, short_plan(kRobot, {option, sound}), kOutputs);
    const std::string value(sound);
    const std::string before = value.substr(0, value.find('=') + 1);
    for (const NastyNumber& number : nasty_numbers()) {
      expect_judged(place, short_plan(kRobot, {option, before + number.text}),
                    option + (" " + number.text), kOutputs, number.is_refused);
    }
  }
}

const Words kDrivesOfLoops{"--actuator", "knee=" + kDriven,
                           "--actuator", "ankle_left=" + kDriven,
                           "--actuator", "ankle_right=" + kDriven};

TEST(NastyPlans, OfSweepsAndTrials) {
  const PlansPlace place;
  const Words mesh{"hopper",           "flip",       kRobot, "--task",       "jump", "--contacts",
                   "flat,flight,flat", "--rounds",   "0",    "--iterations", "2",    "-o",
                   "plan.csv",         "--intervals"};
  const Words hop{"hopper",
                  "flip",
                  kRobot,
                  "--task",
                  "hop",
                  "--contacts",
                  "flat,flight,flat",
                  "--rounds",
                  "0",
                  "--iterations",
                  "2",
                  "--intervals",
                  "10",
                  "-o",
                  "plan.csv",
                  "--stride"};
  const Words check{"hopper", "check", kRobot, kSquat, "--jobs", "1", "--sweep"};
  const Words replay{"hopper", "replay",  kRobot, kSquat,     "--step", "0.0005",      "--stand",
                     "0",      "--until", "0.05", "--trials", "1",      "--randomise", kDraws};
  const Words import =
      joined({"robot", "import", in_repository("tests/fuzz/corpus/looped.xml").string()},
             joined(kDrivesOfLoops, {"--massless-links", "--link-error"}));
  struct Place {
    Words command;
    std::string before, sound, after;
  };
  for (const Place& each : std::vector<Place>{
           {check, "knee_ratio=", "20", ""},
           {check, "knee_ratio=18:", "22", ":2"},
           {check, "mass=13:14:", "1", ""},
           {check, "voltage=60,", "67", ""},
           {joined(replay, {"--success-rate"}), "", "0.5", ""},
           {joined(replay, {"--latency"}), "", "0.001", ""},
           {joined(replay, {"--ground-rise"}), "", "0.0005", ""},
           {joined(replay, {"--impact", "invariant", "--impact-window"}), "", "0.01", ""},
           {import, "", "0.1", ""},
           {mesh, "", "10", ""},
           {hop, "", "0.1", ""}}) {
    expect_sound(place, joined(each.command, {each.before + each.sound + each.after}), kOutputs);
    for (const NastyNumber& number : nasty_numbers()) {
      const std::string value = each.before + number.text + each.after;
      expect_judged(place, joined(each.command, {value}), each.command.back() + " " + value,
                    kOutputs, number.is_refused);
    }
  }
}

std::vector<Nasty> nasty_models() {
  const auto instead = [](const std::string& from, const std::string& to) {
    return [from, to](std::string text) {
      for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
        text.replace(at, from.size(), to);
      }
      return text;
    };
  };
  return {
      {"nothing", [](const auto&) { return std::string(); }},
      {"no UTF-8", [](const auto& text) { return text + "\xFF"; }},
      {"zero bytes", [](const auto& text) { return text + std::string(3, '\0'); }},
      {"half of it", [](const auto& text) { return text.substr(0, text.size() / 2); }},
      {"deep",
       [](const auto&) {
         std::string text;
         for (int i = 0; i < 20000; ++i) text += "<body>";
         return text;
       }},
      {"masses of nan", instead("mass=\"", "mass=\"nan")},
      {"masses of 1e308", instead("mass=\"", "mass=\"1e308")},
      {"subnormal axes", instead("axis=\"", "axis=\"1e-310 0 0 ")},
      {"names alike", instead("name=\"", "name=\"x\" class=\"")},
      {"newlines in names", instead("name=\"", "name=\"a&#10;b")},
  };
}

const Words kOfMjcf{"--free-couplings", "--drop-base-armature", "--massless-links"};

struct Model {
  const char* file;
  Words options;
};

TEST(NastyPlans, OfModels) {
  const PlansPlace place;
  for (const auto& [model, options] :
       std::vector<Model>{{"specs/robot/rabbit.urdf", {}},
                          {"tests/fuzz/corpus/hopper.xml", kOfMjcf},
                          {"tests/fuzz/corpus/looped.xml", joined(kOfMjcf, kDrivesOfLoops)}}) {
    const std::string file = fs::path(model).filename().string();
    const std::string good = text_of(in_repository(model));
    const Words command = joined({"robot", "import", file, "--mend-inertias"}, options);
    place.write(file, good);
    expect_sound(place, command, kOutputs + 1);
    for (const Nasty& nasty : nasty_models()) {
      place.write(file, nasty.spoil(good));
      expect_civil(place, command, std::string(nasty.what) + " in " + model, kOutputs + 1);
    }
    fs::remove(place.path(file));
  }
}

}  // namespace
}  // namespace torquewright::cli_test
