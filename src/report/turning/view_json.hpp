// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/turning/turning_view.hpp"

namespace torquewright::report {

/// What the script of the turning view reads, as JSON that may stand inside an HTML element. Poses
/// are little-endian numbers in base64.
std::string view_json(const hopper::Robot& robot, const TurningView& view);

/// The figure of a page: the canvas and its buttons, hidden until the script finds WebGL, the view
/// from the side (an SVG element), which stands for print and where there is none, and the keys of
/// both (page_parts.hpp).
std::string view_figure(const std::string& robot_name, const TurningView& view,
                        const std::string& from_the_side, const std::string& keys);

}  // namespace torquewright::report
