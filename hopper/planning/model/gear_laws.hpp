// SPDX-License-Identifier: Apache-2.0
// What passes the gears, at an instant and in an impact, on any scalar. Numbers in brackets are
// those of docs/derivations/whole_body_check.md.
#pragma once

#include <vector>

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"
#include "hopper/planning/plane/variable_numbers.hpp"

namespace torquewright::hopper {

/// The rotors' impulses, spread over the window: (17), over the limits. Variables: joints (k),
/// their rates before (k) and after (k). Rows: by drive.
struct ImpulseLaw {
  const PlanModel* model;
  std::vector<double> limits_Nm;
  double window_s;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    const auto k = static_cast<Eigen::Index>(model->plane.joints.size());
    const auto d = static_cast<Eigen::Index>(limits_Nm.size());
    const dynamics::VectorX<T> jump = x.segment(2 * k, k) - x.segment(k, k);
    const dynamics::VectorX<T> none = dynamics::VectorX<T>::Zero(k);
    const DriveMotionOf<T> motion =
        drive_motion<T>(model->plane, x.head(k), jump, none, dynamics::VectorX<T>::Zero(d));
    for (Eigen::Index i = 0; i < d; ++i) {
      const auto drive = static_cast<std::size_t>(i);
      rows[i] =
          (-model->rotors_kg_m2[drive] / (window_s * limits_Nm[drive])) * motion.speed_rad_s[i];
    }
  }
};

/// Law of the torque that passes the gears at an instant: (16), over the limits. Variables: joints
/// (k), their rates (k), their accelerations (k), drives (d). Rows: by drive.
struct GearLaw {
  const PlanModel* model;
  std::vector<double> limits_Nm;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    const auto k = static_cast<Eigen::Index>(model->plane.joints.size());
    const auto d = static_cast<Eigen::Index>(limits_Nm.size());
    const dynamics::VectorX<T> torque = x.segment(3 * k, d);
    const DriveMotionOf<T> motion =
        drive_motion<T>(model->plane, x.head(k), x.segment(k, k), x.segment(2 * k, k), torque);
    for (Eigen::Index i = 0; i < d; ++i) {
      const auto drive = static_cast<std::size_t>(i);
      rows[i] = (torque[i] - model->rotors_kg_m2[drive] * motion.acceleration_rad_s2[i]) *
                (1.0 / limits_Nm[drive]);
    }
  }
};

/// Magnitudes of a law's rows under bounds that are variables: +-rows less them, or with `adds` the
/// magnitudes and those of another law, under one. Variables: the law's, one a row, and with `adds`
/// the bound of the sums.
template <typename Law>
struct MagnitudeLaw {
  Law law;
  Eigen::Index drives;
  bool adds;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    const Eigen::Index bounds = drives + (adds ? 1 : 0);
    const dynamics::VectorX<T> own = x.head(x.size() - bounds);
    const dynamics::VectorX<T> magnitudes = x.segment(own.size(), drives);
    dynamics::VectorX<T> signed_rows(drives);
    law(own, signed_rows);
    for (Eigen::Index i = 0; i < drives; ++i) {
      const T room = adds ? T(x[x.size() - 1] - magnitudes[i]) : magnitudes[i];
      rows[2 * i] = signed_rows[i] - room;
      rows[2 * i + 1] = -signed_rows[i] - room;
    }
  }
};

inline std::vector<int> impulse_numbers(const PhaseVariables& phase, Eigen::Index joints) {
  const PointVariables& after = phase.points.front();
  return in_order({numbers_from(after.position + 3, joints),
                   numbers_from(phase.velocity_before + 3, joints),
                   numbers_from(after.velocity + 3, joints)});
}

inline std::vector<int> gear_numbers(const PointVariables& point, Eigen::Index joints,
                                     Eigen::Index drives) {
  return in_order(
      {numbers_from(point.position + 3, joints), numbers_from(point.velocity + 3, joints),
       numbers_from(point.acceleration + 3, joints), numbers_from(point.drives, drives)});
}

}  // namespace torquewright::hopper
