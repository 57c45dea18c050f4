// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Bodies, their joints, sites at contact points; with `collides` also shapes without mass. Bodies
/// without mass, of which MuJoCo knows none that moves, become further joints of the body that they
/// carry; a fixed base without mass is the world itself. `has_stiff_friction`: dry friction of
/// joints as a constraint of the shortest time that MuJoCo allows. `references`: LoopedRobot's, or
/// empty.
void write_bodies(tinyxml2::XMLPrinter& out, const Robot& robot, const dynamics::Tree& tree,
                  const std::vector<double>& references, bool collides, bool has_stiff_friction);

/// Our bodies in MuJoCo's order: depth first.
std::vector<std::size_t> mjcf_order(const dynamics::Tree& tree);

}  // namespace torquewright::hopper
