// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/channel.hpp"

#include <fmt/format.h>

#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kMostRunsListed = 6;

}  // namespace

std::string describe(const ChannelKey& key, const Rig& rig) {
  const std::string& joint = rig.joints[key.first];
  const std::string name(name_of(key.second));
  return joint.empty() ? name : fmt::format("{} of the joint \"{}\"", name, joint);
}

void Tally::add(const ChannelKey& key, const std::string& run, std::size_t count) {
  if (count == 0) return;
  Entry& entry = entries_[key];
  entry.count += count;
  if (entry.runs.empty() || entry.runs.back() != run) entry.runs.push_back(run);
}

std::string describe_runs(const std::vector<std::string>& runs) {
  if (runs.size() == 1) return fmt::format("run \"{}\"", runs.front());
  std::vector<std::string> named = runs;
  const bool is_long = named.size() > kMostRunsListed;
  if (is_long) named.resize(kMostRunsListed);
  return fmt::format("{} runs ({}{})", runs.size(), io::listed(named), is_long ? ", ..." : "");
}

}  // namespace torquewright::identification
