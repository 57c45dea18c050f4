// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/gear_torque.hpp"

#include <cmath>

#include "actuator/region/gear_losses.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// At rest friction helps to hold, as it does where the region is asked.
double direction_of(double speed_rad_s, double torque_Nm) {
  return speed_rad_s == 0.0 ? -torque_Nm : speed_rad_s;
}

class GearPass {
 public:
  GearPass(const CheckedMotion& checked, const DriveTorques& torques)
      : checked_(checked), torques_(torques) {
    const Index drives = static_cast<Index>(checked.demand.drives.size());
    const Index samples = checked.motion.samples();
    for (MatrixXd* table : {&gears_.joint_Nm, &gears_.motor_Nm, &gears_.impulse_Nm_s,
                            &gears_.doubt_Nm_s, &gears_.bend_Nm_s}) {
      table->setZero(drives, samples);
    }
  }

  GearTorque run() {
    Index drive = 0;
    for (const Drivetrain& drivetrain : checked_.robot.drivetrains) {
      for (const actuator::Actuator& actuator : drivetrain.actuators) {
        for (Index sample = 0; sample < checked_.motion.samples(); ++sample) {
          add_torque(actuator, drive, sample);
          if (sample > 0) add_interval(drive, sample);
        }
        add_bends(drive);
        ++drive;
      }
    }
    for (const Jolt& jolt : checked_.demand.jolts) add_jolt(jolt);
    return std::move(gears_);
  }

 private:
  const DriveInstant& at(Index drive, Index sample) const {
    return checked_.demand
        .drives[static_cast<std::size_t>(drive)][static_cast<std::size_t>(sample)];
  }
  double rotor_Nm(Index drive, Index sample) const {
    const DriveInstant& instant = at(drive, sample);
    return checked_.demand.before_gears_kg_m2[drive] * instant.acceleration_rad_s2 +
           instant.carried_Nm;
  }

  void add_torque(const actuator::Actuator& actuator, Index drive, Index sample) {
    const double joint_Nm = torques_.torque_Nm(drive, sample) - rotor_Nm(drive, sample);
    const double direction = direction_of(at(drive, sample).speed_rad_s, joint_Nm);
    gears_.joint_Nm(drive, sample) = joint_Nm;
    gears_.motor_Nm(drive, sample) =
        actuator::before_mesh_Nm(actuator, joint_Nm, direction) / actuator.transmission.ratio;
  }

  /// Mean over the interval that ends at the sample, times its length.
  template <typename Value>
  double over_interval(Index sample, const Value& value) const {
    return 0.5 * checked_.motion.step_s(sample - 1) * (value(sample - 1) + value(sample));
  }

  void add_interval(Index drive, Index sample) {
    double& doubt_Nm_s = gears_.doubt_Nm_s(drive, sample);
    if (!checked_.demand.has_dynamics) {
      // Whether the file's torque holds the rotor's is open: by so much the readings differ.
      doubt_Nm_s = over_interval(sample, [&](Index i) { return rotor_Nm(drive, i); });
    } else if (!checked_.motion.is_break(sample)) {
      doubt_Nm_s =
          checked_.demand.unsampled_Nm_s(drive, sample) + over_interval(sample, [&](Index i) {
            return at(drive, i).torque_Nm - torques_.torque_Nm(drive, i);
          });
    }
  }

  /// Whatever jumps or bends between two samples shows in the second differences at both: a jump of
  /// D at the interval's edge is D h/2 off, and makes D at either end. Eq. (19).
  void add_bends(Index drive) {
    for (Index sample = 1; sample < checked_.motion.samples(); ++sample) {
      if (checked_.motion.is_break(sample)) continue;
      gears_.bend_Nm_s(drive, sample) =
          0.25 * checked_.motion.step_s(sample - 1) *
          (second_difference_Nm(drive, sample - 1) + second_difference_Nm(drive, sample));
    }
    if (torques_.doubt_Nm.size() > 0) add_doubts(drive);
  }

  /// Noise of given accelerations is no part of it: it averages out over a window, and the bends
  /// hold it.
  void add_doubts(Index drive) {
    const bool is_derived = checked_.motion.acceleration_origin == Origin::kDerived;
    const MatrixXd& doubt_Nm = is_derived ? torques_.doubt_Nm : checked_.demand.shared_doubt_Nm;
    for (Index sample = 1; sample < checked_.motion.samples(); ++sample) {
      gears_.bend_Nm_s(drive, sample) +=
          over_interval(sample, [&](Index i) { return doubt_Nm(drive, i); });
    }
  }

  /// In size, as over steps of one length; 0 at the ends of a stretch.
  double second_difference_Nm(Index drive, Index sample) const {
    const bool is_end = sample == 0 || sample + 1 >= checked_.motion.samples() ||
                        checked_.motion.is_break(sample) || checked_.motion.is_break(sample + 1);
    if (is_end) return 0.0;
    const double before_s = checked_.motion.step_s(sample - 1);
    const double after_s = checked_.motion.step_s(sample);
    const auto row = gears_.joint_Nm.row(drive);
    return std::abs(
        2.0 *
        ((row[sample + 1] - row[sample]) * before_s - (row[sample] - row[sample - 1]) * after_s) /
        (before_s + after_s));
  }

  void add_jolt(const Jolt& jolt) {
    for (Index drive = 0; drive < gears_.joint_Nm.rows(); ++drive) {
      // What the accelerations beside it account for is in the torques already.
      const double smooth_Nm_s =
          over_interval(jolt.sample, [&](Index i) { return rotor_Nm(drive, i); });
      gears_.impulse_Nm_s(drive, jolt.sample) = jolt.rotor_Nm_s[drive] - smooth_Nm_s;
      gears_.doubt_Nm_s(drive, jolt.sample) =
          jolt.drive_Nm_s[drive] -
          over_interval(jolt.sample, [&](Index i) { return torques_.torque_Nm(drive, i); });
    }
  }

  const CheckedMotion& checked_;
  const DriveTorques& torques_;
  GearTorque gears_;
};

}  // namespace

GearTorque gear_torque(const CheckedMotion& checked, const DriveTorques& torques) {
  return GearPass(checked, torques).run();
}

}  // namespace torquewright::hopper
