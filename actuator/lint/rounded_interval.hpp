// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace torquewright::actuator::lint {

/// A number with the interval that its rounding leaves open, and the JSON pointers of the numbers
/// that it was made from.
struct RoundedInterval {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
  std::vector<std::string> pointers;
};

/// Returns half a unit of the last decimal of the shortest decimal fraction that reads back as the
/// value: 0.32 -> 0.005, 10 -> 0.5. A JSON reader drops trailing zeros: 20.0 is 20 here, so the
/// interval may be wider than what was printed, never narrower. 0 is exact: it says that there is
/// none.
double half_unit(double value);

/// The interval of values that would be printed as this one: half a unit of its last decimal on
/// either side. Requires value >= 0.
RoundedInterval rounded(double value, std::string pointer);

/// Returns an exact number: one that is counted, or a condition under which something else is
/// stated.
RoundedInterval exact(double value, std::string pointer = "");

/// Whether only one end bounds the number: it is stated as a bound, or follows from one.
bool is_one_sided(const RoundedInterval& interval);

/// Whether some number lies in both intervals (to round-off).
bool overlap(const RoundedInterval& one, const RoundedInterval& other);

/// Whether all of `one` lies above all of `other` (by more than round-off).
bool lies_above(const RoundedInterval& one, const RoundedInterval& other);

/// Returns the pointers of both, each once.
std::vector<std::string> united(std::vector<std::string> pointers,
                                const std::vector<std::string>& more);

/// Returns f of the intervals, with its extremes over the corners of their intervals. Requires f to
/// be monotone in each argument over them, so that no interior point lies outside.
template <typename Function, typename... Intervals>
RoundedInterval derive(const Function& f, const Intervals&... intervals) {
  constexpr std::size_t kCount = sizeof...(Intervals);
  const std::array<const RoundedInterval*, kCount> inputs{&intervals...};
  const auto at = [&]<std::size_t... kIndex>(std::size_t corner, std::index_sequence<kIndex...>) {
    return f(((corner >> kIndex) % 2 == 0 ? inputs[kIndex]->low : inputs[kIndex]->high)...);
  };
  RoundedInterval result;
  result.value = f(intervals.value...);
  result.low = result.high = result.value;
  for (std::size_t corner = 0; corner < (std::size_t{1} << kCount); ++corner) {
    const double extreme = at(corner, std::make_index_sequence<kCount>());
    result.low = std::min(result.low, extreme);
    result.high = std::max(result.high, extreme);
  }
  for (const RoundedInterval* input : inputs)
    result.pointers = united(result.pointers, input->pointers);
  return result;
}

}  // namespace torquewright::actuator::lint
