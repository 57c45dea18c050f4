// SPDX-License-Identifier: Apache-2.0
// What a plan of the documented hopper's flip costs, from a cold guess: iterations, seconds, and
// which share of them are derivatives; the rest is the solver's, nearly all of it factorisation.
// Then how far apart plans from perturbed guesses end. Arguments: numbers of intervals (100 180).
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "hopper/planning/search/plan.hpp"
#include "robot/model/robot_spec.hpp"

namespace {

using torquewright::hopper::PlanOptions;
using torquewright::hopper::PlanResult;
using torquewright::hopper::PlanRound;
using torquewright::hopper::Robot;

constexpr double kNoise_rad = 0.15;
constexpr unsigned kSeeds = 3;

void print_rounds(const char* guess, const PlanResult& result) {
  double seconds = 0.0;
  for (const PlanRound& round : result.rounds) {
    seconds += round.seconds;
    const double share = round.seconds > 0.0 ? round.derivative_seconds / round.seconds : 0.0;
    fmt::print("{:<10} {:>9} {:>10} {:>8.2f} {:>11.0f} % {:>5.0f} % {:>10.1f} {:>10.2g}  {}\n",
               guess, round.intervals, round.iterations, round.seconds, 100.0 * share,
               100.0 * (1.0 - share), 1e3 * round.seconds / round.iterations,
               round.integration_error_rad, round.solver);
  }
  fmt::print("{:<10} {} in {:.1f} s of the solver, objective {:.8g}\n", "", name_of(result.status),
             seconds, result.objective);
  std::fflush(stdout);
}

void measure(const Robot& robot, int intervals) {
  PlanOptions options;
  options.intervals = intervals;
  print_rounds("cold", plan_motion(robot, options));
  options.guess_noise_rad = kNoise_rad;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    options.guess_seed = seed;
    print_rounds(fmt::format("seed {}", seed).c_str(), plan_motion(robot, options));
  }
}

}  // namespace

int main(int count, char** words) {
  const Robot robot =
      torquewright::hopper::read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  fmt::print("{:<10} {:>9} {:>10} {:>8} {:>13} {:>7} {:>10} {:>10}\n", "guess", "intervals",
             "iterations", "s", "derivatives", "rest", "ms each", "error rad");
  std::vector<int> every;
  for (int i = 1; i < count; ++i) every.push_back(std::atoi(words[i]));
  if (every.empty()) every = {100, 180};
  for (const int intervals : every) measure(robot, intervals);
}
