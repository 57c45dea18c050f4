// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::sweep {

/// What a point's answer comes to, whatever the command.
enum class RowVerdict {
  kPasses,
  kFails,
  kOpen,     ///< Undecided, or a limit was reached.
  kRefused,  ///< The command refuses such an input.
};

/// A number of a point; none where there is none.
struct Measure {
  std::string name;  ///< With its unit, as keys of documents.
  std::optional<double> value;
};

/// The answer of one point.
struct SweepRow {
  RowVerdict verdict = RowVerdict::kOpen;
  std::string status;             ///< In the command's words: "pass", "planned", ...
  std::vector<Measure> measures;  ///< Pictures show the first.
  std::string binding;            ///< What limits: "knee: voltage"; empty: nothing is known to.
  std::string why;                ///< Where it does not pass.
};

struct SweptAxis {
  std::string name;
  std::string unit;               ///< Empty: none.
  std::optional<double> present;  ///< What the documents have.
  std::vector<double> values;     ///< Ascending.
};

struct SweptPoint {
  std::vector<double> values;   ///< One an axis.
  std::optional<SweepRow> row;  ///< None: lost, or not done.
  bool is_lost = false;
  std::string why;  ///< Of a loss.
};

/// A sweep that was done, as far as it came.
struct Swept {
  std::string command;  ///< "hopper check"
  std::string subject;  ///< What was swept: the robot's name.
  std::vector<SweptAxis> axes;
  std::vector<SweptPoint> points;  ///< The last axis running first.

  bool is_whole() const;
  /// How many rows have that verdict.
  std::size_t count(RowVerdict verdict) const;
};

std::string_view name_of(RowVerdict verdict);

}  // namespace torquewright::sweep
