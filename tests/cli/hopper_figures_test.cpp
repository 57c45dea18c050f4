// SPDX-License-Identifier: Apache-2.0
// What --figures draws of a motion. Oracle: the centre of mass that --series prints, read back from
// the picture by the numbers at its own axes.
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "io/files/csv.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

/// Of an axis: where numbers stand on paper.
struct Ticks {
  std::vector<double> place;
  std::vector<double> value_m;

  double scale() const {
    return (place.back() - place.front()) / (value_m.back() - value_m.front());
  }
  double value_at(double on_paper) const {
    return value_m.front() + (on_paper - place.front()) / scale();
  }
};

/// A line of the grid and the number behind it, of one of the axes.
Ticks ticks(const std::string& svg, const std::string& style, std::size_t coordinate) {
  const std::regex pair(
      "<line class=\"grid\" x1=\"([-.0-9]+)\" y1=\"([-.0-9]+)\"[^>]*/>\n<text class=\"words " +
      style + "\"[^>]*>([-.0-9]+)</text>");
  Ticks found;
  for (std::sregex_iterator it(svg.begin(), svg.end(), pair), none; it != none; ++it) {
    found.place.push_back(std::stod((*it)[coordinate]));
    found.value_m.push_back(std::stod((*it)[3]));
  }
  return found;
}

struct Seen {
  double time_s = 0.0, x = 0.0, y = 0.0;
};

std::vector<Seen> centres(const std::string& svg) {
  static const std::regex pose(
      "<title>([.0-9]+) s[^<]*</title>[^c]*(?:<line[^>]*/>\n)*<circle cx=\"([-.0-9]+)\" "
      "cy=\"([-.0-9]+)\"");
  const std::size_t begin = svg.find("<g class=\"overlaid\">");
  const std::string overlaid = svg.substr(begin, svg.find("</g>\n</g>", begin) - begin);
  std::vector<Seen> found;
  for (std::sregex_iterator it(overlaid.begin(), overlaid.end(), pose), none; it != none; ++it) {
    found.push_back({std::stod((*it)[1]), std::stod((*it)[2]), std::stod((*it)[3])});
  }
  return found;
}

TEST(HopperFigures, AreInMetresAlongBothAxes) {
  const Workplace place;
  const Outcome outcome = place.run({"hopper", "check", in_specs("robot/hopper.json"),
                                     in_specs("trajectory/hopper_flip.csv"), "--figures",
                                     "flip.svg", "--series", "series.csv"});
  ASSERT_EQ(outcome.exit_code, 1) << outcome.err;
  const std::string svg = place.text("flip.svg");
  const Ticks x = ticks(svg, "middle", 1), z = ticks(svg, "end", 2);
  ASSERT_GE(x.place.size(), 2u);
  ASSERT_GE(z.place.size(), 2u);
  EXPECT_NEAR(x.scale(), -z.scale(), 0.002 * x.scale());  // paper's y runs downwards
  const std::vector<Seen> seen = centres(svg);
  ASSERT_EQ(seen.size(), 12u);
  io::CsvReader series(place.path("series.csv"));
  const auto time = series.find("time_s"), way = series.find("center_of_mass_x_m"),
             height = series.find("center_of_mass_z_m");
  ASSERT_TRUE(time && way && height);
  const double near_m = 0.3 / x.scale() + 0.01;  // tenths of a pixel; times are of 10 ms
  std::size_t next = 0;
  while (series.next() && next < seen.size()) {
    if (series.number(*time) < seen[next].time_s - 0.0051) continue;
    EXPECT_NEAR(x.value_at(seen[next].x), series.number(*way), near_m) << seen[next].time_s;
    EXPECT_NEAR(z.value_at(seen[next].y), series.number(*height), 4.0 * near_m);
    ++next;
  }
  EXPECT_GE(next, 11u);
}

}  // namespace
}  // namespace torquewright::cli_test
