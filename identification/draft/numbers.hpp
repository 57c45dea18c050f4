// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "io/text/units.hpp"

namespace torquewright::identification {

/// What the numbers of a log's columns look like. Series of one log have the same length; what is
/// not a number is passed over.
using Series = std::vector<double>;

/// Whether the numbers only grow, and in steps that are nearly all within half of their median.
bool looks_like_time(const Series& series);

/// The rows, from 0, whose number is less than that of the row before.
std::vector<std::size_t> falls_of(const Series& series);

/// The unit in which the median step is that of a recorder: the first of s, ms, us and ns with 5 to
/// 100,000 rows per second. Empty: none is.
std::optional<io::Unit> unit_of_time(const Series& time);

/// The unit of an angle that jumps back by a whole turn at least twice. Empty: it does not.
std::optional<io::Unit> unit_by_turns(const Series& angle);

/// A velocity against the derivative of its position.
struct Slope {
  double per_second = 0.0;   ///< The velocity's numbers over those of the derivative.
  double correlation = 0.0;  ///< Between -1 and 1.
};

/// Returns how a velocity goes with the derivative of a position by a time in s. Empty where fewer
/// than ten rows hold all three, or one of them rests.
std::optional<Slope> slope_between(const Series& time_s, const Series& position,
                                   const Series& velocity);

/// Whether one series is the other times a factor, to a thousandth of its own size.
bool is_multiple(const Series& one, const Series& other);

}  // namespace torquewright::identification
