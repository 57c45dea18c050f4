// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"
#include "hopper/planning/plane/variable_numbers.hpp"

namespace torquewright::hopper {

/// Where in a plan a constraint is asked.
struct Site {
  const PlanModel& model;
  const PlanGoal& goal;
  const PlanOptions& options;
  const std::vector<MeshPhase>& mesh;
  const std::vector<PhaseVariables>& phases;
  std::shared_ptr<SagittalScratch> scratch;  ///< For rows; null where limits are asked for.
  std::size_t phase = 0;
  std::size_t index = 0;  ///< Of the interval or the instant within the phase.
  Eigen::Index row = 0;   ///< The moving row or the joint, of those that move.

  const Stance& stance() const { return mesh[phase].stance; }
  const Stance& stance_before() const { return mesh[phase - 1].stance; }
  const PhaseVariables& variables() const { return phases[phase]; }
  /// The instant; where an interval is meant, the one that it begins with is points[2 * index].
  const PointVariables& point() const { return variables().points[index]; }
  /// Height of the ground where the phase stands, or takes off.
  double ground_m() const { return hopper::ground_m(goal, mesh, phase); }
  bool is_last_phase() const { return phase + 1 == mesh.size(); }
  /// What its rows are called: "heel: impact".
  std::string named(std::string_view what) const {
    return stance().name + ": " + std::string(what);
  }

  Eigen::Index moving() const { return model.plane.moving_count(); }  ///< m
  Eigen::Index joints() const { return moving() - 3; }                ///< k
  Eigen::Index drives() const { return static_cast<Eigen::Index>(model.plane.drive_count()); }
  Eigen::Index forces() const { return static_cast<Eigen::Index>(stance().force_count()); }
  /// Pitch and joints of an instant (m - 2), on which all but places depends; their rates.
  std::vector<int> posture(const PointVariables& at) const {
    return numbers_from(at.position + 2, moving() - 2);
  }
  std::vector<int> posture_rates(const PointVariables& at) const {
    return numbers_from(at.velocity + 2, moving() - 2);
  }
};

}  // namespace torquewright::hopper
