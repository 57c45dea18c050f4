// SPDX-License-Identifier: Apache-2.0
// Oklab: Bjoern Ottosson, "A perceptual color space for image processing", 2020.
#include "src/report/parts/dark_colours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

namespace torquewright::report {
namespace {

/// Those of pages in the dark: html_page.cpp.
constexpr std::string_view kDarkPaper = "#1b2027";
constexpr std::string_view kLightInk = "#dde3ea";
/// Lines of middle lightness are to stand out more than the shades between paper and grid.
constexpr double kPower = 0.6;

/// Lightness from 0 to 1, and the two axes of colour.
struct Oklab {
  double lightness = 0.0;
  double a = 0.0;
  double b = 0.0;
};

double linear(double part) {
  return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

double encoded(double part) {
  return part <= 0.0031308 ? 12.92 * part : 1.055 * std::pow(part, 1.0 / 2.4) - 0.055;
}

Oklab oklab_of(const Colour& colour) {
  const double r = linear(colour[0]), g = linear(colour[1]), b = linear(colour[2]);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

/// Linear parts; outside 0 to 1 where no screen has the colour.
Colour linear_of(const Oklab& lab) {
  const auto cubed = [](double value) { return value * value * value; };
  const double l = cubed(lab.lightness + 0.3963377774 * lab.a + 0.2158037573 * lab.b);
  const double m = cubed(lab.lightness - 0.1055613458 * lab.a - 0.0638541728 * lab.b);
  const double s = cubed(lab.lightness - 0.0894841775 * lab.a - 1.2914855480 * lab.b);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool is_on_screens(const Colour& parts) {
  constexpr double kRounding = 1e-4;
  return std::all_of(parts.begin(), parts.end(),
                     [](double part) { return part >= -kRounding && part <= 1.0 + kRounding; });
}

/// The colour of that lightness and hue, paler where screens have none so strong.
Colour shown(Oklab lab) {
  constexpr double kPaler = 0.95;
  while (!is_on_screens(linear_of(lab)) && std::hypot(lab.a, lab.b) > 1e-3) {
    lab.a *= kPaler;
    lab.b *= kPaler;
  }
  Colour colour = linear_of(lab);
  for (double& part : colour) part = std::clamp(encoded(std::clamp(part, 0.0, 1.0)), 0.0, 1.0);
  return colour;
}

std::optional<Colour> hexadecimal(std::string_view text) {
  if (text.size() != 7) return std::nullopt;
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i) {
    int value = 0;
    const char* from = text.data() + 1 + 2 * i;
    if (std::from_chars(from, from + 2, value, 16).ptr != from + 2) return std::nullopt;
    colour[i] = value / 255.0;
  }
  return colour;
}

/// Of "12, 34,  56".
std::optional<Colour> three_numbers(std::string_view text) {
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i) {
    text.remove_prefix(std::min(text.find_first_not_of(", "), text.size()));
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || value < 0 || value > 255) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    colour[i] = value / 255.0;
  }
  return colour;
}

std::string hexadecimal(const Colour& colour) {
  const auto byte = [](double part) { return static_cast<int>(std::lround(255.0 * part)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour[0]), byte(colour[1]), byte(colour[2]));
}

/// The attribute that begins at `at`, its quotes' inside; nothing where none does.
std::string_view attribute_at(std::string_view svg, std::size_t at, std::string_view name) {
  std::string_view rest = svg.substr(at + name.size());
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  if (!rest.starts_with('=')) return {};
  rest.remove_prefix(1);
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  if (rest.empty() || (rest.front() != '\'' && rest.front() != '"')) return {};
  const std::size_t end = rest.find(rest.front(), 1);
  return end == std::string_view::npos ? std::string_view() : rest.substr(1, end - 1);
}

/// Each attribute's colours, once.
std::set<std::pair<std::string_view, std::string_view>> coloured_attributes(std::string_view svg) {
  std::set<std::pair<std::string_view, std::string_view>> found;
  for (const std::string_view name : {"fill", "stroke", "color"}) {
    for (std::size_t at = svg.find(name); at != std::string_view::npos;
         at = svg.find(name, at + 1)) {
      const std::string_view value = attribute_at(svg, at, name);
      if (colour_of(value)) found.emplace(name, value);
    }
  }
  return found;
}

}  // namespace

std::optional<Colour> colour_of(std::string_view text) {
  if (text == "black") return Colour{0.0, 0.0, 0.0};
  if (text == "gray") return Colour{0.5, 0.5, 0.5};
  if (text.starts_with('#')) return hexadecimal(text);
  if (text.starts_with("rgb(") && text.ends_with(')')) {
    return three_numbers(text.substr(4, text.size() - 5));
  }
  return std::nullopt;
}

Colour on_dark_paper(const Colour& colour) {
  const Oklab paper = oklab_of(*colour_of(kDarkPaper));
  const Oklab ink = oklab_of(*colour_of(kLightInk));
  Oklab lab = oklab_of(colour);
  const double share = std::pow(std::clamp(1.0 - lab.lightness, 0.0, 1.0), kPower);
  const auto between = [share](double from, double to) { return from + share * (to - from); };
  lab.lightness = between(paper.lightness, ink.lightness);
  // The tint of paper and ink themselves.
  lab.a += between(paper.a, ink.a);
  lab.b += between(paper.b, ink.b);
  return shown(lab);
}

std::string with_dark_colours(std::string svg) {
  const std::size_t canvas = svg.find("<g id=\"" + std::string(kCanvas));
  if (canvas == std::string::npos) return svg;
  std::string rules;
  for (const auto& [name, value] : coloured_attributes(svg)) {
    rules += fmt::format("#{} [{}='{}']{{{}:{}}}\n", kCanvas, name, value, name,
                         hexadecimal(on_dark_paper(*colour_of(value))));
  }
  return svg.insert(
      canvas, "<style>@media screen and (prefers-color-scheme:dark){\n" + rules + "}</style>\n");
}

}  // namespace torquewright::report
