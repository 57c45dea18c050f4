// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <set>
#include <string>
#include <vector>

#include "robot/draft/draft.hpp"
#include "robot/xml/element.hpp"

namespace torquewright::hopper {

/// What <flag> of <option> disables in a file's own simulation.
class MjcfFlags {
 public:
  void add(const Element& flag);
  /// Whether one of these is disabled.
  bool disables(std::initializer_list<const char*> flags) const;
  /// Takes from the joints the dampers, springs and dry friction that are disabled. Returns which
  /// joints had some.
  std::vector<std::string> drop_forces(std::vector<DraftBody>& draft) const;

 private:
  std::set<std::string> disabled_;
};

}  // namespace torquewright::hopper
