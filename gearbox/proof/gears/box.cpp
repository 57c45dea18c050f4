// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/box.hpp"

namespace torquewright::gearbox::proof {

bool Box::is_empty() const {
  for (std::size_t i = 0; i < lower.size(); ++i) {
    if (lower[i] > upper[i]) return true;
  }
  return false;
}

bool Box::contains(const Point& point) const {
  for (std::size_t i = 0; i < lower.size(); ++i) {
    if (point[i] < lower[i] || point[i] > upper[i]) return false;
  }
  return true;
}

std::int64_t Box::size_up_to(std::int64_t enough) const {
  if (is_empty()) return 0;
  std::int64_t size = 1;
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const std::int64_t width = upper[i] - lower[i] + 1;
    if (width > enough / size) return enough + 1;
    size *= width;
  }
  return size;
}

std::size_t Box::widest_variable() const {
  std::size_t widest = 0;
  for (std::size_t i = 1; i < lower.size(); ++i) {
    if (upper[i] - lower[i] > upper[widest] - lower[widest]) widest = i;
  }
  return widest;
}

std::array<Box, 2> halves(const Box& box) {
  const std::size_t variable = box.widest_variable();
  const std::int64_t middle = box.lower[variable] + (box.upper[variable] - box.lower[variable]) / 2;
  std::array<Box, 2> result{box, box};
  result[0].upper[variable] = middle;
  result[1].lower[variable] = middle + 1;
  return result;
}

}  // namespace torquewright::gearbox::proof
