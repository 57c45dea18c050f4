// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// A channel of a log: the joint's index and the quantity.
using ChannelKey = std::pair<std::size_t, Quantity>;

/// Names a channel in sentences: "motor_current_A", "motor_current_A of the elbow".
std::string describe(const ChannelKey& key, const Rig& rig);

/// Counts how often something was found in each channel, and in which runs.
class Tally {
 public:
  void add(const ChannelKey& key, const std::string& run, std::size_t count);

  struct Entry {
    std::size_t count = 0;
    std::vector<std::string> runs;  ///< Names of the runs in order, each once.
  };
  const std::map<ChannelKey, Entry>& entries() const { return entries_; }

 private:
  std::map<ChannelKey, Entry> entries_;
};

/// Names runs in sentences: "run "a"", or "3 runs (a, b, c)", with no more than a few named.
std::string describe_runs(const std::vector<std::string>& runs);

}  // namespace torquewright::identification
