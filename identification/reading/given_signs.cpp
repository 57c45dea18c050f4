// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/given_signs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/reading/channel.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::identification {
namespace {

/// Samples before which what was asked for has changed its sign; zeros keep the sign before.
std::vector<std::size_t> changes_of(const std::vector<double>& asked) {
  std::vector<std::size_t> changes;
  double sign = 0.0;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (asked[i] == 0.0) continue;
    if (sign * asked[i] < 0.0) changes.push_back(i);
    sign = asked[i];
  }
  return changes;
}

/// The sample about a change at which the magnitude is least: from half-way to the change before
/// until half-way to the next.
std::size_t turn_at(const std::vector<double>& time_s, const std::vector<double>& magnitude,
                    const std::vector<std::size_t>& changes, std::size_t change) {
  const std::size_t at = changes[change];
  std::size_t first = change > 0 ? (changes[change - 1] + at + 1) / 2 : 0;
  std::size_t last = change + 1 < changes.size() ? (at + changes[change + 1]) / 2 : time_s.size();
  while (first < at && time_s[at] - time_s[first] > kLatestAnswer_s) ++first;
  while (last > at + 1 && time_s[last - 1] - time_s[at] > kLatestAnswer_s) --last;
  const auto begin = magnitude.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = magnitude.begin() + static_cast<std::ptrdiff_t>(last);
  return static_cast<std::size_t>(std::min_element(begin, end) - magnitude.begin());
}

void require_magnitudes(const Rig& rig, const ChannelKey& key, const Run& run) {
  const std::vector<double>& values = run.joints[key.first][key.second];
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] < 0.0)) continue;
    io::refuse(
        rig.file,
        fmt::format("{} is said to have no sign (\"sign\": \"none\") and is {:g} {} at t = {} "
                    "s of run \"{}\"; leave the key out",
                    describe(key, rig), values[i], unit_of(key.second),
                    io::time_text(run.time_s[i]), run.name));
  }
}

void give_sign(const Rig& rig, const ChannelKey& key, Log& log) {
  const std::size_t joint = key.first;
  const Quantity quantity = key.second;
  if (!log.runs.has(joint, Quantity::kCommandedTorque) || log.runs.head(0).is_map) {
    io::refuse(rig.file,
               describe(key, rig) +
                   " has no sign; it takes that of the torque that was asked for, which the log "
                   "must hold by time (commanded_torque_Nm, or the law under \"controller\" with "
                   "commanded_position_rad)");
  }
  for (std::size_t i = 0; i < log.runs.size(); ++i) {
    log.runs.change(i, [&](Run& run) {
      require_magnitudes(rig, key, run);
      Channels& channels = run.joints[joint];
      channels[quantity] =
          with_signs(run.time_s, channels[quantity], channels[Quantity::kCommandedTorque]);
    });
  }
  log.findings.push_back(
      {Weight::kNote, fmt::format("{} was logged without a sign: it has that of the torque that "
                                  "was asked for, and turns where it is least within {:g} ms",
                                  describe(key, rig), 1e3 * kLatestAnswer_s)});
}

}  // namespace

std::vector<double> with_signs(const std::vector<double>& time_s,
                               const std::vector<double>& magnitude,
                               const std::vector<double>& asked) {
  const auto first =
      std::find_if(asked.begin(), asked.end(), [](double each) { return each != 0.0; });
  double sign = first != asked.end() && *first < 0.0 ? -1.0 : 1.0;
  const std::vector<std::size_t> changes = changes_of(asked);
  std::vector<double> values = magnitude;
  std::size_t from = 0;
  for (std::size_t change = 0; change <= changes.size(); ++change) {
    const std::size_t until =
        change < changes.size() ? turn_at(time_s, magnitude, changes, change) : values.size();
    for (std::size_t i = from; i < until; ++i) values[i] *= sign;
    from = std::max(from, until);
    sign = -sign;
  }
  return values;
}

void give_signs(const Rig& rig, Log& log) {
  for (const ColumnUse& use : rig.columns) {
    if (use.has_sign) continue;
    for (std::size_t joint = 0; joint < rig.joints.size(); ++joint) {
      if (!use.joint.empty() && use.joint != rig.joints[joint]) continue;
      give_sign(rig, {joint, use.quantity}, log);
    }
  }
}

}  // namespace torquewright::identification
