// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hopper/engines/engine_kind.hpp"
#include "hopper/replay/powered_drive_options.hpp"
#include "hopper/training/episode/mid_motion.hpp"
#include "hopper/training/task/ready_task.hpp"
#include "hopper/trials/randomisation.hpp"
#include "learning/environment.hpp"

namespace torquewright::hopper {

/// What episodes of one training share.
struct EpisodeOptions {
  const EngineKind* engine = nullptr;
  DriveLimits limits = DriveLimits::kMor;
  actuator::OperatingConditions conditions;
  Randomisation randomisation;  ///< What differs by episode; has passed require_fits().
  /// Where episodes begin in the middle of a motion; empty: all begin where the task does.
  std::shared_ptr<const std::vector<MidState>> mid_states;
  double mid_share = 0.5;  ///< Of episodes that begin there.
};

/// How an episode came to its end.
struct EpisodeEnd {
  std::uint64_t episode = 0;
  bool was_whole = true;  ///< It began where the task does, not in the middle of a motion.
  bool fell = false;      ///< A body came to the ground, a gear broke or the engine stopped.
  std::string reason;     ///< Why; empty where its time was up.
  double time_s = 0.0;
  double turned_rad = 0.0;      ///< Of the base about +y.
  int flights = 0;              ///< Losses of contact of at least kCountedFlight_s.
  bool did = false;             ///< Not fallen, turned and flown as the goal says.
  double clipped_share = 0.0;   ///< Of the engine's steps in which a drive's torque was cut off.
  double peak_cam_Nm_s = 0.0;   ///< Greatest momentum about +y in the air,
  double peak_cav_rad_s = 0.0;  ///< and greatest rotation rate.
};

/// A robot that a policy learns a task on: engine, drives held to their limits in every step,
/// sensors, latency and randomisation as in a replay. Two heads: motion, barrier.
class HopperEnvironment final : public learning::Environment {
 public:
  /// Ready task and options must outlive it.
  HopperEnvironment(const ReadyTask& ready, const EpisodeOptions& options);
  ~HopperEnvironment() override;

  static learning::Sizes sizes(const ReadyTask& ready);

  /// From the next episode on. Of these options only what differs by episode may be other than
  /// those that it was made with; they must outlive it.
  void go_by(const EpisodeOptions& options);
  void begin(std::uint64_t seed, std::uint64_t episode) override;
  void observe(Eigen::Ref<Eigen::VectorXd> actor,
               Eigen::Ref<Eigen::VectorXd> critic) const override;
  learning::Outcome act(const Eigen::Ref<const Eigen::VectorXd>& action) override;

  /// Episodes that ended since the last call, in order.
  std::vector<EpisodeEnd> take_ended();
  /// The robot's position and velocity now.
  const Eigen::VectorXd& position() const;
  const Eigen::VectorXd& velocity() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace torquewright::hopper
