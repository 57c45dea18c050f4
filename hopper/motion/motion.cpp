// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/motion.hpp"

#include <algorithm>

namespace torquewright::hopper {

bool Motion::is_break(Eigen::Index sample) const {
  return std::binary_search(breaks.begin(), breaks.end(), sample);
}

double Motion::step_s(Eigen::Index sample) const {
  return sample + 1 < samples() ? time_s(sample + 1) - time_s(sample) : 0.0;
}

}  // namespace torquewright::hopper
