// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot/simulators/region_module.hpp"

namespace torquewright::hopper::region_modules {

extern const RegionModule genesis;
extern const RegionModule isaac_gym;
extern const RegionModule pybullet;

}  // namespace torquewright::hopper::region_modules
