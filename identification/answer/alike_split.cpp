// SPDX-License-Identifier: Apache-2.0
#include "identification/answer/alike_split.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "identification/answer/analysis.hpp"
#include "identification/reading/holdout.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kFewestRuns = 3;
/// Between what is left where it was held out and where it was fitted: beyond it one part holds
/// nine tenths of all that is to be explained, however the runs share the time.
constexpr double kFarMore = 3.0;

/// Squares of what the stated actuators leave of the joints' torques, in noise floors.
struct LeftAsStated {
  double train = 0.0, holdout = 0.0;
  std::map<std::string, double> by_run;
};

LeftAsStated left_as_stated(const Log& log, const Rig& rig,
                            const std::vector<const actuator::Actuator*>& actuators,
                            const AnalysisOptions& options) {
  LeftAsStated left;
  for (std::size_t joint = 0; joint < rig.joints.size(); ++joint) {
    for (const EquationResult& each : analyse(rig, log, joint, actuators, options)) {
      if (each.runs.empty() || !(each.noise_floor_rms > 0.0) || each.is_noise_before) continue;
      const auto floors2 = [&](double rms) { return std::pow(rms / each.noise_floor_rms, 2); };
      left.train += floors2(each.before.train_rms);
      left.holdout += floors2(each.before.holdout_rms);
      for (const RunResult& run : each.runs) left.by_run[run.run] += floors2(run.rms_before);
    }
  }
  return left;
}

std::vector<std::string> every_third_by_size(const std::map<std::string, double>& by_run) {
  std::vector<std::pair<double, std::string>> sorted;
  for (const auto& [run, square] : by_run) sorted.emplace_back(-square, run);
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::string> names;
  for (std::size_t i = 1; i < sorted.size(); i += 3) names.push_back(sorted[i].second);
  return names;
}

}  // namespace

void split_alike(Log& log, const Rig& rig, const std::vector<const actuator::Actuator*>& actuators,
                 AnalysisOptions options) {
  const std::size_t runs = log.train_runs.size() + log.holdout_runs.size();
  if (!rig.holdout_runs.empty() || runs < kFewestRuns) return;
  options.select = false;
  options.progress = nullptr;  // of the analysis that follows
  const LeftAsStated left = left_as_stated(log, rig, actuators, options);
  if (left.by_run.size() != runs || left.train == 0.0 || left.holdout == 0.0) return;
  const double ratio = std::sqrt(left.holdout / left.train);
  if (ratio < kFarMore && ratio > 1.0 / kFarMore) return;
  hold_out_instead(
      log, every_third_by_size(left.by_run),
      fmt::format("the rig names no holdout_runs, and the last third of the runs, which are held "
                  "out otherwise, leave {:.3g} times what the others leave of the stated model: "
                  "every third run is held out, by what is left in it",
                  ratio));
}

}  // namespace torquewright::identification
