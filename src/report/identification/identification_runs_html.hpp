// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/findings/result.hpp"
#include "src/report/parts/html_page.hpp"

namespace torquewright::report {

/// Of its charts, after the stylesheet of pages with charts.
extern const char* const kResidualStyle;

/// Part of a page: measured and predicted over time, what is left of each run before and after, and
/// its error. Empty where an equation has no runs of its own.
std::string runs_section(const identification::EquationResult& equation, Pictures& pictures);

}  // namespace torquewright::report
