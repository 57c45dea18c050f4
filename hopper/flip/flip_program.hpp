// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "hopper/flip/laws.hpp"
#include "hopper/flip/plan.hpp"
#include "optimization/nonlinear/program.hpp"

namespace torquewright::hopper {

/// A phase and how it is cut: shares of its duration, from 0 to 1.
struct MeshPhase {
  Stance stance;
  std::vector<double> knots;
  optimization::Bounds duration_s;

  std::size_t intervals() const { return knots.size() - 1; }
};

/// Where the unknowns of one instant begin in the program.
struct PointVariables {
  int position = 0;      ///< (m) of the phase's frame, then the joints that move.
  int velocity = 0;      ///< (m)
  int acceleration = 0;  ///< (m)
  int drives = 0;        ///< (d)
  int forces = 0;        ///< (f of the stance)
  int bus = 0;           ///< One a supply that has a resistance.
};

struct PhaseVariables {
  int duration = 0;
  std::vector<PointVariables> points;  ///< Knots and middles in turn: 2 n + 1.
  int impulses = 0;                    ///< (f of the stance) at its begin,
  bool has_impact = false;             ///< where it begins with an impact,
  int velocity_before = 0;             ///< and the velocity before it, in this phase's frame.
};

/// What is planned with: the robot's plane, its drives, what feeds them.
struct PlanModel {
  SagittalRobot plane;
  std::shared_ptr<const std::vector<DriveRegion>> regions;
  std::shared_ptr<const std::vector<PlanSupply>> supplies;
  std::vector<optimization::Bounds> joint_rad;  ///< By joint that moves, margins taken off.
  std::vector<double> joint_rad_s;              ///< Greatest.
  std::vector<double> joint_Nm;                 ///< Greatest; may be infinite.
  std::vector<double> gear_Nm;                  ///< By drive, at its output; may be infinite.
  std::vector<double> rotors_kg_m2;             ///< By drive, before its gears.
  double weight_N = 0.0;
  double size_m = 0.0;         ///< Radius of gyration about the pitch axis, joints at 0.
  double foot_length_m = 0.0;  ///< From the rearmost to the foremost point of the sole.
};

PlanModel plan_model(const Robot& robot, const PlanOptions& options);

/// What a plan is to do beside obeying physics.
struct PlanGoal {
  double turn_rad = 0.0;           ///< Of the foot, forwards.
  std::optional<double> stride_m;  ///< Of the foot; empty: as it comes.
  std::optional<double> rise_m;    ///< Of the centre of mass in flight, at least.
  /// By joint that moves: between what it stands at the begin and at the end.
  std::vector<optimization::Bounds> standing_rad;
  /// Whether the base is level at the begin, and turned by `turn_rad` at the end: of a foot of one
  /// point, whose own pitch is free.
  bool has_level_base = false;
};

/// A nonlinear program and where its unknowns stand for what.
struct FlipProgram {
  optimization::Program program;
  std::vector<MeshPhase> mesh;
  std::vector<PhaseVariables> phases;
};

/// `guess` has as many phases as the mesh.
FlipProgram flip_program(const PlanModel& model, const std::vector<MeshPhase>& mesh,
                         const PlanGoal& goal, const PlanOptions& options,
                         const PlannedMotion& guess);

/// The motion that values of the program's unknowns are.
PlannedMotion motion_of(const FlipProgram& program, const PlanModel& model,
                        const std::vector<double>& values);

}  // namespace torquewright::hopper
