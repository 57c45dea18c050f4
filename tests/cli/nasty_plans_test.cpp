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

TEST(NastyPlans, FromMotions) {
  const PlansPlace place;
  for (const Nasty& nasty : nasty_tables()) {
    place.write("hop.csv", nasty.spoil(text_of(in_repository("specs/trajectory/hopper_hop.csv"))));
    expect_civil(place, short_plan(kRobot, joined({"--warm", "hop.csv"}, kPictures)), nasty.what,
                 kOutputs + 1);
    expect_civil(place,
                 {"hopper", "check", kRobot, "hop.csv", "--sweep", "knee_ratio=18,22", "--jobs",
                  "2", "--plot-sweep", "s.svg"},
                 nasty.what, kOutputs + 1);
    expect_civil(place,
                 {"hopper", "replay", kRobot, "hop.csv", "--step", "0.0005", "--stand", "0",
                  "--until", "0.1", "--trials", "1", "--randomise", kDraws},
                 nasty.what, kOutputs + 1);
  }
}

TEST(NastyPlans, OfRobotsAndDraws) {
  const PlansPlace place;
  fs::copy(in_repository("specs"), place.path("specs"), fs::copy_options::recursive);
  const std::string robot = "specs/robot/hopper.json";
  const std::string knee = "specs/actuator/d151_knee.json";
  for (const Nasty& nasty : nasty_documents()) {
    for (const std::string& file : {robot, knee}) {
      const std::string good = place.text(file);
      place.write(file, nasty.spoil(good));
      const std::string what = std::string(nasty.what) + " in " + file;
      expect_civil(place, short_plan(robot, joined({"--explain"}, kPictures)), what, kOutputs + 1);
      expect_civil(place, short_plan(robot, {"--sweep", "voltage=60,67", "--jobs", "2"}), what,
                   kOutputs + 1);
      expect_civil(place,
                   {"hopper", "check", robot, kSquat, "--sweep", "mass=12,14", "--jobs", "2"}, what,
                   kOutputs + 1);
      place.write(file, good);
    }
    place.write("draws.json", nasty.spoil(text_of(kDraws)));
    expect_civil(place,
                 {"hopper", "replay", robot, kSquat, "--step", "0.0005", "--stand", "0", "--until",
                  "0.1", "--trials", "1", "--randomise", "draws.json"},
                 nasty.what, kOutputs + 2);
    fs::remove(place.path("draws.json"));
    place.write("plan.csv", "old");
    fs::remove(place.path("plan.csv.journal"));
  }
}

TEST(NastyPlans, OfNumbers) {
  const PlansPlace place;
  for (const std::string& number : nasty_numbers()) {
    for (const char* option :
         {"--rise", "--stride", "--voltage-margin", "--current-margin", "--friction-margin",
          "--center-of-pressure-margin", "--gear-margin", "--position-margin", "--speed-margin",
          "--bus-voltage", "--winding-temperature", "--intervals", "--integration-error",
          "--time-limit", "--guess-noise", "--load-window", "--sample-step"}) {
      expect_civil(place, short_plan(kRobot, {option, number}), option + (" " + number), kOutputs);
    }
    expect_civil(place, short_plan(kRobot, {"--objective", "effort=" + number}), number, kOutputs);
    for (const std::string& sweep : {"knee_ratio=" + number, "knee_ratio=8:" + number + ":2",
                                     "mass=8:9:" + number, "voltage=60," + number}) {
      expect_civil(place, {"hopper", "check", kRobot, kSquat, "--sweep", sweep, "--jobs", "1"},
                   sweep, kOutputs);
    }
    for (const char* option : {"--success-rate", "--latency", "--ground-rise", "--impact-window"}) {
      expect_civil(place,
                   {"hopper", "replay", kRobot, kSquat, "--step", "0.0005", "--stand", "0",
                    "--until", "0.05", "--trials", "1", "--randomise", kDraws, option, number},
                   option + (" " + number), kOutputs);
    }
    expect_civil(place,
                 {"robot", "import", in_repository("specs/robot/rabbit.urdf").string(),
                  "--link-error", number},
                 "--link-error " + number, kOutputs);
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

TEST(NastyPlans, OfModels) {
  const PlansPlace place;
  for (const Nasty& nasty : nasty_models()) {
    for (const char* model : {"specs/robot/rabbit.urdf", "tests/fuzz/corpus/hopper.xml",
                              "tests/fuzz/corpus/looped.xml"}) {
      const fs::path file = fs::path(model).filename();
      place.write(file.string(), nasty.spoil(text_of(in_repository(model))));
      expect_civil(place,
                   {"robot", "import", file.string(), "--free-couplings", "--mend-inertias",
                    "--drop-base-armature", "--massless-links"},
                   std::string(nasty.what) + " in " + model, kOutputs + 1);
      fs::remove(place.path(file.string()));
    }
  }
}

}  // namespace
}  // namespace torquewright::cli_test
