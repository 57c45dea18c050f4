// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/stretch_turns.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "identification/reading/wrap.hpp"

namespace torquewright::identification {
namespace {

constexpr std::array kAngles = {Quantity::kOutputPosition, Quantity::kMotorPosition,
                                Quantity::kCommandedPosition};

}  // namespace

void StretchTurns::begin(const Runs& runs, std::size_t first) {
  wrapped_.clear();
  last_rad_.clear();
  std::size_t end = first + 1;
  std::size_t samples = runs.head(first).samples;
  for (; end < runs.size() && runs.head(end).continues; ++end) samples += runs.head(end).samples;
  std::map<ChannelKey, WrapEvidence> evidence;
  for (std::size_t i = first; i < end; ++i) {
    const Run& run = runs[i];
    for (std::size_t joint = 0; joint < run.joints.size(); ++joint) {
      for (const Quantity quantity : kAngles) {
        if (!run.joints[joint].has(quantity)) continue;
        const ChannelKey key{joint, quantity};
        evidence.try_emplace(key, samples, turn_rad_)
            .first->second.add(run.joints[joint][quantity]);
      }
    }
  }
  for (const auto& [key, each] : evidence) {
    if (each.is_wrapped()) wrapped_.push_back(key);
  }
}

bool StretchTurns::is_wrapped(const ChannelKey& key) const {
  return std::find(wrapped_.begin(), wrapped_.end(), key) != wrapped_.end();
}

void StretchTurns::go_on(const ChannelKey& key, std::vector<double>& values, std::size_t begin,
                         std::size_t end) {
  const auto last = last_rad_.find(key);
  if (last != last_rad_.end() && begin > 0) {
    const double turns = std::round((last->second - values[begin - 1]) / turn_rad_);
    for (double& value : values) value += turns * turn_rad_;
  }
  last_rad_[key] = values[end - 1];
}

}  // namespace torquewright::identification
