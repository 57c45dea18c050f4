// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "identification/log/runs.hpp"
#include "identification/reading/channel.hpp"

namespace torquewright::identification {

/// Counts the turns of the wrapped angles of one stretch, from piece to piece.
class StretchTurns {
 public:
  explicit StretchTurns(double turn_rad) : turn_rad_(turn_rad) {}

  /// Looks at all pieces of the stretch that begins with run `first`.
  void begin(const Runs& runs, std::size_t first);

  /// Whether the channel is a wrapped angle over the whole stretch; false for channels that are no
  /// angles.
  bool is_wrapped(const ChannelKey& key) const;

  /// Adds whole turns to a piece whose own turns are joined, so that it follows the last piece. Its
  /// own samples are those from `begin` to before `end`; the sample before them is the last of the
  /// piece before.
  void go_on(const ChannelKey& key, std::vector<double>& values, std::size_t begin,
             std::size_t end);

 private:
  double turn_rad_;
  std::vector<ChannelKey> wrapped_;
  std::map<ChannelKey, double> last_rad_;
};

}  // namespace torquewright::identification
