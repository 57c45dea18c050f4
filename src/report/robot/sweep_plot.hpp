// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/parts/gnuplot.hpp"
#include "src/sweep/swept.hpp"

namespace torquewright::report {

/// A script for gnuplot: the first measure over the quantity that was swept, or as a map over two;
/// each point marked by its verdict, the documents' own value by a line. Empty where no point has
/// the measure.
std::string sweep_plot(PlotFormat format, const sweep::Swept& swept);

}  // namespace torquewright::report
