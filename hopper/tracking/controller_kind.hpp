// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "hopper/tracking/controller.hpp"
#include "hopper/tracking/drive_ranges.hpp"
#include "hopper/tracking/reference_clock.hpp"

namespace torquewright::hopper {

struct OperationalTasks;

/// Options of all controllers that follow a motion.
struct TrackingOptions {
  double control_period_s = 5e-4;  ///< Time between looks; torques are held over it.
  ClockOptions clock;
  ImpactOptions impact;
  bool acts_late = false;  ///< Whether torques may act later than the look that they answer.
  /// What a controller of tasks weighs; null: the usual of the robot.
  std::shared_ptr<const OperationalTasks> tasks = nullptr;
  /// Makes the ranges of the robot's drives, for a controller that needs them.
  std::function<std::shared_ptr<const DriveRanges>()> make_ranges = {};
  /// Speed at which hops are to go, along the way that the base faces, for one that follows it.
  std::optional<double> forward_m_s = std::nullopt;
};

/// A controller made ready for a robot and a motion once, for any number of runs and threads.
class ReadyController {
 public:
  virtual ~ReadyController() = default;
  virtual std::unique_ptr<Controller> make() const = 0;
};

/// A controller that a replay can be asked for. One file each in this folder, one line in
/// every_controller.hpp.
struct ControllerKind {
  std::string_view name;
  std::string_view sentence;  ///< Description for a user.
  bool has_tasks = false;     ///< Whether it weighs tasks, which a document may state.
  bool has_speed = false;     ///< Whether it follows a commanded speed.
  /// Robot and reference must outlive it. io::SpecError where it cannot follow this motion.
  std::unique_ptr<const ReadyController> (*prepare)(const Robot& robot, const Reference& reference,
                                                    const TrackingOptions& options) = nullptr;
};

}  // namespace torquewright::hopper
