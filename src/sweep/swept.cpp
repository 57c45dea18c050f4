// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/swept.hpp"

#include <algorithm>

namespace torquewright::sweep {

bool Swept::is_whole() const {
  return std::all_of(points.begin(), points.end(),
                     [](const SweptPoint& point) { return point.row.has_value(); });
}

std::size_t Swept::count(RowVerdict verdict) const {
  const auto is_such = [&](const SweptPoint& point) {
    return point.row && point.row->verdict == verdict;
  };
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), is_such));
}

std::string_view name_of(RowVerdict verdict) {
  switch (verdict) {
    case RowVerdict::kPasses:
      return "pass";
    case RowVerdict::kFails:
      return "fail";
    case RowVerdict::kRefused:
      return "refused";
    default:
      return "undecided";
  }
}

}  // namespace torquewright::sweep
