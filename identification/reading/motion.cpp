// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "identification/reading/agreement.hpp"
#include "identification/reading/channel.hpp"
#include "identification/reading/remedy.hpp"
#include "io/faults/spec_error.hpp"
#include "optimization/fit/quantile.hpp"

namespace torquewright::identification {
namespace {

constexpr double kRadPerDegree = std::numbers::pi / 180.0;
constexpr double kRadPerSecondPerRpm = std::numbers::pi / 30.0;

/// So alike position and velocity must be before a factor between them is believed.
constexpr double kClear = 0.8;
constexpr double kSuspect = 0.3;
constexpr double kWithin = 0.1;  ///< Relative: what counts as that factor.
constexpr std::size_t kFewestWindows = 50;
/// More turns than a pendulum or an arm makes unless it spins.
constexpr double kManyTurns_rad = 6.0 * std::numbers::pi;

struct Pair {
  Quantity position;
  Quantity velocity;
};
constexpr std::array<Pair, 3> kPairs = {{{Quantity::kOutputPosition, Quantity::kOutputVelocity},
                                         {Quantity::kMotorPosition, Quantity::kMotorVelocity},
                                         {Quantity::kLinearPosition, Quantity::kLinearVelocity}}};

constexpr std::array kAngles = {Quantity::kOutputPosition, Quantity::kMotorPosition,
                                Quantity::kCommandedPosition};

bool is_near(double value, double factor) { return std::abs(value / factor - 1.0) < kWithin; }

class MotionCheck {
 public:
  MotionCheck(Log& log, const Rig& rig) : log_(log), rig_(rig) {}

  void joint(std::size_t joint) {
    for (const Quantity quantity : kAngles) check_turn({joint, quantity});
    for (const Pair& pair : kPairs) compare({joint, pair.position}, {joint, pair.velocity});
  }

  void finish() {
    if (!faults_.empty()) throw io::SpecError(std::move(faults_));
  }

 private:
  void refuse(const ChannelKey& key, std::string message) {
    faults_.push_back({rig_.file, path_of(key, rig_), std::move(message)});
  }

  /// An angle that starts anew after 360 is in degrees.
  void check_turn(const ChannelKey& key) {
    if (!log_.runs.has(key.first, key.second)) return;
    for (const Run& run : log_.runs) {
      const std::vector<double>& values = run.joints[key.first][key.second];
      if (values.empty()) continue;
      if (looks_like_turns_of_360(values)) {
        return refuse(key,
                      fmt::format("{} jumps by 360 in run \"{}\": it looks like degrees; {}",
                                  describe(key, rig_), run.name, remedy(key, rig_, kRadPerDegree)));
      }
    }
    const bool hangs = rig_.load.type == LoadType::kPendulum || has_joints(rig_.load.type);
    if (key.second != Quantity::kOutputPosition || !hangs) return;
    check_many_turns(key);
  }

  void check_many_turns(const ChannelKey& key) {
    double widest_rad = 0.0, least_rad = 0.0, greatest_rad = 0.0;
    for (const Run& run : log_.runs) {
      const std::vector<double>& values = run.joints[key.first][key.second];
      if (values.empty()) continue;
      const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
      least_rad = run.continues ? std::min(least_rad, *least) : *least;
      greatest_rad = run.continues ? std::max(greatest_rad, *greatest) : *greatest;
      widest_rad = std::max(widest_rad, greatest_rad - least_rad);
    }
    if (widest_rad < kManyTurns_rad) return;
    log_.findings.push_back(
        {Weight::kWarning,
         fmt::format("{} spans {:.4g} rad in one run, {:.1f} turns of a load that hangs; if the "
                     "column is in degrees, {}",
                     describe(key, rig_), widest_rad, widest_rad / (2.0 * std::numbers::pi),
                     remedy(key, rig_, kRadPerDegree))});
  }

  static bool looks_like_turns_of_360(const std::vector<double>& values) {
    bool jumps = false;
    for (std::size_t i = 1; i < values.size() && !jumps; ++i) {
      const double step = std::abs(values[i] - values[i - 1]);
      jumps = step > 300.0 && step < 363.0;
    }
    return jumps && optimization::nearest_quantile(values, 0.998) -
                            optimization::nearest_quantile(values, 0.002) <=
                        363.0;
  }

  void compare(const ChannelKey& position, const ChannelKey& velocity) {
    if (!log_.runs.has(position.first, position.second)) return;
    if (!log_.runs.has(velocity.first, velocity.second)) return;
    AgreementSums sums;
    for (const Run& run : log_.runs) {
      const Channels& channels = run.joints[position.first];
      if (run.time_s.empty() || !channels.has(position.second) || !channels.has(velocity.second)) {
        continue;
      }
      const Slopes both = slopes(run, channels[position.second], channels[velocity.second]);
      sums.add(both.slope, both.mean);
    }
    const Agreement agreement = sums.result();
    if (agreement.samples < kFewestWindows) return;
    judge_sign(position, velocity, agreement);
    if (std::abs(agreement.correlation) < kClear || position.second == Quantity::kLinearPosition) {
      return;
    }
    judge_unit(position, velocity, agreement.ratio);
  }

  void judge_sign(const ChannelKey& position, const ChannelKey& velocity, const Agreement& found) {
    const std::string sentence =
        fmt::format("{} and d({})/dt have opposite signs (correlation {:.2f})",
                    describe(velocity, rig_), name_of(position.second), found.correlation);
    if (found.correlation <= -kClear) {
      refuse(velocity, fmt::format("{}; turn the one whose sign is not the current's: {}", sentence,
                                   remedy(velocity, rig_, -1.0)));
    } else if (found.correlation <= -kSuspect) {
      log_.findings.push_back({Weight::kWarning, sentence + ": a wrong sign is suspected"});
    }
  }

  void judge_unit(const ChannelKey& position, const ChannelKey& velocity, double ratio) {
    if (is_near(ratio, 1.0 / kRadPerDegree)) {
      refuse(position,
             fmt::format("d({})/dt is {:.1f} times {}: the position looks like degrees; {}",
                         describe(position, rig_), ratio, name_of(velocity.second),
                         remedy(position, rig_, kRadPerDegree)));
    } else if (is_near(ratio, kRadPerDegree) || is_near(ratio, kRadPerSecondPerRpm)) {
      const bool is_rpm = is_near(ratio, kRadPerSecondPerRpm);
      refuse(
          velocity,
          fmt::format("{} is {:.2f} times d({})/dt: it looks like {}; {}", describe(velocity, rig_),
                      1.0 / ratio, name_of(position.second), is_rpm ? "rpm" : "degrees per second",
                      remedy(velocity, rig_, is_rpm ? kRadPerSecondPerRpm : kRadPerDegree)));
    }
  }

  Log& log_;
  const Rig& rig_;
  std::vector<io::Fault> faults_;
};

}  // namespace

void check_motion(Log& log, const Rig& rig) {
  MotionCheck check(log, rig);
  for (std::size_t joint = 0; joint < rig.joints.size(); ++joint) check.joint(joint);
  check.finish();
}

}  // namespace torquewright::identification
