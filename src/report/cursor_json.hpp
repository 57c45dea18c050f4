// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/report/hopper_charts.hpp"
#include "src/report/stick_figures.hpp"

namespace torquewright::report {

/// What the page's script moves its marks by, as JSON that may stand inside an HTML element: names
/// hold no character that could end it. `figure` is null where there is none.
std::string cursor_json(const ChartSource& source, const std::vector<Eigen::Index>& samples,
                        const MovingFigure* figure, double begin_s);

}  // namespace torquewright::report
