// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace torquewright::report {

enum class PlotFormat { kSvg, kPng };

/// By the file's ending, .svg or .png. Throws io::SpecError for any other.
PlotFormat plot_format(const std::filesystem::path& file);

/// A text as gnuplot's own: in quotes that nothing in it can leave.
std::string gnuplot_quoted(std::string_view text);

/// The first lines of a script: the terminal, of that size in points, and its fonts.
std::string gnuplot_terminal(PlotFormat format, int width, int height);

/// Gives the script to gnuplot (found in PATH, started without a shell, script and data through its
/// stdin) and writes what it draws to the file, whole or not at all. Throws io::SpecError if
/// gnuplot is not installed; std::runtime_error with its words if it fails.
void draw_with_gnuplot(const std::string& script, const std::filesystem::path& file);

}  // namespace torquewright::report
