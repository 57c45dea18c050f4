// SPDX-License-Identifier: Apache-2.0
#include "identification/answer/identify.hpp"

#include <algorithm>
#include <functional>
#include <mutex>
#include <numeric>
#include <set>

#include "identification/answer/alike_split.hpp"
#include "identification/answer/allowed_equations.hpp"
#include "identification/answer/analysis.hpp"
#include "identification/findings/joint_verdicts.hpp"
#include "identification/findings/with_effects.hpp"
#include "identification/findings/written.hpp"
#include "identification/forward/candidates.hpp"
#include "identification/reading/against_actuator.hpp"
#include "identification/reading/read_log.hpp"
#include "identification/reading/robot_commands.hpp"
#include "identification/rollout/side_by_side.hpp"

namespace torquewright::identification {
namespace {

bool has_error(const std::vector<DataFinding>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const DataFinding& each) { return each.weight == Weight::kError; });
}

Verdict overall(const std::vector<EquationResult>& equations,
                const std::vector<DataFinding>& findings) {
  if (has_error(findings)) return Verdict::kCannotTell;
  std::vector<const EquationResult*> all;
  for (const EquationResult& each : equations) all.push_back(&each);
  return verdict_of_all(all);
}

/// The first equation with an effect; else the torque's, which comes first.
std::size_t leading(const std::vector<EquationResult>& equations) {
  const auto first = std::find_if(equations.begin(), equations.end(),
                                  [](const EquationResult& each) { return !each.added.empty(); });
  return first == equations.end() ? 0 : static_cast<std::size_t>(first - equations.begin());
}

std::vector<EmpiricalTable> tables_of(const std::vector<EquationResult>& equations) {
  std::vector<EmpiricalTable> tables;
  for (const EquationResult& equation : equations) {
    if (equation.structure_after.empty()) continue;
    const ResidualStructure& strongest = equation.structure_after.front();
    if (!is_significant(strongest)) continue;
    tables.push_back({strongest.coordinate, strongest.times_direction, strongest.centre,
                      strongest.level, strongest.share});
  }
  return tables;
}

/// What the equations say of the data rather than of the actuator.
void add_findings(Identification& found) {
  for (const EquationResult& each : found.equations) {
    if (!each.not_one_rig.empty()) found.findings.push_back({Weight::kError, each.not_one_rig});
    for (const SpectralLine& line : each.lines) {
      if (!is_of_the_data(line)) continue;
      const std::string whose =
          each.joint.empty() ? each.quantity : each.joint + " " + each.quantity;
      found.findings.push_back({Weight::kWarning, sentence_of(line, whose, each.unit)});
    }
  }
}

/// The share of all joints' work that is done, told by whoever works on one of them.
class JointsProgress {
 public:
  using Show = std::function<void(const std::string& what, double share)>;
  JointsProgress(std::size_t joints, const Show& show) : shares_(joints, 0.0), show_(show) {}

  void show(std::size_t joint, const std::string& what, double share) {
    if (!show_) return;
    const std::lock_guard lock(telling_);
    shares_[joint] = share;
    const double sum = std::accumulate(shares_.begin(), shares_.end(), 0.0);
    show_(what, sum / static_cast<double>(shares_.size()));
  }

 private:
  std::mutex telling_;
  std::vector<double> shares_;
  const Show& show_;
};

std::vector<std::string> effects_not_asked(const AnalysisOptions& options) {
  std::vector<std::string> names = nameable_effects();
  std::erase_if(names, [&](const std::string& name) { return options.asks(name); });
  return names;
}

}  // namespace

Verdict verdict_of_equations(const Identification& found) {
  return overall(found.equations, found.findings);
}

Identification identify(const std::vector<std::filesystem::path>& logs, const Rig& rig,
                        const std::vector<JointActuator>& actuators,
                        const IdentifyOptions& options) {
  Log log = read_log(logs, rig);
  std::vector<actuator::Actuator> stated;
  for (const JointActuator& each : actuators) stated.push_back(each.nominal.actuator);
  check_against(log, rig, stated);
  check_equations(log, rig);
  std::vector<const actuator::Actuator*> nominal;
  for (const JointActuator& each : actuators) nominal.push_back(&each.nominal.actuator);
  split_alike(log, rig, nominal, options.analysis);
  Identification found;
  found.findings = log.findings;
  found.train_runs = log.train_runs;
  found.holdout_runs = log.holdout_runs;
  found.files = log.files;
  const std::vector<bool> moves = moving_joints(rig, log);
  JointsProgress progress(rig.joints.size(), options.progress);
  auto by_joint =
      side_by_side<std::vector<EquationResult>>(log, rig.joints.size(), [&](std::size_t joint) {
        AnalysisOptions analysis = options.analysis;
        // No names from such data.
        analysis.select = options.select && !has_error(log.findings) && moves[joint];
        analysis.progress = [&](const std::string& what, double share) {
          progress.show(joint, what, share);
        };
        return analyse(rig, log, joint, nominal, analysis);
      });
  for (std::size_t joint = 0; joint < by_joint.size(); ++joint) {
    for (EquationResult& each : by_joint[joint]) {
      if (has_error(log.findings) || !moves[joint]) each.verdict = Verdict::kCannotTell;
      found.equations.push_back(std::move(each));
    }
  }
  found.not_asked = effects_not_asked(options.analysis);
  add_findings(found);
  found.verdict = verdict_of_equations(found);
  found.leading = leading(found.equations);
  if (options.empirical) found.tables = tables_of(found.equations);
  return found;
}

}  // namespace torquewright::identification
