// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/plane/planned_instant.hpp"

#include <algorithm>

namespace torquewright::hopper {
namespace {

using Eigen::VectorXd;

/// a(s) = a0 + b s + c s^2 through what is at 0, 1/2 and 1.
template <typename Values>
struct Parabola {
  Values a0, b, c;

  Parabola(const Values& at_0, const Values& at_half, const Values& at_1)
      : a0(at_0),
        b(-3.0 * at_0 + 4.0 * at_half - at_1),
        c(2.0 * at_0 - 4.0 * at_half + 2.0 * at_1) {}
  Values at(double s) const { return a0 + s * b + s * s * c; }
  /// From 0 on, in units of the interval.
  Values integral(double s) const { return s * a0 + s * s / 2.0 * b + s * s * s / 3.0 * c; }
  Values second_integral(double s) const {
    return s * s / 2.0 * a0 + s * s * s / 6.0 * b + s * s * s * s / 12.0 * c;
  }
};

VectorXd cubic(const VectorXd& y0, const VectorXd& r0, const VectorXd& y1, const VectorXd& r1,
               double h, double s) {
  const double s2 = s * s, s3 = s2 * s;
  return (2 * s3 - 3 * s2 + 1) * y0 + (s3 - 2 * s2 + s) * h * r0 + (3 * s2 - 2 * s3) * y1 +
         (s3 - s2) * h * r1;
}

/// Between two instants of a sketch.
PlannedInstant sketched(const PlannedInstant& a, const PlannedInstant& b, double time_s, double s) {
  const double h = b.time_s - a.time_s;
  PlannedInstant out;
  out.time_s = time_s;
  out.position = cubic(a.position, a.velocity, b.position, b.velocity, h, s);
  out.velocity = cubic(a.velocity, a.acceleration, b.velocity, b.acceleration, h, s);
  out.acceleration = a.acceleration + s * (b.acceleration - a.acceleration);
  out.drive_Nm = a.drive_Nm + s * (b.drive_Nm - a.drive_Nm);
  out.contact_N = a.contact_N + s * (b.contact_N - a.contact_N);
  out.bus_V = a.bus_V + s * (b.bus_V - a.bus_V);
  return out;
}

}  // namespace

PlannedInstant instant_within(const PlannedPhase& phase, std::size_t interval, double share) {
  const PlannedInstant& a = phase.instants[2 * interval];
  const PlannedInstant& b = phase.instants[2 * interval + 1];
  const PlannedInstant& c = phase.instants[2 * interval + 2];
  const double h = c.time_s - a.time_s;
  const Parabola<VectorXd> acceleration(a.acceleration, b.acceleration, c.acceleration);
  PlannedInstant out;
  out.time_s = share == 1.0 ? c.time_s : a.time_s + share * h;
  out.acceleration = acceleration.at(share);
  out.velocity = a.velocity + h * acceleration.integral(share);
  out.position = a.position + h * share * a.velocity + h * h * acceleration.second_integral(share);
  out.drive_Nm = Parabola<VectorXd>(a.drive_Nm, b.drive_Nm, c.drive_Nm).at(share);
  out.contact_N = Parabola<Eigen::Matrix3Xd>(a.contact_N, b.contact_N, c.contact_N).at(share);
  out.bus_V = Parabola<double>(a.bus_V, b.bus_V, c.bus_V).at(share);
  return out;
}

PlannedInstant instant_at(const PlannedPhase& phase, double share) {
  const double time_s = phase.begin_s() + share * (phase.end_s() - phase.begin_s());
  const std::size_t stride = phase.is_collocated ? 2 : 1;
  std::size_t i = 0;
  while (i + 2 * stride < phase.instants.size() && phase.instants[i + stride].time_s <= time_s) {
    i += stride;
  }
  const PlannedInstant& a = phase.instants[i];
  const PlannedInstant& b = phase.instants[i + stride];
  const double h = b.time_s - a.time_s;
  const double s = h > 0.0 ? std::clamp((time_s - a.time_s) / h, 0.0, 1.0) : 0.0;
  return phase.is_collocated ? instant_within(phase, i / 2, s) : sketched(a, b, time_s, s);
}

}  // namespace torquewright::hopper
