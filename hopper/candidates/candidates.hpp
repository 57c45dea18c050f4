// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hopper/candidates/candidate_set.hpp"
#include "hopper/check/hopper_check.hpp"

namespace torquewright::hopper {

/// Source of a candidate's torques.
enum class CandidateTorques {
  kDynamics,       ///< Dynamics of the robot with the candidate in it.
  kExchangedFile,  ///< The file's, less what the dynamics with the old rotor (and mass) ask for,
                   ///< more what those with the candidate's do.
};

/// Result of one candidate in one drivetrain, all others as the robot has them.
struct CandidateResult {
  std::size_t drivetrain = 0;
  std::string name;
  double ratio = 1.0;
  actuator::Verdict verdict = actuator::Verdict::kPass;
  /// Least distance of a torque to its bound over the greatest torque at rest; negative: so much is
  /// missing.
  double margin_share = 0.0;
  std::optional<double> speed_margin_rad_s;
  std::optional<double> mass_kg;  ///< Mass of the drivetrain's actuators.
  /// Energy drawn less energy returned; nothing of a drive that is known by its curve, as the next.
  std::optional<double> energy_J;
  std::optional<double> copper_loss_J;  ///< Heat of the windings in one run.
  double peak_torque_Nm = 0.0;  ///< Greatest torque at the joint, its rotor's part included.
  double rotor_inertia_kg_m2 = 0.0;
  CandidateTorques torques = CandidateTorques::kDynamics;
  /// Whether it is on the front of margin, mass, energy and heat, among those that pass.
  bool is_on_front = false;
  std::string why;  ///< Where it does not pass: the first violation, on one line.
};

/// Every candidate in every drivetrain, to be tried one by one. Its demand is that of the dynamics
/// with its rotor and ratio, and with its mass where both masses are known and the drivetrain says
/// where they are mounted; what a file holds of torques is that of another rotor and counts only if
/// `options.torques` is kFile, or where there are no dynamics: then what the exchange changes is
/// added to it. Torques of the dynamics have the doubt of torque_doubts(), with the candidate's
/// rotor; where it decides, the verdict is undecided. Where nothing says whether the file's torques
/// hold the old rotor's, both readings are judged, undecided if they differ. `report` is
/// check_motion()'s of the same. Refers to what it is made of.
class CandidateTrials {
 public:
  CandidateTrials(const Robot& robot, const Motion& motion, const CheckOptions& options,
                  const HopperReport& report, const CandidateSet& candidates);
  ~CandidateTrials();

  std::size_t size() const;
  /// Names the trial by its drivetrain and its candidate; no two share a name.
  std::string name_of(std::size_t number) const;
  /// Tries one candidate. May be called by several threads at once.
  CandidateResult result_of(std::size_t number) const;
  /// Returns a result for a candidate that was not tried, with the reason.
  CandidateResult untried(std::size_t number, std::string why) const;

 private:
  struct Ready;
  std::unique_ptr<const Ready> ready_;
};

/// Sorts results: those that pass come first in each drivetrain, by margin; the others after them,
/// by margin too.
std::vector<CandidateResult> ranked(std::vector<CandidateResult> results);

/// Tries all candidates and ranks them. `threads` is at least 1.
std::vector<CandidateResult> try_candidates(
    const Robot& robot, const Motion& motion, const CheckOptions& options,
    const HopperReport& report, const CandidateSet& candidates, std::size_t threads,
    const std::function<void(double share)>& on_progress = {});

}  // namespace torquewright::hopper
