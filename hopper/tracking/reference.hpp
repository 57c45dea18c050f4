// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "hopper/contact/contact_schedule.hpp"
#include "hopper/motion/motion.hpp"

namespace torquewright::hopper {

using TouchingPoints = Eigen::Array<bool, Eigen::Dynamic, 1>;

/// State and torques of a motion at an instant.
struct ReferenceInstant {
  Eigen::VectorXd position;
  Eigen::VectorXd velocity;
  Eigen::VectorXd acceleration;
  Eigen::VectorXd drive_Nm;  ///< (drives x 1) at their outputs, rotors included.
};

/// A stretch of the motion in which the same points touch.
struct ContactMode {
  double from_s = 0.0;
  double until_s = 0.0;
  TouchingPoints touches;  ///< (points x 1)
  bool begins_with_impact = false;
};

/// A motion that a controller follows: at any time, and after its end, where it stands still as in
/// its last sample. Copies what it needs.
class Reference {
 public:
  /// `drive_Nm`: (drives x samples). Requires a motion with all rates and a base, of ascending
  /// times.
  Reference(const Robot& robot, const Motion& motion, const ContactSchedule& contacts,
            const Eigen::MatrixXd& drive_Nm);

  /// Interpolates: positions cubic between samples, the rest linear. Where two samples share a
  /// time, the later one's.
  void at(double time_s, ReferenceInstant& out) const;

  /// Returns the mean of the drives' torques (drives x 1), which are linear between samples; at the
  /// time itself where both times are one.
  Eigen::VectorXd mean_drive_Nm(double from_s, double until_s) const;

  double begins_s() const { return times_s_.front(); }
  double ends_s() const { return times_s_.back(); }
  const std::vector<ContactMode>& modes() const { return modes_; }
  /// Index of the mode at a time; of the later one at a border.
  std::size_t mode_at(double time_s) const;
  /// Returns the planned impact nearest to a time, as the mode that it begins; none where none is
  /// planned.
  std::optional<std::size_t> nearest_impact(double time_s) const;

 private:
  std::size_t interval_at(double time_s) const;
  double share_of(std::size_t interval, double time_s) const;
  Eigen::VectorXd drive_Nm(double time_s) const;

  dynamics::Tree tree_;
  std::vector<double> times_s_;
  Eigen::MatrixXd positions_, velocities_, accelerations_, drive_Nm_;
  std::vector<ContactMode> modes_;
};

}  // namespace torquewright::hopper
