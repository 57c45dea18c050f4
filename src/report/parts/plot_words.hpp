// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace torquewright::report {

/// What the plots of each `plot` command of a script are called, in order: their titles, or the
/// words behind `notitle`, which gnuplot passes over. Empty: a plot says nothing.
std::vector<std::vector<std::string>> plot_names(std::string_view script);

/// gnuplot's SVG with the script's words as its titles, which readers hear and pointers show, where
/// gnuplot writes its own name and numbers; a plot without words has none.
std::string with_plot_words(std::string_view svg, std::string_view script);

}  // namespace torquewright::report
