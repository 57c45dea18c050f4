// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/draft/import_options.hpp"
#include "robot/mjcf/mjcf_defaults.hpp"
#include "robot/xml/xml.hpp"

namespace torquewright::hopper {

/// The active equality constraints that hold a part of a tree.
struct Equalities {
  std::vector<const Element*> connects;
  std::vector<std::string> freed;  ///< In sentences: what is left out.
};

/// The equalities on the tree below this body. Faults for each that is neither a <connect> nor left
/// out by the options: a coupling of joints or tendons, or what is called as a loop that is opened.
/// Of the options' opened loops those that are a <connect>'s, or nothing's, are left.
Equalities read_equalities(const Element& mujoco, const Element& top, const MjcfDefaults& defaults,
                           ImportFileOptions& options, Faults& faults);

}  // namespace torquewright::hopper
