// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/faults/spec_error.hpp"

namespace torquewright::hopper {

/// A joint's ends, as indices of bodies.
struct Ends {
  std::string joint;
  std::string path;  ///< JSON pointer of the joint.
  std::size_t parent;
  std::size_t child;
};

/// One body of the tree, parents first.
struct Place {
  std::size_t body;
  const Ends* joint = nullptr;  ///< That carries it; none for the base.
};

/// Sorts bodies so that parents come first. Adds a fault for every body that two joints carry, that
/// hangs on none, or whose joints lead back to it: then the result is empty or incomplete.
std::vector<Place> tree_order(const std::vector<std::string>& bodies, std::size_t base,
                              const std::vector<Ends>& joints, const std::string& file,
                              std::vector<io::Fault>& faults);

}  // namespace torquewright::hopper
