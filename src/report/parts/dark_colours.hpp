// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace torquewright::report {

/// Red, green and blue from 0 to 1, of sRGB.
using Colour = std::array<double, 3>;

/// "#rrggbb", "rgb(r, g, b)", and the names that gnuplot writes; nothing of other text.
std::optional<Colour> colour_of(std::string_view text);

/// What stands for a colour of white paper on dark paper: light and dark change places in the order
/// of their lightness (that of Oklab), the hue stays. White is the pages' dark paper, black their
/// light ink.
Colour on_dark_paper(const Colour& colour);

/// gnuplot's SVG with a style that shows its colours as on dark paper where the reader's screen is
/// dark. Nothing else of it changes.
std::string with_dark_colours(std::string svg);

/// The id of the element to whose inside the style is held.
inline constexpr std::string_view kCanvas = "gnuplot_canvas";

}  // namespace torquewright::report
