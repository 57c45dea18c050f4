// SPDX-License-Identifier: Apache-2.0
// The layout of the text that `actuator lint` prints.
#include <gtest/gtest.h>

#include <sstream>

#include "src/report/actuator/lint_text.hpp"
#include "tests/actuator/lint/sample.hpp"

namespace torquewright::actuator::lint {
namespace {

std::string table_ii() {
  return report::lint_text(
      examine_all(std::vector{from_specs("d151_knee.json"), from_specs("d110a_ankle.json")}));
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Oracle: table II's speeds by convention, as computed by hand in the reference (c V / (Kt N)).
TEST(LintText, PrintsTableIiByConvention) {
  const std::string text = table_ii();
  for (const char* line : {
           "\n                                    c       knee D151     ankle D110A\n",
           "\n  Kt = Ke (dc ampere)           1.000           10.50           19.09  no\n",
           "\n  Nm per peak ampere, svpwm     0.866            9.09           16.53  no\n",
           "\n  Nm per peak ampere, sine      0.750            7.88           14.32  no\n",
           "\n  Nm per peak ampere, six_step  0.955           10.03           18.23  no\n",
           "\n  Nm per rms ampere, svpwm      1.225           12.86           23.38  if loaded or "
           "capped\n",
           "\n  Nm per rms ampere, sine       1.061           11.14           20.25  if loaded or "
           "capped\n",
           "\n  stated                                           10              20\n",
           "\n  c that the stated needs               0.891...1.016   1.010...1.086\n",
       }) {
    EXPECT_TRUE(contains(text, line)) << line << text;
  }
}

// Numbers stand in one column, the mark after them, and what disagrees shouts.
TEST(LintText, AlignsComparisons) {
  int rows = 0;
  for (const std::string& line : lines_of(table_ii())) {
    const bool is_row = line.ends_with(" agrees") || line.ends_with(" tolerated");
    if (!is_row) continue;
    ++rows;
    EXPECT_EQ(line.substr(0, 2), "  ");
    EXPECT_TRUE(line.substr(62, 4) == " =  " || line.substr(62, 4) == " <= ") << line;
    EXPECT_NE(line[61], ' ') << line;
    EXPECT_NE(line[66], ' ') << line;
  }
  EXPECT_EQ(rows, 8);
  EXPECT_TRUE(contains(table_ii(),
                       "\n  no-load-speed                        20 (19.5 to 20.5) rad/s =  19.09 "
                       "(18.88 to 19.31) rad/s               tolerated\n"));
  Actuator fast = sample();
  fast.datasheet->no_load_speed_rad_s = 24;
  EXPECT_TRUE(contains(report::lint_text(examine_all(std::vector{fast})), " DISAGREES\n"));
}

TEST(LintText, SaysOfEachFindingWhatItRestsOnAndWhatWouldReconcileIt) {
  const std::string text = table_ii();
  EXPECT_TRUE(contains(text, "\nnote: ankle D110A: no-load-speed: "));
  EXPECT_TRUE(contains(text, "\n  follows from /datasheet/voltage_V, "));
  EXPECT_TRUE(contains(text,
                       "\n  assumed, neither published nor measured: "
                       "/motor/torque_constant_convention\n"));
  EXPECT_TRUE(contains(text, "\n  would it agree with:\n"));
  EXPECT_TRUE(contains(text, "\n    a round number: 20 printed for 15 to 25 "));
  EXPECT_TRUE(contains(text, "An interval is what rounding leaves open"));
}

TEST(LintText, SaysWhereThereIsNothingToSay) {
  Actuator bare = sample();
  bare.datasheet.reset();
  const std::string text = report::lint_text(examine_all(std::vector{bare}));
  EXPECT_TRUE(contains(text, "\nno contradiction\n")) << text;
}

}  // namespace
}  // namespace torquewright::actuator::lint
