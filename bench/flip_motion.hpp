// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <vector>

#include "bench/cubic_spline.hpp"
#include "dynamics/tree_state.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::bench {

/// A flip of a hopper in the plane of x and z, by what its two joints do: the rest follows. The
/// foot stands flat, then on its heel alone (may be left out), then flies until it is flat again
/// one turn later, and stands flat from then on.
struct FlipNumbers {
  double flat_s = 0;
  double heel_s = 0;
  double flight_s = 0;
  double landing_s = 0;
  std::vector<double> knee_rad;           ///< Control points up to touch-down: kBefore of them.
  std::vector<double> ankle_rad;          ///< As many.
  std::vector<double> landing_knee_rad;   ///< Control points kLanding - 2 of the landing: the first
  std::vector<double> landing_ankle_rad;  ///< two are where and how fast touch-down leaves it.
  double turn_rad = 2 * std::numbers::pi;  ///< Between the stances; 0: a hop.
};

enum class FlipPhase { kFlat, kHeel, kFlight, kLanding };

/// Planar: base's x, z and pitch, then the joints (dynamics::BaseKind::kPlanar).
struct FlipSample {
  FlipPhase phase = FlipPhase::kFlat;
  double time_s = 0;
  Eigen::VectorXd position;
  Eigen::VectorXd velocity;
  Eigen::VectorXd acceleration;
};

/// What the ground and the joints give at a sample.
struct FlipLoad {
  double force_x_N = 0;
  double force_z_N = 0;
  double moment_Nm = 0;  ///< About +y and the world's origin.
  double knee_Nm = 0;    ///< Rotor included.
  double ankle_Nm = 0;
};

/// The jump of velocities as the whole sole comes to rest at once, and the impulse that makes it.
struct FlipImpact {
  Eigen::VectorXd velocity;
  double impulse_x_N_s = 0;
  double impulse_z_N_s = 0;
  double moment_Nm_s = 0;  ///< About +y and the world's origin.
};

/// Makes the motions of one robot, whose bodies are thigh, calf, ankle's cross and foot.
class FlipMaker {
 public:
  /// The robot must live as long; its base is spatial.
  explicit FlipMaker(const hopper::Robot& robot);

  /// So many even steps in each phase; touch-down is there twice. The sole stands at height 0, and
  /// its point below the ankle at x = 0 at first.
  std::vector<FlipSample> motion(const FlipNumbers& numbers, const std::vector<int>& steps);
  FlipLoad load(const FlipSample& sample);
  FlipImpact impact(const FlipSample& before);
  dynamics::TreeState& state() { return state_; }

 private:
  struct Joints;
  struct Hold;
  void hold(const Joints& joints, const Hold& hold, double pitch, double rate, FlipSample& sample);
  double ground_moment(const FlipSample& sample, double x_m);
  double heel_rate(const Joints& joints, double x_m, double pitch, double rate);
  void stand_on_heel(FlipSample& sample, double& pitch, double& rate);
  void fly(FlipSample& sample, const Eigen::Vector3d& center_m, const Eigen::Vector3d& velocity_m_s,
           double pitch, double momentum_Nm_s, const Joints& joints);
  double flight_rate(const Joints& joints, double momentum_Nm_s);
  void set(const Joints& joints, const Eigen::Vector3d& base, const Eigen::Vector3d& rate);

  dynamics::TreeState state_;
  hopper::WholeBody body_;  ///< Knows the rotors.
};

}  // namespace torquewright::bench
