// SPDX-License-Identifier: Apache-2.0
// The name of a file is bytes. Wherever it goes into a text it becomes characters that every output
// can hold. Oracles: expat, as Python has it, takes every XML; Python's compiler every module; a
// reader of our own (well_formed) every character.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/documents/schema.hpp"
#include "tests/cli/well_formed.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

/// U+FFFE, a byte of Latin-1, a line break, an escape; and what it becomes.
const std::string kName = "k\xEF\xBF\xBE\xE9\nimport k\x1B[31m";
const std::string kAsText = "k\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBDimport k\xEF\xBF\xBD[31m";

bool is_markup(const std::string& text) { return text.starts_with('<'); }

/// By what only the exporters' modules hold.
bool is_python(const std::string& text) {
  const std::string lines = "\n" + text;
  return lines.find("\nimport ") != std::string::npos || lines.find("\nfrom ") != std::string::npos;
}

bool has_python() {
  static const bool has = std::system("python3 -c '' 2>/dev/null") == 0;
  return has;
}

/// Python's exit code on the text of a file, which is its argument.
int python_says(const Workplace& place, const std::string& program, const std::string& text) {
  place.write("judged", text);
  const std::string command =
      "python3 -c '" + program + "' '" + place.path("judged").string() + "' 2>/dev/null";
  const int status = std::system(command.c_str());
  fs::remove(place.path("judged"));
  return status;
}

void expect_text(const Workplace& place, const std::string& text) {
  EXPECT_EQ(fault_of_characters_in(text), "");
  EXPECT_EQ(is_markup(text) ? fault_in(text) : "", "");
  if (!has_python()) return;
  if (is_markup(text) && !text.starts_with("<!DOCTYPE html>")) {
    EXPECT_EQ(python_says(place,
                          "import sys, xml.sax; xml.sax.parse(sys.argv[1], "
                          "xml.sax.ContentHandler())",
                          text),
              0)
        << text;
  } else if (is_python(text)) {
    EXPECT_EQ(python_says(place,
                          "import sys; compile(open(sys.argv[1], \"rb\").read(), \"m\", "
                          "\"exec\")",
                          text),
              0)
        << text;
  }
}

/// An actuator that has no name but its file's.
std::string unnamed_knee() {
  json knee = json::parse(text_of(in_repository("specs/actuator/d151_knee.json")));
  knee.erase("name");
  return knee.dump();
}

TEST(FileNames, AreTextInEveryExportOfAnActuator) {
  const Workplace place;
  place.write(kName + ".json", unnamed_knee());
  std::size_t pages = 0, modules = 0;
  for (const auto& format : io::schema_of("simulator_file")["properties"]["format"]["enum"]) {
    SCOPED_TRACE(format.get<std::string>());
    const Outcome outcome =
        place.run({"actuator", "mor", kName + ".json", "--format", format.get<std::string>()});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_text(place, outcome.out);
    EXPECT_NE(outcome.out.find(kAsText), std::string::npos) << outcome.out;
    pages += is_markup(outcome.out) ? 1U : 0U;
    modules += is_python(outcome.out) ? 1U : 0U;
  }
  EXPECT_GE(pages, 2u);  // the judges are asked
  EXPECT_GE(modules, 2u);
}

/// Without the commands that are proposed, which name files as they are.
std::string without_proposals(const std::string& text) {
  return text.substr(0, std::min(text.find("torquewright hopper"), text.find("next: ")));
}

/// Runs the command and looks at every file of those endings that it wrote.
void expect_written(const Workplace& place, const Words& command, const Words& files) {
  const Outcome outcome = place.run(command);
  if (outcome.err.find("gnuplot, which draws") != std::string::npos) return;  // not installed
  EXPECT_NE(outcome.exit_code, 2) << outcome.err;
  EXPECT_EQ(fault_of_characters_in(without_proposals(outcome.out)), "");
  for (const std::string& file : files) {
    SCOPED_TRACE(command[0] + " " + command[1] + " " + file);
    EXPECT_TRUE(place.has(file)) << outcome.err;
    expect_text(place, place.text(file));
  }
}

TEST(FileNames, AreTextInEveryPictureAndPage) {
  const Workplace place;
  const std::string knee = in_repository("specs/actuator/d151_knee.json").string();
  const std::string robot = in_repository("specs/robot/hopper.json").string();
  place.write(kName + ".json", unnamed_knee());
  place.write(kName + ".csv", text_of(in_repository("specs/trajectory/knee_extension.csv")));
  place.write("squat " + kName + ".csv",
              text_of(in_repository("specs/trajectory/hopper_squat.csv")));
  place.write("wheel " + kName + ".csv", text_of(in_repository("specs/log/wheel_moteus.csv")));
  expect_written(place, {"actuator", "mor", kName + ".json", "--compare", knee, "--plot", "r.svg"},
                 {"r.svg"});
  expect_written(place, {"actuator", "mor", kName + ".json", "-o", "r.csv"}, {"r.csv"});
  expect_written(place,
                 {"actuator", "check", kName + ".csv", "--joint", "knee=" + kName + ".json",
                  "--plot", "m.svg"},
                 {"m.svg"});
  expect_written(place,
                 {"hopper", "check", robot, "squat " + kName + ".csv", "--report", "c.html",
                  "--figures", "c.svg"},
                 {"c.html", "c.svg"});
  expect_written(place,
                 {"hopper", "replay", robot, "squat " + kName + ".csv", "--step", "0.0005",
                  "--stand", "0", "--until", "0.05", "--report", "p.html"},
                 {"p.html"});
  expect_written(place,
                 {"identify", "import", "moteus", "wheel " + kName + ".csv", "-o", "imported"},
                 {"imported/log.csv", "imported/rig.json"});
}

/// A document that has no name but its file's.
std::string unnamed(const char* document) {
  json root = json::parse(text_of(in_repository(document)));
  root.erase("name");
  return root.dump();
}

TEST(FileNames, AreTextInExportsOfARobotAndDrawingsOfAGearbox) {
  const Workplace place;
  place.write(kName + ".json", unnamed("specs/robot/rabbit.json"));
  for (const char* format : {"mjcf", "urdf"}) {
    expect_written(place,
                   {"robot", "export", kName + ".json", "--format", format, "-o", "robot.xml"},
                   {"robot.xml"});
  }
  fs::copy(in_repository("specs"), place.path(kName), fs::copy_options::recursive);
  expect_written(place,
                 {"robot", "export", kName + "/robot/hopper.json", "--format", "isaac-lab",
                  "--actuators", "-o", "drives.py"},
                 {"drives.py"});
  place.write(kName + ".json", unnamed("specs/gearbox/d110a_ankle.json"));
  expect_written(place,
                 {"gearbox", "optimize", kName + ".json", "--draw", "gears.svg", "-o", "r.json"},
                 {"gears.svg", "r.json"});
}

TEST(FileNames, AreTextInThePageOfAPlan) {
  const Workplace place;
  const std::string plan = kName + ".csv";
  expect_written(place,
                 {"hopper", "flip", in_repository("specs/robot/hopper.json").string(), "--task",
                  "jump", "--intervals", "20", "--integration-error", "0.1", "--sample-step",
                  "0.005", "-o", plan, "--report", "f.html"},
                 {"f.html", plan});
  const std::string page = place.has("f.html") ? place.text("f.html") : kAsText;
  EXPECT_NE(page.find(kAsText), std::string::npos);
}

}  // namespace
}  // namespace torquewright::cli_test
