// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/hops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dynamics/gravity.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::hopper {
namespace {

// What a stance between two flights usually takes: where speed alone is asked for, it makes the
// stride (trial: of four hops at 0.8 m/s).
constexpr double kUsualStance_s = 0.35;
// Room beside an edge on either side of it, which a foot that passes it takes.
constexpr double kRoom_m = 0.035;

std::size_t count_of_flights(const std::vector<Stance>& stances) {
  return static_cast<std::size_t>(std::count_if(stances.begin(), stances.end(),
                                                [](const Stance& one) { return one.is_flight(); }));
}

/// From the first take-off to the last touch-down the foot goes all strides; of hops that are alike
/// to the last take-off, by when it has gone all but one.
void set_pace(double flights, const PlanOptions& options, PlanGoal& goal) {
  if (!options.speed_m_s) return;
  const double strides = options.has_alike_hops ? flights - 1.0 : flights;
  if (!goal.stride_m) {
    const double flight_s = 2.0 * std::sqrt(2.0 * options.rise_m / dynamics::kGravity_m_s2);
    goal.stride_m = *options.speed_m_s * (flight_s + kUsualStance_s * (flights - 1.0) / strides);
  }
  goal.hops_s = strides * *goal.stride_m / *options.speed_m_s;
}

void require_flat_between(const std::vector<Stance>& stances) {
  bool is_flat = true;
  for (const Stance& stance : stances) {
    if (stance.is_flight() && !is_flat) {
      io::refuse("--land-at",
                 "says where edges of the ground are by where the foot stands between flights: "
                 "--contacts needs a 'flat' between any two of them");
    }
    if (stance.is_flight()) is_flat = false;
    if (stance.name == "flat") is_flat = true;
  }
}

void require_room(double stride_m, double foot_m) {
  const double least_m = foot_m + 2.0 * kRoom_m;
  if (std::abs(stride_m) >= least_m) return;
  io::refuse("--land-at", fmt::format("a foot of {:.3g} m needs room on either side of an edge: a "
                                      "--stride of {:.3g} m or more, and it is {:.3g} m",
                                      foot_m, least_m, std::abs(stride_m)));
}

/// Edges between the places where the foot stands, from the left.
simulation::GroundProfile profile_of(const std::vector<double>& landings_m, double stride_m,
                                     const PlanModel& model) {
  const double middle_m =
      0.5 * (model.plane.sole.front().point.p_B_m.x() + model.plane.sole.back().point.p_B_m.x());
  simulation::GroundProfile ground;
  ground.heights_m.push_back(0.0);
  for (std::size_t i = 0; i < landings_m.size(); ++i) {
    if (landings_m[i] == ground.heights_m.back()) continue;
    const double edge_m = middle_m + stride_m * (static_cast<double>(i) + 0.5);
    ground.edges_x_m.push_back(std::round(1e4 * edge_m) / 1e4);  // of few digits, for a reader
    ground.heights_m.push_back(landings_m[i]);
  }
  if (ground.is_flat()) return {};
  if (stride_m < 0.0) {
    std::reverse(ground.edges_x_m.begin(), ground.edges_x_m.end());
    std::reverse(ground.heights_m.begin(), ground.heights_m.end());
  }
  return ground;
}

}  // namespace

void set_hops(const std::vector<Stance>& stances, const PlanModel& model,
              const PlanOptions& options, PlanGoal& goal) {
  const std::size_t flights = count_of_flights(stances);
  set_pace(static_cast<double>(flights), options, goal);
  if (options.landings_m.empty()) return;
  if (options.landings_m.size() > flights) {
    io::refuse("--land-at", fmt::format("says the ground of {} landings, and there are {}",
                                        options.landings_m.size(), flights));
  }
  goal.landings_m = options.landings_m;
  goal.landings_m.resize(flights, options.landings_m.back());
  goal.ground = profile_of(goal.landings_m, *goal.stride_m, model);
  if (goal.ground.is_flat()) return;
  require_flat_between(stances);
  require_room(*goal.stride_m, model.foot_length_m);
}

}  // namespace torquewright::hopper
