// SPDX-License-Identifier: Apache-2.0
#include "hopper/record/load_window.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "actuator/region/gear_losses.hpp"
#include "hopper/record/step_window.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

void require_run(const Robot& robot, const DriveSteps& steps, double window_s) {
  Index drives = 0;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    drives += static_cast<Index>(drivetrain.actuators.size());
  }
  const auto count = static_cast<Index>(steps.times_s.size()) - 1;
  bool fits = count >= 1 && window_s > 0.0;
  for (const Eigen::MatrixXd* of : {&steps.torque_Nm, &steps.speed_before_rad_s,
                                    &steps.speed_after_rad_s, &steps.contact_Nm_s}) {
    fits = fits && of->rows() == drives && of->cols() == count && of->allFinite();
  }
  const Eigen::MatrixXd& carried = steps.carried_Nm_s;
  fits = fits && (carried.size() == 0 ||
                  (carried.rows() == drives && carried.cols() == count && carried.allFinite()));
  fits = fits && (steps.has_impact.empty() || steps.has_impact.size() + 1 == steps.times_s.size());
  const auto falls = [](double one, double next) { return !(one < next); };
  const bool ascends =
      std::adjacent_find(steps.times_s.begin(), steps.times_s.end(), falls) == steps.times_s.end();
  if (!fits || !ascends) {
    throw std::invalid_argument("the load of gears needs a run of finite, ascending steps");
  }
}

/// One drive of a run.
class DriveRun {
 public:
  DriveRun(const actuator::Actuator& actuator, double before_gears_kg_m2, const DriveSteps& steps,
           Index drive)
      : actuator_(actuator), rotor_kg_m2_(before_gears_kg_m2), steps_(steps), drive_(drive) {}

  Index steps() const { return steps_.torque_Nm.cols(); }
  double step_s(Index step) const {
    const auto at = static_cast<std::size_t>(step);
    return steps_.times_s[at + 1] - steps_.times_s[at];
  }
  bool has_impact(Index step) const {
    return !steps_.has_impact.empty() && steps_.has_impact[static_cast<std::size_t>(step)];
  }

  /// What changed the rotor's speed, eq. (17), where that was an impact; else 0.
  double impulse_Nm_s(Index step) const { return has_impact(step) ? -taken_Nm_s(step) : 0.0; }
  /// The rest of eq. (16), the step's mean, behind the mesh,
  double joint_Nm(Index step) const {
    const double rotor_Nm = has_impact(step) ? 0.0 : taken_Nm_s(step) / step_s(step);
    return steps_.torque_Nm(drive_, step) - rotor_Nm;
  }
  /// and before it: friction helps to hold at rest, as it does where the region is asked.
  double motor_Nm(Index step) const {
    const double joint_Nm = this->joint_Nm(step);
    const double twice_rad_s =
        steps_.speed_before_rad_s(drive_, step) + steps_.speed_after_rad_s(drive_, step);
    const double direction = twice_rad_s == 0.0 ? -joint_Nm : twice_rad_s;
    return actuator::before_mesh_Nm(actuator_, joint_Nm, direction) / actuator_.transmission.ratio;
  }
  double contact_Nm_s(Index step) const { return std::abs(steps_.contact_Nm_s(drive_, step)); }

  /// The worst window of a torque and of impulses by step.
  template <typename Torque, typename Impulse>
  WindowLoad worst(double window_s, const Torque& torque_Nm, const Impulse& size_Nm_s) const {
    StepSignal signal{steps_.times_s, VectorXd(steps()), VectorXd(steps())};
    for (Index step = 0; step < steps(); ++step) {
      signal.values[step] = torque_Nm(step);
      signal.impulses[step] = size_Nm_s(step);
    }
    return greatest_step_window(signal, window_s);
  }

 private:
  /// By the rotor, of the torque at the output.
  double taken_Nm_s(Index step) const {
    const double carried_Nm_s =
        steps_.carried_Nm_s.size() > 0 ? steps_.carried_Nm_s(drive_, step) : 0.0;
    return carried_Nm_s + rotor_kg_m2_ * (steps_.speed_after_rad_s(drive_, step) -
                                          steps_.speed_before_rad_s(drive_, step));
  }

  const actuator::Actuator& actuator_;
  double rotor_kg_m2_;
  const DriveSteps& steps_;
  Index drive_;
};

template <typename Use>
void for_each_drive(const Robot& robot, const DriveSteps& steps, const Use& use) {
  const WholeBody body(robot);
  std::size_t drive = 0;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (const actuator::Actuator& actuator : drivetrain.actuators) {
      use(drive,
          DriveRun(actuator, body.before_gears_kg_m2(drive), steps, static_cast<Index>(drive)));
      ++drive;
    }
  }
}

void note_greatest(const DriveRun& run, const DriveSteps& steps, TransmissionLoad& load) {
  for (Index step = 0; step < run.steps(); ++step) {
    const double begins_s = steps.times_s[static_cast<std::size_t>(step)];
    load.peak_joint_Nm = std::max(load.peak_joint_Nm, std::abs(run.joint_Nm(step)));
    if (const double motor_Nm = std::abs(run.motor_Nm(step)); motor_Nm > load.peak_motor_Nm) {
      load.peak_motor_Nm = motor_Nm;
      load.peak_time_s = begins_s;
    }
    if (const double rotor_Nm_s = std::abs(run.impulse_Nm_s(step)); rotor_Nm_s > load.rotor_Nm_s) {
      load.rotor_Nm_s = rotor_Nm_s;
      load.impact_time_s = steps.times_s[static_cast<std::size_t>(step) + 1];
    }
  }
}

void note_greatest(const DriveRun& run, const DriveSteps& steps, ContactLoad& load) {
  for (Index step = 0; step < run.steps(); ++step) {
    if (run.contact_Nm_s(step) <= load.impulse_Nm_s) continue;
    load.impulse_Nm_s = run.contact_Nm_s(step);
    load.impulse_time_s = steps.times_s[static_cast<std::size_t>(step) + 1];
  }
}

}  // namespace

std::vector<TransmissionLoad> transmission_loads(const Robot& robot, const DriveSteps& steps,
                                                 double window_s) {
  require_run(robot, steps, window_s);
  std::vector<TransmissionLoad> loads = unloaded_transmissions(robot);
  for_each_drive(robot, steps, [&](std::size_t drive, const DriveRun& run) {
    TransmissionLoad& load = loads[drive];
    load.window_s = std::min(window_s, steps.times_s.back() - steps.times_s.front());
    load.joint = run.worst(
        window_s, [&](Index step) { return run.joint_Nm(step); },
        [&](Index step) { return std::abs(run.impulse_Nm_s(step)); });
    load.motor = run.worst(
        window_s, [&](Index step) { return run.motor_Nm(step); },
        [&](Index step) { return std::abs(run.impulse_Nm_s(step)) / load.ratio; });
    note_greatest(run, steps, load);
    load.verdict = verdict_of(load);
  });
  return loads;
}

std::vector<ContactLoad> contact_loads(const Robot& robot, const DriveSteps& steps,
                                       double window_s) {
  require_run(robot, steps, window_s);
  std::vector<ContactLoad> loads;
  for (const TransmissionLoad& named : unloaded_transmissions(robot)) {
    loads.emplace_back().drive = named.drive;
    loads.back().ratio = named.ratio;
  }
  for_each_drive(robot, steps, [&](std::size_t drive, const DriveRun& run) {
    ContactLoad& load = loads[drive];
    const auto mean_Nm = [&](Index step) { return run.contact_Nm_s(step) / run.step_s(step); };
    const auto steady_Nm = [&](Index step) { return run.has_impact(step) ? 0.0 : mean_Nm(step); };
    const auto none = [](Index) { return 0.0; };
    const WindowLoad all = run.worst(window_s, mean_Nm, none);
    load.joint_Nm = all.mean;
    load.motor_Nm = all.mean / load.ratio;
    load.time_s = all.time_s;
    load.steady_joint_Nm = run.worst(window_s, steady_Nm, none).mean;
    note_greatest(run, steps, load);
  });
  return loads;
}

}  // namespace torquewright::hopper
