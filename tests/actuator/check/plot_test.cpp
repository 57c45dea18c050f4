// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "src/report/actuator/region_plot.hpp"
#include "src/report/parts/gnuplot.hpp"
#include "tests/actuator/check/refusal.hpp"
#include "tests/actuator/check/simple_actuator.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::report {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool is_gnuplot_there() {
  try {
    const test::ScratchFolder folder;
    draw_with_gnuplot(gnuplot_terminal(PlotFormat::kSvg, 100, 100) + "plot x\n",
                      folder.path() / "x.svg");
    return true;
  } catch (const io::SpecError&) {
    return false;
  }
}

actuator::MorTable table() {
  return actuator::mor_table(actuator::Region(test::simple_actuator(), {}));
}

TEST(Plot, FormatIsTheFilesEnding) {
  EXPECT_EQ(plot_format("a.svg"), PlotFormat::kSvg);
  EXPECT_EQ(plot_format("b/c.png"), PlotFormat::kPng);
  EXPECT_EQ(test::refusal([] { plot_format("a.pdf"); }),
            "--plot: \"a.pdf\" must end with .svg or .png");
}

// gnuplot would run what stands in `...` within double quotes; within single ones nothing.
TEST(Plot, TextCannotLeaveItsQuotes) {
  EXPECT_EQ(gnuplot_quoted("'it's''"), "'\u2019it\u2019s\u2019\u2019'");
  EXPECT_EQ(gnuplot_quoted("k]]>x > y]>"), "'k]] >x > y]>'");
  EXPECT_EQ(gnuplot_quoted("a\n`touch x`\n"), "'a`touch x`'");
}

TEST(Plot, DrawsBothFormats) {
  if (!is_gnuplot_there()) GTEST_SKIP() << "gnuplot is not installed";
  const test::ScratchFolder folder;
  const std::vector<PlottedRegion> regions{{"48 V", table()}, {"36 V", table()}};
  draw_with_gnuplot(region_plot(PlotFormat::kSvg, "it's `x`", regions), folder.path() / "r.svg");
  const std::string svg = bytes_of(folder.path() / "r.svg");
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("limited by voltage"), std::string::npos);
  EXPECT_NE(svg.find("it\u2019s `x`"), std::string::npos);
  const std::vector<PlottedMotion> motions{
      {"knee", table(), {{0.0, 1.0, 2.0, false}, {0.5, 40.0, 29.0, true}}}};
  draw_with_gnuplot(motion_plot(PlotFormat::kPng, "motion", motions), folder.path() / "m.png");
  EXPECT_TRUE(bytes_of(folder.path() / "m.png").starts_with("\x89PNG"));
  draw_with_gnuplot(motion_plot(PlotFormat::kSvg, "motion", motions), folder.path() / "m.svg");
  EXPECT_NE(bytes_of(folder.path() / "m.svg").find("outside the region"), std::string::npos);
}

TEST(Plot, SaysWhatIsMissingWithoutGnuplot) {
  const test::ScratchFolder folder;
  const std::string path = ::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);
  const std::string refusal =
      test::refusal([&] { draw_with_gnuplot("plot x\n", folder.path() / "x.svg"); });
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(refusal,
            "--plot: gnuplot, which draws the picture, is not installed (Debian: gnuplot-nox)");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "x.svg"));
}

}  // namespace
}  // namespace torquewright::report
