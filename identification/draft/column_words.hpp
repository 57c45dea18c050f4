// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/text/units.hpp"

namespace torquewright::identification {

/// A column's name taken apart: "FL_hip_qd_rad_s" is the words FL, hip, qd and the unit rad/s.
struct ColumnWords {
  std::vector<std::string> words;  ///< Without the unit, as they are written.
  std::optional<io::Unit> unit;    ///< The unit that the name ends with or holds in brackets.
  std::optional<io::Unit> other;   ///< One that the name has besides, and that contradicts it.
  std::string ampere;              ///< "rms" or "peak", where unit or words say whose ampere it is.
};

/// Takes a column's name apart at everything that is no letter or digit, where a small letter is
/// followed by a large one, and between a word and a number at its end. `unit_below` is the unit
/// that stands under the header; it counts before the name's. Empty: none stands there.
ColumnWords words_of(std::string_view column, std::string_view unit_below);

}  // namespace torquewright::identification
