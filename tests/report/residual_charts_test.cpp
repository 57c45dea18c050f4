// SPDX-License-Identifier: Apache-2.0
// What is left of each run on the page of an identification. Oracle: the run itself, made by hand:
// torques of 20 Nm of which 1.1 and then 0.05 are not explained.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/report/identification/identification_runs_html.hpp"

namespace torquewright::report {
namespace {

identification::Curve wave(double height, double begin_s) {
  identification::Curve curve;
  for (int i = 0; i <= 100; ++i) {
    curve.time_s.push_back(begin_s + 0.01 * i);
    curve.value.push_back(height * std::sin(0.2 * i));
  }
  return curve;
}

/// Points of the chart per unit of y: each chart says it, for the scripts of other pages.
std::vector<double> slopes_of(const std::string& page) {
  std::vector<double> slopes;
  const std::string key = "data-y-slope=\"";
  for (std::size_t at = page.find(key); at != std::string::npos; at = page.find(key, at + 1)) {
    slopes.push_back(std::stod(page.substr(at + key.size())));
  }
  return slopes;
}

TEST(ResidualCharts, HaveAScaleEach) {
  identification::EquationResult equation;
  equation.unit = "Nm";
  equation.added.emplace_back();
  identification::RunResult& run = equation.runs.emplace_back();
  run.run = "lift<1>";
  run.is_held_out = true;
  run.rms_before = 1.1 / std::sqrt(2.0);
  run.rms_after = 0.05 / std::sqrt(2.0);
  run.measured = run.stated = run.refined = wave(20.0, 3.0);
  run.left_before = wave(1.1, 3.0);
  run.left_after = wave(0.05, 3.0);
  Pictures pictures("--report");
  const std::string page = runs_section(equation, pictures);
  const std::vector<double> slopes = slopes_of(page);
  ASSERT_EQ(slopes.size(), 2u);
  EXPECT_NEAR(slopes[1] / slopes[0], 1.1 / 0.05, 1e-3);
  EXPECT_NE(page.find("lift&lt;1&gt;, held out, as stated: 0.778 Nm rms"), std::string::npos);
  EXPECT_NE(page.find("lift&lt;1&gt;, held out, refined: 0.0354 Nm rms"), std::string::npos);
  EXPECT_NE(page.find("class=\"left before\""), std::string::npos);
  // Nothing was added: what is left is that of the stated model alone.
  equation.added.clear();
  EXPECT_EQ(slopes_of(runs_section(equation, pictures)).size(), 1u);
}

}  // namespace
}  // namespace torquewright::report
