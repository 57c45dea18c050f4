// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace torquewright::report {

enum class PlotFormat { kSvg, kPng };

/// The format of a picture by its file's ending, .svg or .png. Throws io::SpecError for any other.
PlotFormat plot_format(const std::filesystem::path& file);

/// A text as gnuplot's own: in quotes that nothing in it can leave.
std::string gnuplot_quoted(std::string_view text);

/// The first lines of a script: the terminal, of that size in points, and its fonts.
std::string gnuplot_terminal(PlotFormat format, int width, int height);

/// A scale of colours whose lightness rises from end to end, so that it orders for all eyes and in
/// print: no rainbow. A line of a script.
std::string gnuplot_palette();

/// Gives the script to gnuplot (found in PATH, started without a shell, script and data through its
/// stdin); what it draws, as an SVG with the script's words as titles and colours for dark screens
/// (plot_words.hpp, dark_colours.hpp). Throws io::SpecError for `option` if gnuplot is not
/// installed; std::runtime_error with its words if it fails.
std::string picture_by_gnuplot(const std::string& script, const std::string& option = "--plot");

/// Throws io::SpecError for `option` if gnuplot is not installed: for before the work.
void require_gnuplot(const std::string& option);

/// Writes what gnuplot draws to the file, whole or not at all. Throws as picture_by_gnuplot.
void draw_with_gnuplot(const std::string& script, const std::filesystem::path& file);

}  // namespace torquewright::report
