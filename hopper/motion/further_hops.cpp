// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/further_hops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dynamics/position_step.hpp"
#include "hopper/motion/channel.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr const char* kOption = "--hops";

/// The samples that follow each other as often as is asked for: [from, until).
struct Cycle {
  Index from = 0;
  Index until = 0;
  double lasts_s = 0.0;
  VectorXd way_m;  ///< Along the ground, of the first coordinates of a position.
};

bool flies(const Motion& motion, Index sample) {
  return (motion.touching.col(sample).array() == 0.0).all();
}

/// The first sample in the air of each flight that the motion takes off to.
std::vector<Index> take_offs(const Motion& motion) {
  std::vector<Index> samples;
  for (Index i = 1; i < motion.samples(); ++i) {
    if (flies(motion, i) && !flies(motion, i - 1)) samples.push_back(i);
  }
  return samples;
}

/// How many coordinates of a position say where along the ground the base is.
Index places(const Robot& robot) { return robot.tree.base == dynamics::BaseKind::kSpatial ? 2 : 1; }

/// What a row of positions' differences or of velocities is called in a file.
std::string name_of(const Robot& robot, ChannelKind kind, Index row) {
  for (const Channel& channel : channels_of(robot)) {
    if (channel.kind == kind && channel.row == row) return channel.owner;
  }
  return "base";
}

/// Refuses take-offs between which more than the place along the ground differs.
void require_alike(const Robot& robot, const Motion& motion, const Cycle& cycle) {
  const Index n = motion.velocities.rows(), along = places(robot);
  VectorXd off(n);
  dynamics::position_difference(robot.tree, motion.positions.col(cycle.from),
                                motion.positions.col(cycle.until), off);
  off.head(along).setZero();
  const VectorXd rates = motion.velocities.col(cycle.until) - motion.velocities.col(cycle.from);
  Index row = 0, rate = 0;
  const double place = off.cwiseAbs().maxCoeff(&row), faster = rates.cwiseAbs().maxCoeff(&rate);
  const bool is_place = place / kAlike > faster / kAlikeRate;
  if (is_place ? place <= kAlike : faster <= kAlikeRate) return;
  io::refuse(
      motion.file,
      fmt::format("{}: the take-offs at t = {} and {} s are not alike: {}'s {} differs by "
                  "{:.3g} {}, where {:g} may be left; `hopper flip --repeat 2 --alike` plans such",
                  kOption, io::time_text(motion.time_s(cycle.from)),
                  io::time_text(motion.time_s(cycle.until)),
                  // Velocities have a row each, positions of a turned base do not.
                  name_of(robot, ChannelKind::kVelocity, is_place ? row : rate),
                  is_place ? "position" : "velocity", is_place ? place : faster,
                  is_place ? "m or rad" : "m/s or rad/s", is_place ? kAlike : kAlikeRate));
}

void require_repeatable(const Motion& motion, std::size_t flights_there, int flights) {
  const auto refuse = [&](const std::string& why) {
    io::refuse(motion.file, fmt::format("{} {}: {}", kOption, flights, why));
  };
  if (!motion.has_base || motion.velocity_origin != Origin::kGiven) {
    refuse("the motion does not say where and how fast the base moves");
  }
  if (!motion.has_touching) refuse("the motion has no columns that say which contacts touch");
  if (!motion.ground.is_flat()) refuse("hops go on and on over flat ground alone");
  if (flights_there < 2) {
    refuse(fmt::format("the motion takes off {}, and what goes on lies between two take-offs",
                       flights_there == 0 ? "never" : "once"));
  }
  if (flights_there > static_cast<std::size_t>(flights)) {
    refuse(fmt::format("the motion flies {} times already", flights_there));
  }
}

/// A table's columns with the cycle's `times` over before its end.
void extend(const Cycle& cycle, int times, MatrixXd& table) {
  if (table.cols() == 0) return;
  const Index length = cycle.until - cycle.from, rest = table.cols() - cycle.until;
  MatrixXd longer(table.rows(), table.cols() + times * length);
  longer.leftCols(cycle.until) = table.leftCols(cycle.until);
  for (int i = 0; i < times; ++i) {
    longer.middleCols(cycle.until + i * length, length) = table.middleCols(cycle.from, length);
  }
  longer.rightCols(rest) = table.rightCols(rest);
  table = std::move(longer);
}

/// How often the cycle has gone round before a sample of the longer motion.
int rounds_before(const Cycle& cycle, int times, Index sample) {
  return std::clamp(static_cast<int>((sample - cycle.from) / (cycle.until - cycle.from)), 0, times);
}

void extend_times(const Cycle& cycle, int times, Motion& motion) {
  const Index length = cycle.until - cycle.from, samples = motion.samples() + times * length;
  std::vector<double> times_s;
  std::vector<Index> breaks;
  for (Index i = 0; i < samples; ++i) {
    const int rounds = i < cycle.until ? 0 : rounds_before(cycle, times, i);
    const Index source = i - rounds * length;
    times_s.push_back(motion.time_s(source) + rounds * cycle.lasts_s);
    if (motion.is_break(source)) breaks.push_back(i);
    if (rounds > 0) motion.positions.col(i).head(cycle.way_m.size()) += rounds * cycle.way_m;
  }
  motion.times_s = std::move(times_s);
  motion.breaks = std::move(breaks);
}

}  // namespace

Motion with_flights(const Robot& robot, Motion motion, int flights) {
  const std::vector<Index> starts = motion.has_touching ? take_offs(motion) : std::vector<Index>();
  require_repeatable(motion, starts.size(), flights);
  Cycle cycle{starts[starts.size() - 2], starts.back(), 0.0, {}};
  cycle.lasts_s = motion.time_s(cycle.until) - motion.time_s(cycle.from);
  cycle.way_m =
      (motion.positions.col(cycle.until) - motion.positions.col(cycle.from)).head(places(robot));
  require_alike(robot, motion, cycle);
  const int times = flights - static_cast<int>(starts.size());
  for (MatrixXd* table :
       {&motion.positions, &motion.velocities, &motion.accelerations, &motion.efforts,
        &motion.forces_N, &motion.touching, &motion.acceleration_doubt}) {
    extend(cycle, times, *table);
  }
  extend_times(cycle, times, motion);
  return motion;
}

}  // namespace torquewright::hopper
