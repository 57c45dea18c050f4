// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/motion/motion.hpp"

namespace torquewright::report {

/// The robot seen from the side (x to the right, z up) at moments spread over its motion, and the
/// path of its centre of mass: an SVG document. Empty where the base's motion is not known.
std::string stick_figures(const hopper::Robot& robot, const hopper::Motion& motion,
                          double ground_height_m);

/// The same view moving in real time, over and over: an SVG document that needs no script.
std::string stick_animation(const hopper::Robot& robot, const hopper::Motion& motion,
                            double ground_height_m);

}  // namespace torquewright::report
