// SPDX-License-Identifier: Apache-2.0
// Zero points of the log's channels.
#include "identification/effects/families.hpp"

namespace torquewright::identification {

void add_offsets(DictionaryBuilder& builder) {
  const std::size_t constant =
      builder.add("offset", [](const Signals&, std::size_t) { return 1.0; });
  builder.variant("torque_offset", {one(constant, -kInfinity, kInfinity)}, EffectFamily::kLog);
}

}  // namespace torquewright::identification
