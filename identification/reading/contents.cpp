// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "identification/log/stretch.hpp"
#include "identification/reading/agreement.hpp"
#include "identification/reading/channel.hpp"

namespace torquewright::identification {
namespace {

/// One block of the evidence (reference, section 2, step 5); a shorter stretch holds none.
constexpr double kBlock_s = 1.5;
constexpr std::size_t kFewestSamples = 30;
constexpr std::size_t kFewestOfMap = 20;
/// A fit needs two blocks to compare, the held-out part one.
constexpr double kLeastTrain_s = 2.0 * kBlock_s;
constexpr double kLeastHoldout_s = kBlock_s;
/// Less than this between the ends of its way is no motion: a few counts of a fair encoder.
constexpr double kLeastTravel_rad = 2e-3;
constexpr double kLeastTravel_m = 2e-5;
constexpr double kLeastSpeed_rad_s = 1e-2;
constexpr double kLeastSpeed_m_s = 1e-4;
constexpr double kMuchMasked = 0.3;

struct Range {
  void add(const std::vector<double>& values) {
    for (const double value : values) {
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
  }
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
  bool is_empty() const { return least > greatest; }
  double width() const { return greatest - least; }
  double magnitude() const { return std::max(std::abs(least), std::abs(greatest)); }
};

/// Of all channels, by joint and quantity, in one reading of the log.
using Ranges = std::vector<std::array<Range, kQuantityCount>>;

Ranges ranges_of(const Log& log, std::size_t joints) {
  Ranges ranges(joints);
  for (const Run& run : log.runs) {
    for (std::size_t joint = 0; joint < joints; ++joint) {
      for (std::size_t i = 0; i < kQuantityCount; ++i)
        ranges[joint][i].add(run.joints[joint].of[i]);
    }
  }
  return ranges;
}

const Range& range_of(const Ranges& ranges, const ChannelKey& key) {
  return ranges[key.first][static_cast<std::size_t>(key.second)];
}

/// Of means over short windows, where there is time: an encoder's noise is no motion.
Range range_of_motion(const Log& log, const Ranges& ranges, const ChannelKey& key) {
  Range range;
  if (!log.runs.has(key.first, key.second)) return range;
  for (const Run& run : log.runs) {
    const std::vector<double>& values = run.joints[key.first][key.second];
    if (values.empty()) continue;
    range.add(run.time_s.empty() ? values : means(run, values, values).first);
  }
  return range.is_empty() ? range_of(ranges, key) : range;
}

/// What a rig may well hold constant.
bool may_stand_still(Quantity quantity) {
  constexpr std::array kSteady = {Quantity::kBusVoltage,      Quantity::kWindingTemperature,
                                  Quantity::kCaseTemperature, Quantity::kEnabled,
                                  Quantity::kCommandedTorque, Quantity::kCommandedPosition};
  return std::find(kSteady.begin(), kSteady.end(), quantity) != kSteady.end();
}

/// A sensor of torque or force on a joint that is driven always shows something.
bool is_external_sensor(Quantity quantity) {
  return quantity == Quantity::kOutputTorque || quantity == Quantity::kLinearForce;
}

Weight weight_of_constant(Quantity quantity) {
  if (is_external_sensor(quantity)) return Weight::kError;
  return may_stand_still(quantity) ? Weight::kNote : Weight::kWarning;
}

void report_constant(Log& log, const Ranges& ranges, const Rig& rig) {
  for (std::size_t joint = 0; joint < rig.joints.size(); ++joint) {
    for (std::size_t i = 0; i < kQuantityCount; ++i) {
      const ChannelKey key{joint, static_cast<Quantity>(i)};
      const Range& range = range_of(ranges, key);
      if (range.is_empty() || range.width() > 0.0) continue;
      log.findings.push_back(
          {weight_of_constant(key.second),
           fmt::format("{} is {} {}{}all through the log; nothing can be learned "
                       "from it",
                       describe(key, rig), range.least, unit_of(key.second),
                       unit_of(key.second).empty() ? "" : " ")});
    }
  }
}

/// A velocity that stands beside a position that moves is dead: the position tells the speed.
void drop_dead_velocity(Log& log, Ranges& ranges, const Rig& rig) {
  constexpr std::array<std::pair<Quantity, Quantity>, 3> kPairs = {
      {{Quantity::kOutputPosition, Quantity::kOutputVelocity},
       {Quantity::kMotorPosition, Quantity::kMotorVelocity},
       {Quantity::kLinearPosition, Quantity::kLinearVelocity}}};
  for (std::size_t joint = 0; joint < rig.joints.size(); ++joint) {
    for (const auto& [position, velocity] : kPairs) {
      const Range& still = range_of(ranges, {joint, velocity});
      const Range& moved = range_of(ranges, {joint, position});
      if (still.is_empty() || still.width() > 0.0 || moved.is_empty() || moved.width() == 0.0) {
        continue;
      }
      for (std::size_t i = 0; i < log.runs.size(); ++i) {
        log.runs.change(i, [&, joint = joint, velocity = velocity](Run& run) {
          run.joints[joint][velocity].clear();
        });
      }
      ranges[joint][static_cast<std::size_t>(velocity)] = {};
      log.findings.push_back(
          {Weight::kWarning, fmt::format("{} never changes, though {} does: it is left out",
                                         describe({joint, velocity}, rig), name_of(position))});
    }
  }
}

struct MotionSense {
  Quantity quantity;
  double least;  ///< Of travel, or of speed.
  bool is_speed;
};
/// In the order in which they are believed.
constexpr std::array<MotionSense, 6> kMotionSenses = {
    {{Quantity::kOutputPosition, kLeastTravel_rad, false},
     {Quantity::kMotorPosition, kLeastTravel_rad, false},
     {Quantity::kLinearPosition, kLeastTravel_m, false},
     {Quantity::kOutputVelocity, kLeastSpeed_rad_s, true},
     {Quantity::kMotorVelocity, kLeastSpeed_rad_s, true},
     {Quantity::kLinearVelocity, kLeastSpeed_m_s, true}}};

void report_motionless(Log& log, const Ranges& ranges, const Rig& rig) {
  for (std::size_t joint = 0; joint < rig.joints.size(); ++joint) {
    for (const MotionSense& sense : kMotionSenses) {
      const Range range = range_of_motion(log, ranges, {joint, sense.quantity});
      if (range.is_empty()) continue;
      const double moved = sense.is_speed ? range.magnitude() : range.width();
      if (moved < sense.least) {
        log.findings.push_back(
            {Weight::kError,
             fmt::format("the joint{} never moves: {} {} {:.3g} {}; friction, inertia and whatever "
                         "else moves with it cannot be told",
                         rig.joints[joint].empty() ? "" : " \"" + rig.joints[joint] + "\"",
                         name_of(sense.quantity), sense.is_speed ? "stays below" : "changes by",
                         moved, unit_of(sense.quantity))});
      }
      break;
    }
  }
}

/// The stretches of a log: of pieces, where there are some, their sum.
std::vector<RunHead> stretches_of(const Runs& runs) {
  std::vector<RunHead> stretches;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RunHead& head = runs.head(i);
    if (!head.continues) {
      stretches.push_back(head);
      continue;
    }
    stretches.back().samples += head.samples;
    stretches.back().end_s = head.end_s;
  }
  return stretches;
}

bool is_short(const RunHead& stretch) {
  if (stretch.is_map) return stretch.samples < kFewestOfMap;
  return stretch.samples < kFewestSamples || stretch.end_s - stretch.begin_s < kBlock_s;
}

void report_short(Log& log) {
  std::vector<std::string> names;
  std::size_t count = 0;
  for (const RunHead& stretch : stretches_of(log.runs)) {
    if (!is_short(stretch)) continue;
    ++count;
    if (names.empty() || names.back() != stretch.name) names.push_back(stretch.name);
  }
  if (count == 0) return;
  log.findings.push_back(
      {Weight::kWarning,
       fmt::format("{} stretch{} shorter than {} s ({} samples; {} in a map) in {}: too short to "
                   "weigh evidence",
                   count, count == 1 ? " is" : "es are", kBlock_s, kFewestSamples, kFewestOfMap,
                   describe_runs(names))});
}

/// Seconds, or samples of a map, in stretches of these runs that are not too short.
double usable(const Log& log, const std::vector<std::string>& names, bool is_map) {
  double sum = 0.0;
  for (const RunHead& stretch : stretches_of(log.runs)) {
    if (is_short(stretch) || std::find(names.begin(), names.end(), stretch.name) == names.end()) {
      continue;
    }
    sum += is_map ? static_cast<double>(stretch.samples) : stretch.end_s - stretch.begin_s;
  }
  return sum;
}

/// What else would do where it is gaps that leave too little.
std::string without_gaps(const Log& log, const std::vector<std::string>& names, double least_s) {
  double begin_s = 0.0, end_s = 0.0;
  std::size_t cuts = 0;
  std::string last;
  double whole_s = 0.0;
  for (const RunHead& stretch : stretches_of(log.runs)) {
    if (std::find(names.begin(), names.end(), stretch.name) == names.end()) continue;
    if (stretch.name == last) {
      ++cuts;
    } else {
      whole_s += end_s - begin_s;
      begin_s = stretch.begin_s;
    }
    end_s = stretch.end_s;
    last = stretch.name;
  }
  whole_s += end_s - begin_s;
  if (cuts == 0 || whole_s < least_s) return "";
  return fmt::format(
      ". They last {:.3g} s, which {} gap{} cut: a recorder that never pauses for "
      "longer than {:g} s would do",
      whole_s, cuts, cuts == 1 ? "" : "s", kLongestBridge_s);
}

void report_too_little(Log& log) {
  const bool is_map = log.runs.head(0).is_map;
  const auto check = [&](const std::vector<std::string>& names, double least, const char* what) {
    const double there = usable(log, names, is_map);
    if (there >= least) return;
    log.findings.push_back(
        {Weight::kError, fmt::format("the runs {} hold {:.3g} {} of use, less than the {:.3g} "
                                     "needed: the log cannot tell{}",
                                     what, there, is_map ? "samples" : "s", least,
                                     is_map ? "" : without_gaps(log, names, least))});
  };
  const auto map_samples = static_cast<double>(kFewestOfMap);
  check(log.train_runs, is_map ? map_samples : kLeastTrain_s, "to fit");
  check(log.holdout_runs, is_map ? map_samples : kLeastHoldout_s, "held out");
}

void report_masked(Log& log) {
  double masked = 0.0;
  double samples = 0.0;
  for (const Run& run : log.runs) {
    masked += static_cast<double>(std::count(run.masked.begin(), run.masked.end(), 1));
    samples += static_cast<double>(run.masked.size());
  }
  if (masked <= kMuchMasked * samples) return;
  log.findings.push_back(
      {Weight::kWarning, fmt::format("{:.0f} % of the samples are masked; what is "
                                     "left may not stand for the whole",
                                     100.0 * masked / samples)});
}

}  // namespace

void check_contents(Log& log, const Rig& rig) {
  Ranges ranges = ranges_of(log, rig.joints.size());
  report_constant(log, ranges, rig);
  drop_dead_velocity(log, ranges, rig);
  report_motionless(log, ranges, rig);
  report_short(log);
  report_too_little(log);
  report_masked(log);
}

}  // namespace torquewright::identification
