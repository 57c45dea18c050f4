// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/oracles/sampled_bench/rigging.hpp"
#include "tests/oracles/sampled_bench/situation.hpp"
#include "tests/oracles/sampled_bench/sizes.hpp"

namespace torquewright::oracles::sampled {

/// What no effect of the library describes.
struct OutsideKind {
  std::string name;
  LoadKind load;
  bool both_encoders;  ///< It shows between them.
  bool dry_friction;   ///< It changes a declared Coulomb friction.
  std::vector<std::string> coordinates;
};

const std::vector<OutsideKind>& outside_kinds();
/// Puts it into the situation with a strength between 0 and 1.
void set_outside(Situation& situation, const OutsideKind& kind, double strength,
                 std::uint64_t seed);
Equation equation_of_outside(const std::string& kind);

}  // namespace torquewright::oracles::sampled
