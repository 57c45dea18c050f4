// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "src/report/identification/identification_plots.hpp"
#include "src/report/parts/gnuplot.hpp"

namespace torquewright::report {
namespace {

/// Relative luminance of "#rrggbb" by WCAG 2.1.
double luminance(const std::string& color) {
  constexpr std::array<double, 3> kWeights{0.2126, 0.7152, 0.0722};
  double sum = 0.0;
  for (std::size_t i = 0; i < kWeights.size(); ++i) {
    const double share = std::stoi(color.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    sum +=
        kWeights[i] * (share <= 0.03928 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4));
  }
  return sum;
}

// A rainbow is lightest in its middle; a scale that orders rises from end to end, in each quarter
// by no less than a twenty-fifth of the whole.
TEST(Pictures, ScalesOfColoursRiseInLightness) {
  const std::string palette = gnuplot_palette();
  static const std::regex kColor("#[0-9a-f]{6}");
  std::vector<double> all;
  for (std::sregex_iterator it(palette.begin(), palette.end(), kColor), none; it != none; ++it) {
    all.push_back(luminance(it->str()));
  }
  ASSERT_GE(all.size(), 5u);
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_GE(all[i] - all[i - 1], 0.04 * (all.back() - all.front())) << i;
  }
  EXPECT_GT(all.back() - all.front(), 0.5);
}

TEST(Pictures, HaveNoOtherScale) {
  std::size_t files = 0, scales = 0;
  const std::filesystem::path root = std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "src";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream stream(entry.path());
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    for (const char* word : {"set palette", "hsl(", "hsv2rgb", "rgbformulae"}) {
      if (text.find(word) == std::string::npos) continue;
      EXPECT_EQ(entry.path().filename(), "gnuplot.cpp") << word;
      ++scales;
    }
    ++files;
  }
  EXPECT_GT(files, 100u);
  EXPECT_EQ(scales, 1u);
}

identification::ResidualStructure along(const std::string& coordinate) {
  return {coordinate, false, 0.5, 0.01, {0.0, 1.0}, {-1.0, 1.0}};
}

TEST(Pictures, PanelsAreOfChannelsThatWereLogged) {
  identification::EquationResult equation;
  equation.unit = "Nm";
  for (const char* coordinate : {"output_position_rad", "motor_current_A", "load_torque_Nm",
                                 "power_W", "winding_temperature_K", "electrical_angle"}) {
    equation.structure_before.push_back(along(coordinate));
  }
  const auto shown = [&](const std::vector<std::string>& logged) {
    const std::string script = structure_plot(equation, logged);
    std::vector<std::string> titles;
    static const std::regex kTitle("set xlabel '([^']*)'");
    for (std::sregex_iterator it(script.begin(), script.end(), kTitle), none; it != none; ++it) {
      titles.push_back((*it)[1]);
    }
    return titles;
  };
  using Titles = std::vector<std::string>;
  EXPECT_EQ(shown({"output_position_rad", "winding_voltage_V"}),
            (Titles{"output_position_rad", "electrical_angle, rad"}));
  EXPECT_EQ(shown({"output_position_rad", "motor_current_A"}),
            (Titles{"output_position_rad", "motor_current_A", "electrical_angle, rad"}));
  EXPECT_EQ(shown({"output_position_rad", "output_torque_Nm", "case_temperature_K"}),
            (Titles{"output_position_rad", "load_torque_Nm", "power_W", "winding_temperature_K",
                    "electrical_angle, rad"}));
}

}  // namespace
}  // namespace torquewright::report
