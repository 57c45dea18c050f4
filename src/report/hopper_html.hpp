// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/hopper_page.hpp"

namespace torquewright::report {

/// A page that holds its styles and pictures; what users wrote is escaped. Draws with gnuplot:
/// throws io::SpecError for --report where that is not installed. Requires kept traces.
std::string hopper_html(const HopperPage& page);

}  // namespace torquewright::report
