// SPDX-License-Identifier: Apache-2.0
#include "identification/rig/load_inertia.hpp"

namespace torquewright::identification {

double load_inertia_kg_m2(const Load& load) {
  switch (load.type) {
    case LoadType::kFree:
      return load.inertia_kg_m2;
    case LoadType::kPendulum:
      return load.inertia_kg_m2 + load.mass_kg * load.length_m * load.length_m;
    case LoadType::kLinearAxis:
      return load.mass_kg;
    case LoadType::kDynamometer:
    case LoadType::kSerialArm:
    case LoadType::kRobot:
      return 0.0;
  }
  return 0.0;
}

}  // namespace torquewright::identification
