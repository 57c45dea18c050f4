// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/moments.hpp"

#include <algorithm>

namespace torquewright::report {
namespace {

using Eigen::Index;

struct Stretch {
  double from_s;
  double until_s;
};

double duration_s(const std::vector<Stretch>& stretches) {
  double sum_s = 0.0;
  for (const Stretch& stretch : stretches) sum_s += stretch.until_s - stretch.from_s;
  return sum_s;
}

std::vector<Stretch> between(const hopper::Motion& motion, const std::vector<Stretch>& flights) {
  std::vector<Stretch> ground;
  double from_s = motion.times_s.front();
  for (const Stretch& flight : flights) {
    if (flight.from_s > from_s) ground.push_back({from_s, flight.from_s});
    from_s = flight.until_s;
  }
  if (motion.times_s.back() > from_s) ground.push_back({from_s, motion.times_s.back()});
  return ground;
}

/// Where that much of the stretches' time has gone by.
double time_after(const std::vector<Stretch>& stretches, double gone_s) {
  for (const Stretch& stretch : stretches) {
    const double length_s = stretch.until_s - stretch.from_s;
    if (gone_s <= length_s) return stretch.from_s + gone_s;
    gone_s -= length_s;
  }
  return stretches.back().until_s;
}

Index nearest_sample(const hopper::Motion& motion, double time_s) {
  const auto next = std::lower_bound(motion.times_s.begin(), motion.times_s.end(), time_s);
  const Index at = std::min<Index>(next - motion.times_s.begin(), motion.samples() - 1);
  const bool is_past = at > 0 && motion.time_s(at) - time_s > time_s - motion.time_s(at - 1);
  return is_past ? at - 1 : at;
}

/// From end to end where `to_ends`, else in the middle of equal parts.
void spread(const hopper::Motion& motion, const std::vector<Stretch>& stretches, int count,
            bool to_ends, bool flies, std::vector<Moment>& moments) {
  const double whole_s = duration_s(stretches);
  for (int i = 0; i < count; ++i) {
    const double share = to_ends ? i / std::max(1.0, count - 1.0) : (i + 0.5) / count;
    moments.push_back({nearest_sample(motion, time_after(stretches, share * whole_s)), flies});
  }
}

}  // namespace

std::vector<Moment> moments_of(const hopper::Motion& motion,
                               const std::vector<hopper::Flight>& flights, int count) {
  std::vector<Stretch> flown;
  for (const hopper::Flight& flight : flights) flown.push_back({flight.from_s, flight.until_s});
  const std::vector<Stretch> ground = between(motion, flown);
  std::vector<Moment> moments;
  if (duration_s(flown) <= 0.0) {
    spread(motion, {{motion.times_s.front(), motion.times_s.back()}}, count, true, false, moments);
  } else if (ground.empty()) {
    spread(motion, flown, count, true, true, moments);
  } else {
    spread(motion, flown, count / 2, false, true, moments);
    spread(motion, ground, count - count / 2, true, false, moments);
  }
  std::stable_sort(moments.begin(), moments.end(), [](const Moment& one, const Moment& other) {
    return one.sample < other.sample;
  });
  return moments;
}

}  // namespace torquewright::report
