// SPDX-License-Identifier: Apache-2.0
// Words and colours of gnuplot's pictures. Oracles: a script written by hand with what gnuplot
// makes of it; contrast after WCAG 2.1.
#include "src/report/parts/plot_words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/report/parts/dark_colours.hpp"
#include "src/report/parts/gnuplot.hpp"
#include "src/report/parts/html_page.hpp"

namespace torquewright::report {
namespace {

constexpr const char* kScript =
    "set title 'One, of two'\n"
    "$d << EOD\n1 2\n2 3\nEOD\n"
    "set multiplot layout 1,2 title 'All & more'\n"
    "plot sin(x + atan2(x, 1)) with lines title 'a sine', \\\n  $d using 1:2 with lines notitle, "
    "cos(x) with lines notitle 'a cosine'\n"
    "plot $d using ($1 > 1 ? $1 : NaN):2 with points notitle 'points, ''x'\n"
    "unset multiplot\n";

TEST(PlotWords, AreThoseOfTheScript) {
  const std::string data = "$e << END\nplot 'no command' title 'none'\nEND\n";
  const auto names = plot_names(data + kScript);
  ASSERT_EQ(names.size(), 2u);
  EXPECT_EQ(names[0], (std::vector<std::string>{"a sine", "", "a cosine"}));
  EXPECT_EQ(names[1].size(), 1u);
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++found;
  }
  return found;
}

TEST(PlotWords, TakeThePlaceOfGnuplotsNumbers) {
  const std::string svg =
      picture_by_gnuplot(gnuplot_terminal(PlotFormat::kSvg, 300, 200) + kScript);
  EXPECT_EQ(svg.find("<title>gnuplot_plot"), std::string::npos);
  EXPECT_EQ(svg.find("<title>Gnuplot"), std::string::npos);
  EXPECT_NE(svg.find("<title>All &amp; more</title>"), std::string::npos);
  EXPECT_NE(svg.find("<g id=\"gnuplot_plot_1a\" ><title>a sine</title>"), std::string::npos);
  EXPECT_NE(svg.find("<g id=\"gnuplot_plot_3a\" ><title>a cosine</title>"), std::string::npos);
  EXPECT_NE(svg.find("<g id=\"gnuplot_plot_1b\" ><title>points, "), std::string::npos);
  EXPECT_EQ(count(svg, "<title>"), 4u);  // the second plot says nothing
}

/// WCAG 2.1, 1.4.3.
double luminance(const Colour& colour) {
  const auto part = [](double value) {
    return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * part(colour[0]) + 0.7152 * part(colour[1]) + 0.0722 * part(colour[2]);
}

double contrast(const Colour& one, const Colour& other) {
  const auto [less, more] = std::minmax({luminance(one), luminance(other)});
  return (more + 0.05) / (less + 0.05);
}

Colour dark(const char* text) { return on_dark_paper(*colour_of(text)); }

TEST(DarkColours, LeaveLinesLegible) {
  const Colour paper = dark("#ffffff");
  for (const char* line :
       {"black", "#0072b2", "#d55e00", "#cc79a7", "#009e73", "#b8a100", "#555555", "#a00020",
        "#000000", "#7030a0", "rgb( 73,  86, 107)", "#b3261e", "#00795a", "#8a3ffc", "#333333"}) {
    EXPECT_GE(contrast(dark(line), paper), 3.0) << line;  // of graphics: WCAG 2.1, 1.4.11
  }
  EXPECT_GE(contrast(dark("black"), paper), 10.0);
  EXPECT_LT(contrast(dark("#eef1f4"), paper), 1.8);  // a shade stays one
}

// A scale orders in the dark too, the other way round.
TEST(DarkColours, KeepTheOrderOfAScale) {
  double before = 1.0;
  for (const char* step : {"#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"}) {
    EXPECT_LT(luminance(dark(step)), before - 0.03) << step;
    before = luminance(dark(step));
  }
}

TEST(DarkColours, AreReadInAllForms) {
  EXPECT_EQ(*colour_of("#ff0080"), (Colour{1.0, 0.0, 128 / 255.0}));
  EXPECT_EQ(*colour_of("rgb(255,0,128)"), *colour_of("#ff0080"));
  EXPECT_EQ(*colour_of("rgb(255,   0, 128)"), *colour_of("#ff0080"));
  for (const char* none :
       {"none", "currentColor", "#12", "rgb(1,2)", "rgb(300,0,0)", "", "#gg0000"}) {
    EXPECT_FALSE(colour_of(none)) << none;
  }
}

// The style is of the picture alone, also within a page.
TEST(DarkColours, AreHeldToThePicture) {
  const std::string svg = picture_by_gnuplot(gnuplot_terminal(PlotFormat::kSvg, 300, 200) +
                                             "plot x lc rgb '#d55e00'\n");
  EXPECT_NE(svg.find("@media screen and (prefers-color-scheme:dark)"), std::string::npos);
  EXPECT_NE(svg.find("#gnuplot_canvas [fill='#ffffff']{fill:#1b2027}"), std::string::npos) << svg;
  const std::string within = inline_svg(svg, "p7_");
  EXPECT_NE(within.find("#p7_gnuplot_canvas [fill='#ffffff']"), std::string::npos);
  EXPECT_EQ(within.find("#gnuplot_canvas ["), std::string::npos);
}

}  // namespace
}  // namespace torquewright::report
