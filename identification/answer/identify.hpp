// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "actuator/motor/actuator_spec.hpp"
#include "identification/answer/analysis.hpp"
#include "identification/findings/result.hpp"

namespace torquewright::identification {

/// The nominal actuator of one joint. `joint` is empty unless the rig is a serial arm.
struct JointActuator {
  std::string joint;
  actuator::ReadActuator nominal;
};

struct IdentifyOptions {
  bool select = true;  ///< False: stop after the residual structure, without a search for effects.
  AnalysisOptions analysis;  ///< `select` and `progress` in it are overwritten from here.
  /// Offer a table over the coordinate along which most of the residual is left.
  bool empirical = false;
  std::function<void(const std::string& what, double share_done)> progress;
};

/// A smooth table over one coordinate, for what no physical effect explains.
struct EmpiricalTable {
  std::string coordinate;
  bool times_direction = false;
  std::vector<double> at, level;
  /// Share of what is left that the table explains on data it was not fitted to.
  double share = 0.0;
};

/// The outcome for one log on one rig.
struct Identification {
  Verdict verdict = Verdict::kCannotTell;
  std::vector<EquationResult> equations;  ///< The equations of every joint.
  std::size_t leading = 0;  ///< Index of the equation whose figures the report shows first.
  std::vector<DataFinding> findings;
  std::vector<std::string> train_runs, holdout_runs;
  std::vector<Log::File> files;
  std::vector<EmpiricalTable> tables;  ///< Filled with `empirical` only.
  std::vector<std::string> not_asked;  ///< Effects that the options excluded.
};

/// The one verdict that its equations come to, unless the data themselves forbid one.
Verdict verdict_of_equations(const Identification& found);

/// Reads the logs and analyses every joint of the rig. Throws io::SpecError where what is read
/// cannot be used.
Identification identify(const std::vector<std::filesystem::path>& logs, const Rig& rig,
                        const std::vector<JointActuator>& actuators,
                        const IdentifyOptions& options = {});

}  // namespace torquewright::identification
