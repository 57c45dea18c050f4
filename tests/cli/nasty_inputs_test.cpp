// SPDX-License-Identifier: Apache-2.0
// Inputs that somebody will bring, to every command that takes such a file. Rules: it ends with 0
// to 3, says why where it ends with 2, writes no nan or inf, and leaves nothing behind.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/no_number.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using Words = std::vector<std::string>;

void expect_civil(const Workplace& place, const Words& command, const std::string& what,
                  std::size_t files) {
  const Outcome outcome = place.run(command);
  EXPECT_TRUE(outcome.exit_code >= 0 && outcome.exit_code <= 3)
      << what << ": " << outcome.exit_code << " " << outcome.err;
  EXPECT_EQ(outcome.exit_code == 2, !outcome.err.empty()) << what << ": " << outcome.err;
  EXPECT_FALSE(test::says_no_number(outcome.out)) << what << ": " << outcome.out;
  EXPECT_LE(outcome.err.size(), 5'000'000u) << what;
  EXPECT_EQ(place.files().size(), files) << what << " leaves a file behind";
}

struct Nasty {
  const char* what;
  std::function<std::string(const std::string&)> spoil;  ///< A good file's text.
};

/// Where the cell of that number starts in a row, and the next one.
std::pair<std::size_t, std::size_t> cell_of(const std::string& line, std::size_t index) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < index; ++i) start = line.find(',', start) + 1;
  return {start, std::min(line.find(',', start), line.size())};
}

/// A table with its column time_s through a function.
std::string with_times(const std::string& table, const std::function<double(double)>& change) {
  std::istringstream lines(table);
  std::string text;
  std::optional<std::size_t> column;
  for (std::string line; std::getline(lines, line); text += line + "\n") {
    if (line.starts_with('#')) continue;
    if (!column) {
      const auto end = line.begin() + static_cast<long>(line.find("time_s"));
      column = static_cast<std::size_t>(std::count(line.begin(), end, ','));
      continue;
    }
    const auto [start, end] = cell_of(line, *column);
    std::array<char, 40> number{};
    std::snprintf(number.data(), number.size(), "%.17g",
                  change(std::stod(line.substr(start, end - start))));
    line = line.substr(0, start) + number.data() + line.substr(end);
  }
  return text;
}

std::string first_lines(const std::string& text, int count) {
  std::size_t at = 0;
  for (int i = 0; i < count && at != std::string::npos; ++i) at = text.find('\n', at) + 1;
  return text.substr(0, at);
}

std::vector<Nasty> nasty_tables() {
  return {
      {"epoch time",
       [](const auto& text) { return with_times(text, [](double t) { return t + 1.7e9; }); }},
      {"times of 1e-300 s",
       [](const auto& text) { return with_times(text, [](double t) { return t * 1e-300; }); }},
      {"times of 1e300 s",
       [](const auto& text) { return with_times(text, [](double t) { return t * 1e300; }); }},
      {"one row",
       [](const auto& text) { return first_lines(text, text.starts_with('#') ? 5 : 2); }},
      {"header alone", [](const auto& text) { return first_lines(text, 1); }},
      {"nothing", [](const auto&) { return std::string(); }},
      {"nan in a cell",
       [](const auto& text) { return first_lines(text, 1) + "0,nan,0,0\n1,0,0,0\n"; }},
      {"subnormal cell",
       [](const auto& text) { return first_lines(text, 1) + "0,1e-310,0,0\n1,0,0,0\n"; }},
      {"greatest cell",
       [](const auto& text) { return first_lines(text, 1) + "0,1e308,0,-1e308\n1,0,0,1e308\n"; }},
      {"carriage returns",
       [](std::string text) {
         for (char& c : text) c = c == '\n' ? '\r' : c;
         return text;
       }},
      {"Latin-1",
       [](const auto& text) {
         return "T [\xB0"
                "C]," +
                text;
       }},
      {"a spreadsheet's separator", [](const auto& text) { return "sep=,\n" + text; }},
      {"zero bytes", [](const auto& text) { return text + std::string(3, '\0'); }},
  };
}

std::vector<Nasty> nasty_documents() {
  const auto named = [](const std::string& name) {
    return [name](const std::string& text) {
      const std::size_t at = text.find("\"name\": \"");
      return at == std::string::npos ? text : text.substr(0, at + 9) + name + text.substr(at + 9);
    };
  };
  return {
      {"a thousand faults",
       [](const auto& text) {
         std::string keys;
         for (int i = 0; i < 2000; ++i) keys += "\"x" + std::to_string(i) + "\": 1, ";
         return "{" + keys + "\"kind\": \"rig\", " + text.substr(text.find('{') + 1);
       }},
      {"a newline in the name", named("a\\nb")},
      {"U+FFFE in the name", named("a\\uFFFE")},
      {"no UTF-8", [](const auto& text) { return text + "\xFF"; }},
      {"nothing", [](const auto&) { return std::string(); }},
      {"deep", [](const auto&) { return std::string(100000, '['); }},
      {"a number that overflows", [](const auto&) { return std::string("{\"kind\": 1e999}"); }},
  };
}

TEST(NastyInputs, ATableWithoutAName) {
  const std::string robot = in_repository("specs/robot/hopper.json").string();
  expect_civil(Workplace(), {"hopper", "check", robot, "", "--report", "page.html"}, "no name", 0);
}

TEST(NastyInputs, TablesOfMotions) {
  Workplace place;
  for (const char* picture : {"a.svg", "b.svg"}) place.write(picture, "");
  for (const Nasty& nasty : nasty_tables()) {
    place.write("knee.csv",
                nasty.spoil(text_of(in_repository("specs/trajectory/knee_extension.csv"))));
    place.write("flip.csv",
                nasty.spoil(text_of(in_repository("specs/trajectory/hopper_flip.csv"))));
    place.write("play.csv", nasty.spoil(text_of(in_repository("specs/excitation/knee_sweep.csv"))));
    const std::string knee = in_repository("specs/actuator/d151_knee.json").string();
    const std::string robot = in_repository("specs/robot/hopper.json").string();
    const std::string rig = in_repository("specs/rig/knee_sweep.json").string();
    expect_civil(place, {"actuator", "check", "knee.csv", "--joint", "knee=" + knee}, nasty.what,
                 5);
    expect_civil(place,
                 {"actuator", "check", "knee.csv", "--joint", "knee=" + knee, "--repeat",
                  "1000000000", "--json"},
                 nasty.what, 5);
    expect_civil(place, {"hopper", "check", robot, "flip.csv"}, nasty.what, 5);
    expect_civil(place,
                 {"hopper", "check", robot, "flip.csv", "--plot", "a.svg", "--plot-loads", "b.svg"},
                 nasty.what, 5);
    expect_civil(place, {"identify", "simulate", knee, "--rig", rig, "--excitation", "play.csv"},
                 nasty.what, 5);
    expect_civil(place, {"identify", "play.csv", "--rig", rig, "--actuator", knee}, nasty.what, 5);
  }
}

TEST(NastyInputs, Documents) {
  Workplace place;
  for (const Nasty& nasty : nasty_documents()) {
    const auto spoil = [&](const char* file, const char* name) {
      place.write(name, nasty.spoil(text_of(in_repository(file))));
    };
    spoil("specs/actuator/d110a_ankle.json", "actuator.json");
    spoil("specs/gearbox/d110a_ankle.json", "problem.json");
    spoil("specs/gearbox/d151_knee_result.json", "result.json");
    spoil("specs/gearbox/d110a_strength.json", "strength.json");
    spoil("specs/robot/rabbit.json", "robot.json");
    spoil("specs/robot/rabbit.urdf", "robot.urdf");
    const std::string motion = in_repository("specs/trajectory/knee_extension.csv").string();
    for (const Words& command :
         std::vector<Words>{{"actuator", "mor", "actuator.json"},
                            {"actuator", "lint", "actuator.json"},
                            {"actuator", "check", motion, "--joint", "knee=actuator.json"},
                            {"gearbox", "optimize", "problem.json"},
                            {"gearbox", "evaluate", "problem.json", "--teeth", "18,54"},
                            {"gearbox", "verify", "result.json"},
                            {"gearbox", "strength", "strength.json", "--torque", "21"},
                            {"robot", "export", "robot.json", "--format", "mjcf"},
                            {"robot", "import", "robot.urdf"},
                            {"hopper", "check", "robot.json", motion}}) {
      expect_civil(place, command, std::string(nasty.what) + ", " + command[1], 6);
    }
  }
}

TEST(NastyInputs, Numbers) {
  const Workplace place;
  const std::string knee = in_repository("specs/actuator/d151_knee.json").string();
  for (const char* number : {"nan", "inf", "-inf", "1e-310", "1e308", "1e400", "-0", "", " "}) {
    for (const char* option : {"--at-speed", "--bus-voltage", "--winding-temperature",
                               "--state-of-charge", "--accuracy", "--need", "--ratio"}) {
      expect_civil(place, {"actuator", "mor", knee, option, number},
                   std::string(option) + " " + number, 0);
    }
    expect_civil(place, {"actuator", "mor", knee, "--need", std::string("100@") + number}, number,
                 0);
    expect_civil(place, {"actuator", "mor", knee, "--need", number + std::string("@1")}, number, 0);
  }
}

TEST(NastyInputs, NamesThatAreNoText) {
  const Workplace place;
  place.write(
      "kn\xE9"
      "e.json",
      text_of(in_repository("specs/actuator/d151_knee.json")));
  expect_civil(place,
               {"actuator", "mor",
                "kn\xE9"
                "e.json",
                "--json"},
               "a name in Latin-1", 1);
  expect_civil(place, {"actuator", "mor", "abs\xE9nt.json"}, "a name in Latin-1", 1);
}

// The parser behind it compares each attribute with all before it.
TEST(NastyInputs, ElementsOfVeryManyAttributes) {
  const Workplace place;
  std::string attributes;
  for (int i = 0; i < 300000; ++i) attributes += " a" + std::to_string(i) + "=\"1\"";
  place.write("many.urdf",
              "<robot name=\"r\">\n<!-- <a b='1'> --><link name=\"l\"" + attributes + "/></robot>");
  const Outcome outcome = place.run({"robot", "import", "many.urdf"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "many.urdf: line 2: an element with 300001 attributes; at most 1000 are read\n");
}

}  // namespace
}  // namespace torquewright::cli_test
