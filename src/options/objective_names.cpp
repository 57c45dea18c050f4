// SPDX-License-Identifier: Apache-2.0
#include "src/options/objective_names.hpp"

namespace torquewright::cli {

std::vector<std::string> objective_names() {
  return {"effort", "energy", "gear_load", "region_margin", "height", "time", "cam", "cav", "bav"};
}

}  // namespace torquewright::cli
