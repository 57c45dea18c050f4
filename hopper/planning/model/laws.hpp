// SPDX-License-Identifier: Apache-2.0
// What a plan must obey at an instant, on any scalar: laws of JetRows. Each says which variables
// it takes, in which order. m moving rows (three of the stance's frame, then joints), k = m - 3
// joints, d drives, f forces of the stance.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>

#include "dynamics/jet.hpp"
#include "dynamics/jet_functions.hpp"
#include "hopper/planning/plane/sagittal_dynamics.hpp"
#include "hopper/planning/plane/stance.hpp"
#include "hopper/planning/region/drive_region.hpp"
#include "hopper/planning/region/line_loss.hpp"

namespace torquewright::hopper {

/// Memory for the dynamics on every scalar; one for each thread.
class SagittalScratch {
 public:
  explicit SagittalScratch(const SagittalRobot& robot)
      : robot_(&robot), bodies_(robot, robot, robot) {}
  template <typename T>
  SagittalDynamicsOf<T>& on() {
    return std::get<SagittalDynamicsOf<T>>(bodies_);
  }
  const SagittalRobot& robot() const { return *robot_; }

 private:
  const SagittalRobot* robot_;
  std::tuple<SagittalDynamicsOf<double>, SagittalDynamicsOf<dynamics::Jet>,
             SagittalDynamicsOf<dynamics::Jet2>>
      bodies_;
};

/// x and z of the frame at 0: nothing but places depends on them.
template <typename T>
dynamics::VectorX<T> without_place(const dynamics::VectorX<T>& x, Eigen::Index from,
                                   Eigen::Index moving) {
  dynamics::VectorX<T> out = dynamics::VectorX<T>::Zero(moving);
  out.tail(moving - 2) = x.segment(from, moving - 2);
  return out;
}

/// The forces of a stance out of variables: along the ground, then upwards by point.
template <typename T>
std::vector<SoleForceOf<T>> forces_of(const Stance& stance, const dynamics::VectorX<T>& x,
                                      Eigen::Index from) {
  std::vector<SoleForceOf<T>> out;
  for (std::size_t i = 0; i < stance.points.size(); ++i) {
    out.push_back(
        {stance.points[i], i == 0 ? x[from] : T(0.0), x[from + 1 + static_cast<Eigen::Index>(i)]});
  }
  return out;
}

/// x and z of the first point of a stance, z of the second: what a rigid sole leaves to state.
template <typename T, typename Of>
void stance_rows(const SagittalRobot& robot, const Stance& stance, const Of& of,
                 dynamics::VectorX<T>& rows) {
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < stance.points.size(); ++i) {
    const Eigen::Matrix<T, 2, 1> value = of(robot.sole[stance.points[i]].point);
    if (i == 0) rows[row++] = value[0];
    rows[row++] = value[1];
  }
}

/// Equations of motion. Variables: pitch, joints (m - 2); their rates (m - 2); accelerations (m);
/// drives (d); forces (f). Rows: moving, then held.
struct DynamicsLaw {
  std::shared_ptr<SagittalScratch> scratch;
  Stance stance;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    SagittalDynamicsOf<T>& body = scratch->on<T>();
    const Eigen::Index m = body.robot().moving_count();
    const auto d = static_cast<Eigen::Index>(body.robot().drive_count());
    body.set(stance.frame(), without_place(x, 0, m), without_place(x, m - 2, m));
    rows = body.residual(x.segment(2 * m - 4, m), x.segment(3 * m - 4, d),
                         forces_of(stance, x, 3 * m - 4 + d));
  }
};

/// Law: points that touch do not accelerate. Variables: pitch, joints; their rates; accelerations.
struct ContactAccelerationLaw {
  std::shared_ptr<SagittalScratch> scratch;
  Stance stance;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    SagittalDynamicsOf<T>& body = scratch->on<T>();
    const Eigen::Index m = body.robot().moving_count();
    body.set(stance.frame(), without_place(x, 0, m), without_place(x, m - 2, m));
    const dynamics::VectorX<T> acceleration = x.segment(2 * m - 4, m);
    stance_rows<T>(
        body.robot(), stance,
        [&](const dynamics::BodyPoint& point) {
          return body.acceleration_m_s2(point, acceleration);
        },
        rows);
  }
};

/// Law: points that touch are at rest. Variables: pitch, joints (m - 2); velocities (m).
struct ContactVelocityLaw {
  std::shared_ptr<SagittalScratch> scratch;
  Stance stance;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    SagittalDynamicsOf<T>& body = scratch->on<T>();
    const Eigen::Index m = body.robot().moving_count();
    body.set(PlanFrame::kSole, without_place(x, 0, m), x.segment(m - 2, m));
    stance_rows<T>(
        body.robot(), stance,
        [&](const dynamics::BodyPoint& point) { return body.velocity_m_s(point); }, rows);
  }
};

/// The base's pitch. Variables: pitch of the foot, joints (m - 2). Rows: one.
struct BasePitchLaw {
  const SagittalRobot* robot = nullptr;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    rows[0] = x[0];
    for (std::size_t i = 0; i < robot->directions.size(); ++i) {
      rows[0] -= robot->directions[i] * x[1 + static_cast<Eigen::Index>(i)];
    }
  }
};

/// Heights of points. Variables: position in the frame (m). Rows: one a point.
struct PlaceLaw {
  std::shared_ptr<SagittalScratch> scratch;
  PlanFrame frame = PlanFrame::kSole;
  std::vector<dynamics::BodyPoint> points;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    SagittalDynamicsOf<T>& body = scratch->on<T>();
    body.set(frame, x, dynamics::VectorX<T>::Zero(x.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
      rows[static_cast<Eigen::Index>(i)] = body.place_m(points[i])[1];
    }
  }
};

/// Law: distance of the centre of mass in front of the rearmost point of the sole. Variables: pitch
/// and joints about the sole (m - 2). Rows: one.
struct LeanLaw {
  std::shared_ptr<SagittalScratch> scratch;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    SagittalDynamicsOf<T>& body = scratch->on<T>();
    const Eigen::Index m = body.robot().moving_count();
    body.set(PlanFrame::kSole, without_place(x, 0, m), dynamics::VectorX<T>::Zero(m));
    rows[0] = body.position_in(PlanFrame::kMass)[0];
  }
};

/// Law: distance of the capture point in front of the rearmost point of the sole: x + x' sqrt(z/g)
/// of the centre of mass, over which an inverted pendulum of that height comes to rest (Pratt and
/// others 2006). Variables: pitch and joints about the sole (m - 2), their rates (m - 2). Rows:
/// one.
struct CaptureLaw {
  std::shared_ptr<SagittalScratch> scratch;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    using std::sqrt;
    SagittalDynamicsOf<T>& body = scratch->on<T>();
    const Eigen::Index m = body.robot().moving_count();
    body.set(PlanFrame::kSole, without_place(x, 0, m), without_place(x, m - 2, m));
    const dynamics::VectorX<T> at = body.position_in(PlanFrame::kMass);
    const double gravity_m_s2 = body.robot().robot.tree.gravity_m_s2;
    rows[0] = at[0] + body.velocity_in(PlanFrame::kMass)[0] * sqrt(at[1] * (1.0 / gravity_m_s2));
  }
};

/// One instant in two frames. Variables: position and velocity about the sole (m, m), about the
/// centre of mass (m, m). Rows: their differences (2 m).
struct LinkLaw {
  std::shared_ptr<SagittalScratch> scratch;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    SagittalDynamicsOf<T>& body = scratch->on<T>();
    const Eigen::Index m = body.robot().moving_count();
    body.set(PlanFrame::kSole, x.head(m), x.segment(m, m));
    rows.head(m) = body.position_in(PlanFrame::kMass) - x.segment(2 * m, m);
    rows.tail(m) = body.velocity_in(PlanFrame::kMass) - x.segment(3 * m, m);
  }
};

/// Law of a rigid impact with the ground. Variables: pitch, joints (m - 2); velocities before (m)
/// and after (m); impulses (f). Rows: by moving row.
struct ImpactLaw {
  std::shared_ptr<SagittalScratch> scratch;
  Stance stance;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    SagittalDynamicsOf<T>& body = scratch->on<T>();
    const Eigen::Index m = body.robot().moving_count();
    body.set(PlanFrame::kSole, without_place(x, 0, m), dynamics::VectorX<T>::Zero(m));
    rows = body.impact_residual(x.segment(2 * m - 2, m) - x.segment(m - 2, m),
                                forces_of(stance, x, 3 * m - 2));
  }
};

/// Drives that one battery feeds, as a plan models them.
struct PlanSupply {
  std::vector<std::size_t> drives;
  double open_V = 0.0;
  double resistance_ohm = 0.0;
  /// Between it and each of the drives, in their order; 0 of a drive alone.
  std::vector<double> lines_ohm;
};

/// Law of what drives can do. Variables: joints (k), their rates (k), their accelerations (k),
/// drives (d), bus voltages (one for each supply that has a resistance). Rows: regions, drive by
/// drive; gear torques (d), in Nm at the output; joint torques (k); the voltages' rows, in V.
struct DriveLaw {
  const SagittalRobot* robot = nullptr;
  std::shared_ptr<const std::vector<DriveRegion>> regions;
  std::shared_ptr<const std::vector<PlanSupply>> supplies;
  std::vector<double> rotors_kg_m2;  ///< Inertia of each drive's rotor, before its gears.

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    const auto k = static_cast<Eigen::Index>(robot->joints.size());
    const auto d = static_cast<Eigen::Index>(regions->size());
    const dynamics::VectorX<T> torque = x.segment(3 * k, d);
    const DriveMotionOf<T> motion =
        drive_motion<T>(*robot, x.head(k), x.segment(k, k), x.segment(2 * k, k), torque);
    std::vector<T> bus(static_cast<std::size_t>(d), T(0.0));
    Eigen::Index next = 3 * k + d;
    for (const PlanSupply& supply : *supplies) {
      const T volt = supply.resistance_ohm > 0.0 ? x[next++] : T(supply.open_V);
      for (const std::size_t drive : supply.drives) bus[drive] = volt;
    }
    Eigen::Index row = 0;
    for (Eigen::Index i = 0; i < d; ++i) {
      const DriveRegion& region = (*regions)[static_cast<std::size_t>(i)];
      const std::size_t count = region.rows();
      region.rows<T>(torque[i], motion.speed_rad_s[i], bus[static_cast<std::size_t>(i)],
                     std::span<T>(rows.data() + row, count));
      row += static_cast<Eigen::Index>(count);
    }
    for (Eigen::Index i = 0; i < d; ++i) {
      rows[row++] =
          torque[i] - rotors_kg_m2[static_cast<std::size_t>(i)] * motion.acceleration_rad_s2[i];
    }
    for (Eigen::Index i = 0; i < k; ++i) rows[row++] = motion.joint_Nm[i];
    for (const PlanSupply& supply : *supplies) {
      if (!(supply.resistance_ohm > 0.0)) continue;
      const T& volt = bus[supply.drives.front()];
      T power_W(0.0);
      for (std::size_t place = 0; place < supply.drives.size(); ++place) {
        const std::size_t drive = supply.drives[place];
        const auto i = static_cast<Eigen::Index>(drive);
        power_W += drawn_behind_line_W<T>(
            volt, supply.lines_ohm[place],
            (*regions)[drive].bus_power_W<T>(torque[i], motion.speed_rad_s[i], volt));
      }
      rows[row++] = volt - volt * volt * (1.0 / supply.open_V) -
                    power_W * (supply.resistance_ohm / supply.open_V);
    }
  }
};

}  // namespace torquewright::hopper
