// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "robot/xml/element.hpp"

namespace torquewright::hopper {

/// Geoms that <contact><pair> lets touch others whatever their masks say, by name, and the pair's
/// friction as stated; "" where it states none.
using MjcfPairs = std::map<std::string, std::string>;

MjcfPairs contact_pairs(const Element& mujoco);

/// A geom with masks and friction as its pair has them; as it is where no pair names it.
Element as_paired(const Element& geom, const MjcfPairs& pairs);

}  // namespace torquewright::hopper
