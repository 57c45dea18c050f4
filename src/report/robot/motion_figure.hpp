// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/robot/hopper_page.hpp"

namespace torquewright::report {

/// A motion seen from the side (x to the right, z up) as an SVG document: above where the robot is
/// at moments, half of them in flight, on axes in metres of one scale; below each moment by itself,
/// at the same scale as its neighbours. Empty where the base's motion is not known.
std::string motion_figure(const HopperPage& page);

}  // namespace torquewright::report
