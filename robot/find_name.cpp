// SPDX-License-Identifier: Apache-2.0
#include "robot/find_name.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::hopper {

std::optional<std::size_t> find_name(const std::vector<std::string>& known, const std::string& name,
                                     const std::string& what, io::Fault place,
                                     std::vector<io::Fault>& faults) {
  const auto found = std::find(known.begin(), known.end(), name);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  place.message = fmt::format("no {} is named \"{}\"", what, name);
  if (const auto close = io::nearest(name, known)) {
    place.message += fmt::format("; did you mean \"{}\"?", *close);
  } else if (!known.empty()) {
    place.message += "; there are " + io::listed(known);
  }
  faults.push_back(std::move(place));
  return std::nullopt;
}

}  // namespace torquewright::hopper
