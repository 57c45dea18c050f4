// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/constraints/library.hpp"

namespace torquewright::hopper {

const std::vector<const Constraint*>& every_constraint() {
#define TORQUEWRIGHT_LIST(name) &constraints::name,
  static const std::vector<const Constraint*> all{TORQUEWRIGHT_EVERY_CONSTRAINT(TORQUEWRIGHT_LIST)};
#undef TORQUEWRIGHT_LIST
  return all;
}

}  // namespace torquewright::hopper
