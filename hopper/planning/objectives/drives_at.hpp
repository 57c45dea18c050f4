// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"
#include "hopper/planning/plane/variable_numbers.hpp"

namespace torquewright::hopper {

/// State of the drives at an instant, on any scalar, each (drives x 1).
template <typename T>
struct DriveStateOf {
  dynamics::VectorX<T> torque_Nm;
  dynamics::VectorX<T> speed_rad_s;
  dynamics::VectorX<T> bus_V;
  std::vector<double> lines_ohm;  ///< Between the bus and each.
};

/// The first of an objective's variables, of an instant: joints (k), their rates (k), drives (d),
/// bus voltages (one a supply that has a resistance).
class DrivesAt {
 public:
  explicit DrivesAt(const PlanModel& model)
      : plane_(&model.plane),
        regions_(model.regions),
        supplies_(model.supplies),
        buses_(bus_count(model)) {}

  const std::vector<DriveRegion>& regions() const { return *regions_; }
  Eigen::Index joints() const { return static_cast<Eigen::Index>(plane_->joints.size()); }
  Eigen::Index drives() const { return static_cast<Eigen::Index>(regions_->size()); }
  Eigen::Index count() const { return 2 * joints() + drives() + buses_; }

  std::vector<int> numbers(const PointVariables& point) const {
    return in_order({numbers_from(point.position + 3, joints()),
                     numbers_from(point.velocity + 3, joints()),
                     numbers_from(point.drives, drives()), numbers_from(point.bus, buses_)});
  }

  template <typename T>
  DriveStateOf<T> state(const dynamics::VectorX<T>& x) const {
    const dynamics::VectorX<T> none = dynamics::VectorX<T>::Zero(joints());
    DriveStateOf<T> out{x.segment(2 * joints(), drives()),
                        {},
                        dynamics::VectorX<T>(drives()),
                        std::vector<double>(static_cast<std::size_t>(drives()))};
    out.speed_rad_s = drive_motion<T>(*plane_, x.head(joints()), x.segment(joints(), joints()),
                                      none, out.torque_Nm)
                          .speed_rad_s;
    Eigen::Index next = 2 * joints() + drives();
    for (const PlanSupply& supply : *supplies_) {
      const T volt = supply.resistance_ohm > 0.0 ? x[next++] : T(supply.open_V);
      for (std::size_t place = 0; place < supply.drives.size(); ++place) {
        out.bus_V[static_cast<Eigen::Index>(supply.drives[place])] = volt;
        out.lines_ohm[supply.drives[place]] = supply.lines_ohm[place];
      }
    }
    return out;
  }

 private:
  const SagittalRobot* plane_;
  std::shared_ptr<const std::vector<DriveRegion>> regions_;
  std::shared_ptr<const std::vector<PlanSupply>> supplies_;
  Eigen::Index buses_;
};

}  // namespace torquewright::hopper
