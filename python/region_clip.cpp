// SPDX-License-Identifier: Apache-2.0
#include "python/region_clip.hpp"

#include <stdexcept>
#include <vector>

namespace torquewright::python {
namespace {

std::vector<double> list_of(const Numbers& numbers) {
  return {numbers.data(), numbers.data() + numbers.size()};
}

actuator::ClipPoints points_of(const Numbers& speed_rad_s, const Numbers& least_Nm,
                               const Numbers& greatest_Nm) {
  if (speed_rad_s.size() != least_Nm.size() || speed_rad_s.size() != greatest_Nm.size()) {
    throw std::invalid_argument("speeds and bounds must be of one length");
  }
  return {list_of(speed_rad_s), list_of(least_Nm), list_of(greatest_Nm)};
}

std::vector<pybind11::ssize_t> shape_of(const Numbers& numbers) {
  return {numbers.shape(), numbers.shape() + numbers.ndim()};
}

}  // namespace

RegionClip::RegionClip(const Numbers& speed_rad_s, const Numbers& least_Nm,
                       const Numbers& greatest_Nm, double error_Nm)
    : table_(actuator::drawn_in(points_of(speed_rad_s, least_Nm, greatest_Nm), error_Nm)) {}

Numbers RegionClip::clip(const Numbers& torque_Nm, const Numbers& speed_rad_s) const {
  if (shape_of(torque_Nm) != shape_of(speed_rad_s)) {
    throw std::invalid_argument("torques and speeds must be of one shape");
  }
  Numbers clipped_Nm(shape_of(torque_Nm));
  const double* torques_Nm = torque_Nm.data();
  const double* speeds_rad_s = speed_rad_s.data();
  double* answers_Nm = clipped_Nm.mutable_data();
  const auto count = static_cast<std::size_t>(torque_Nm.size());
  const actuator::TableView view = table_.view();
  const pybind11::gil_scoped_release others_go_on;
  actuator::clip(view, speeds_rad_s, torques_Nm, answers_Nm, count);
  return clipped_Nm;
}

}  // namespace torquewright::python
