// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot/mjcf/mjcf_defaults.hpp"
#include "robot/xml/xml.hpp"

namespace torquewright::hopper {

/// The active equality constraints that hold a part of a tree.
struct Equalities {
  std::vector<const Element*> connects;
  std::vector<std::string> freed;  ///< In sentences: what is left out.
};

/// The equalities on the tree below this body. Faults for each that is neither a <connect> nor,
/// where couplings of joints and tendons may be left out, one of these.
Equalities read_equalities(const Element& mujoco, const Element& top, const MjcfDefaults& defaults,
                           bool frees_couplings, Faults& faults);

}  // namespace torquewright::hopper
