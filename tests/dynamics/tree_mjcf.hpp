// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "dynamics/tree.hpp"

namespace torquewright::test {

/// The tree as MuJoCo reads it: an oracle's input, apart from our exporter. Joints are numbered
/// depth first there: rows() leads from MuJoCo's rows of velocity to ours.
std::string mjcf_of(const dynamics::Tree& tree);

/// Row of ours for each of MuJoCo's rows of velocity.
std::vector<Eigen::Index> rows_of_mujoco(const dynamics::Tree& tree);

}  // namespace torquewright::test
