// SPDX-License-Identifier: Apache-2.0
#pragma once
// STUB until the real one lands
#include <span>
#include <string>

#include "actuator/region/joint_region.hpp"
#include "dynamics/jet.hpp"
#include "hopper/replay/powered_drive_options.hpp"

namespace torquewright::hopper {
struct DriveRegionOptions {
  DriveLimits limits = DriveLimits::kMor;
  double voltage_margin = 0.0;
  double current_margin = 0.0;
};
class DriveRegion {
 public:
  DriveRegion(const actuator::Actuator& a, const actuator::OperatingConditions&, const DriveRegionOptions& o) : o_(o) {
    k_ = a.motor.torque_constant_Nm_A * a.transmission.ratio;
    r_ = a.motor.resistance_ohm;
    i_ = a.drive.peak_current_A;
    v_ = a.drive.bus_voltage_V;
  }
  std::size_t rows() const { return o_.limits == DriveLimits::kMor ? 2 : 0; }
  template <typename T> void rows(const T& u, const T& w, const T& V, std::span<T> out) const {
    if (o_.limits == DriveLimits::kBox) return;
    const T line = u + (k_ * k_ / r_) * w;
    const T most = (k_ / r_ * (1 - o_.voltage_margin)) * V;
    out[0] = line - most;
    out[1] = -line - most;
  }
  template <typename T> T bus_power_W(const T& u, const T& w, const T&) const { return u * w + (r_ / (k_ * k_)) * u * u; }
  double greatest_torque_Nm() const { return k_ * i_ * (1 - o_.current_margin); }
  double greatest_speed_rad_s() const { return v_ / k_; }
 private:
  DriveRegionOptions o_;
  double k_, r_, i_, v_;
};
}  // namespace torquewright::hopper
