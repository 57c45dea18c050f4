// SPDX-License-Identifier: Apache-2.0
#include "tests/real_data/cassie/cassie_jump.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <string>

#include "dynamics/position_step.hpp"
#include "hopper/tracking/contact_rows.hpp"
#include "io/files/csv.hpp"

namespace torquewright::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using hopper::Motion;
using hopper::Robot;
using hopper::TouchingPoints;

namespace {

constexpr Index kModeKnots = 8;
constexpr double kSample_s = 1e-3;

/// Cubic between two knots.
VectorXd cubic(const PublishedJump& jump, Index from, const VectorXd& first_rad_s, double time_s) {
  const auto index = static_cast<std::size_t>(from);
  const double length_s = jump.times_s[index + 1] - jump.times_s[index];
  const double u = std::clamp((time_s - jump.times_s[index]) / length_s, 0.0, 1.0), rest = 1.0 - u;
  return rest * rest * (1.0 + 2.0 * u) * jump.positions_rad.col(from) +
         u * u * (3.0 - 2.0 * u) * jump.positions_rad.col(from + 1) +
         length_s * u * rest * (rest * first_rad_s - u * jump.velocities_rad_s.col(from + 1));
}

/// Positions of the whole robot over one of the three modes, at even times.
struct Stretch {
  std::vector<double> times_s;
  MatrixXd positions;  ///< (position size x samples)
  MatrixXd velocities, accelerations;

  double step_s() const { return times_s[1] - times_s[0]; }
  Index samples() const { return static_cast<Index>(times_s.size()); }
};

class JumpMaker {
 public:
  JumpMaker(const Robot& robot, const PublishedJump& jump, JumpClosure& closure)
      : robot_(robot), jump_(jump), closure_(closure), posture_(robot) {}

  Motion motion() {
    VectorXd first = dynamics::zero_position(robot_.tree);
    first[2] = 0.9;
    closure_.bent_rad = posture_.bent_by_weight(jump_.positions_rad.col(0), first);
    std::array<Stretch, 3> stretches;
    stretches[0] = joints_over(0, jump_.velocities_rad_s.col(0));
    stand(first, stretches[0]);
    differ(stretches[0]);
    stretches[1] = joints_over(1, jump_.velocities_rad_s.col(kModeKnots - 1));
    fly(stretches[0], stretches[1]);
    differ(stretches[1]);
    const VectorXd last = stretches[1].positions.rightCols<1>();
    stretches[2] = joints_over(2, rates_after(stretches[1]));
    VectorXd places_m = posture_.places_m(last);
    for (Index point = 2; point < places_m.size(); point += 3) places_m[point] = 0.0;
    stand_at(places_m, last, stretches[2]);
    differ(stretches[2]);
    return put_together(stretches);
  }

  Motion standing(double duration_s) {
    VectorXd first = dynamics::zero_position(robot_.tree);
    first[2] = 0.9;
    closure_.bent_rad = posture_.bent_by_weight(jump_.positions_rad.col(0), first);
    Stretch still;
    still.times_s = {0.0, duration_s};
    still.positions = first.replicate(1, 2);
    still.velocities = still.accelerations = MatrixXd::Zero(robot_.tree.velocity_size(), 2);
    Motion motion = empty();
    append(still, true, motion);
    return motion;
  }

 private:
  VectorXd motors_at(Index mode, const VectorXd& first_rad_s, double time_s) const {
    const Index first = mode * (kModeKnots - 1);
    Index from = first;
    while (from + 1 < first + kModeKnots - 1 &&
           jump_.times_s[static_cast<std::size_t>(from) + 1] <= time_s) {
      ++from;
    }
    const VectorXd slope = from == first ? first_rad_s : jump_.velocities_rad_s.col(from);
    return cubic(jump_, from, slope, time_s);
  }

  /// Base and rates are still to come.
  Stretch joints_over(Index mode, const VectorXd& first_rad_s) const {
    const auto first = static_cast<std::size_t>(mode * (kModeKnots - 1));
    const double from_s = jump_.times_s[first], until_s = jump_.times_s[first + kModeKnots - 1];
    const auto steps = static_cast<Index>(std::ceil((until_s - from_s) / kSample_s));
    Stretch stretch;
    stretch.positions.resize(robot_.tree.position_size(), steps + 1);
    for (Index i = 0; i <= steps; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(steps);
      stretch.times_s.push_back(from_s + share * (until_s - from_s));
      const VectorXd motors_rad = motors_at(mode, first_rad_s, stretch.times_s.back());
      stretch.positions.col(i).tail(joint_count()) = posture_.joints(motors_rad, closure_.bent_rad);
    }
    return stretch;
  }

  void stand(const VectorXd& first, Stretch& stretch) {
    VectorXd level = first;
    posture_.stand({}, true, level);
    VectorXd places_m = posture_.places_m(level);
    Vector3d middle_m = Vector3d::Zero();
    for (Index point = 0; point < places_m.size(); point += 3) {
      middle_m += 3.0 / static_cast<double>(places_m.size()) * places_m.segment<3>(point);
    }
    middle_m.z() = 0.0;
    for (Index point = 0; point < places_m.size(); point += 3) {
      places_m.segment<3>(point) -= middle_m;
      places_m[point + 2] = 0.0;
    }
    stand_at(places_m, level, stretch);
  }

  void stand_at(const VectorXd& places_m, const VectorXd& near, Stretch& stretch) {
    VectorXd position = near;
    for (Index i = 0; i < stretch.samples(); ++i) {
      position.tail(joint_count()) = stretch.positions.col(i).tail(joint_count());
      posture_.stand(places_m, false, position);
      stretch.positions.col(i) = position;
      const VectorXd off = posture_.places_m(position) - places_m;
      closure_.foot_slip_m = std::max(closure_.foot_slip_m, off.cwiseAbs().maxCoeff());
    }
  }

  /// Rates by central differences, of the second order at the ends too.
  void differ(Stretch& stretch) const {
    const Index n = robot_.tree.velocity_size(), last = stretch.samples() - 1;
    const double step_s = stretch.step_s();
    MatrixXd ways(n, last);  // from each sample to the next
    for (Index i = 0; i < last; ++i) {
      dynamics::position_difference(robot_.tree, stretch.positions.col(i),
                                    stretch.positions.col(i + 1), ways.col(i));
    }
    stretch.velocities.resize(n, last + 1);
    stretch.accelerations.resize(n, last + 1);
    for (Index i = 1; i < last; ++i) {
      stretch.velocities.col(i) = 0.5 * (ways.col(i - 1) + ways.col(i)) / step_s;
      stretch.accelerations.col(i) = (ways.col(i) - ways.col(i - 1)) / (step_s * step_s);
    }
    stretch.velocities.col(0) = (1.5 * ways.col(0) - 0.5 * ways.col(1)) / step_s;
    stretch.velocities.col(last) = (1.5 * ways.col(last - 1) - 0.5 * ways.col(last - 2)) / step_s;
    stretch.accelerations.col(0) = stretch.accelerations.col(1);
    stretch.accelerations.col(last) = stretch.accelerations.col(last - 1);
  }

  dynamics::Centroid centroid(const VectorXd& position, const VectorXd& velocity) {
    posture_.set(position, velocity);
    return posture_.body().centroid();
  }

  /// The momenta at take-off, and of those near them the ones with which the feet come down level.
  void fly(const Stretch& before, Stretch& flight) {
    const VectorXd start = before.positions.rightCols<1>();
    const dynamics::Centroid at = centroid(start, before.velocities.rightCols<1>());
    closure_.take_off_m_s = at.velocity_m_s;
    closure_.take_off_Nm_s = at.angular_momentum_Nm_s;
    const double time_s = flight.times_s.back() - flight.times_s.front();
    // Of roll and pitch momenta and of the upward speed.
    VectorXd sought(3);
    sought << at.angular_momentum_Nm_s.head<2>(),
        std::max(at.velocity_m_s.z(), 0.5 * time_s * robot_.tree.gravity_m_s2);
    const auto heights = [&](const VectorXd& with) {
      fly_with(start, at, with, flight);
      const VectorXd places_m = posture_.places_m(flight.positions.rightCols<1>());
      return VectorXd(Eigen::Map<const VectorXd, 0, Eigen::InnerStride<3>>(places_m.data() + 2,
                                                                           places_m.size() / 3));
    };
    for (int step = 0; step < 8; ++step) {
      const VectorXd here = heights(sought);
      MatrixXd slopes(here.size(), 3);
      for (Index i = 0; i < 3; ++i) {
        slopes.col(i) = (heights(sought + 1e-4 * VectorXd::Unit(3, i)) - here) / 1e-4;
      }
      const VectorXd more = -slopes.colPivHouseholderQr().solve(here);
      sought += more;
      if (more.norm() < 1e-9) break;
    }
    (void)heights(sought);
    closure_.flight_m_s = {at.velocity_m_s.x(), at.velocity_m_s.y(), sought[2]};
    closure_.flight_Nm_s = {sought[0], sought[1], at.angular_momentum_Nm_s.z()};
  }

  void fly_with(const VectorXd& start, const dynamics::Centroid& at, const VectorXd& with,
                Stretch& flight) {
    const Vector3d momentum_Nm_s(with[0], with[1], at.angular_momentum_Nm_s.z());
    const Vector3d speed_m_s(at.velocity_m_s.x(), at.velocity_m_s.y(), with[2]);
    VectorXd position = start;
    const double step_s = flight.step_s();
    for (Index i = 0; i < flight.samples(); ++i) {
      const double time_s = static_cast<double>(i) * step_s;
      position.tail(joint_count()) = flight.positions.col(i).tail(joint_count());
      Vector3d center_m = at.position_m + time_s * speed_m_s;
      center_m.z() -= 0.5 * robot_.tree.gravity_m_s2 * time_s * time_s;
      position.head<3>() +=
          center_m - centroid(position, VectorXd::Zero(robot_.tree.velocity_size())).position_m;
      flight.positions.col(i) = position;
      if (i + 1 == flight.samples()) return;
      turn(flight, i, momentum_Nm_s, position);
    }
  }

  /// Over a step, by the rate in its middle.
  void turn(const Stretch& flight, Index sample, const Vector3d& momentum_Nm_s,
            VectorXd& position) {
    const double step_s = flight.step_s();
    const VectorXd from = flight.positions.col(sample).tail(joint_count());
    const VectorXd to = flight.positions.col(sample + 1).tail(joint_count());
    VectorXd joint_rates = VectorXd::Zero(robot_.tree.velocity_size());
    joint_rates.tail(joint_count()) = (to - from) / step_s;
    VectorXd middle = position;
    VectorXd rate = VectorXd::Zero(robot_.tree.velocity_size());
    for (int again = 0; again < 2; ++again) {
      dynamics::step_position(robot_.tree, position, rate, 0.5 * step_s, middle);
      middle.tail(joint_count()) = 0.5 * (from + to);
      const dynamics::Centroid at = centroid(middle, joint_rates);
      const Vector3d rate_rad_s =
          at.inertia_kg_m2.ldlt().solve(Vector3d(momentum_Nm_s - at.angular_momentum_Nm_s));
      rate.segment<3>(3) = posture_.body().state().motion(0).R_WB.transpose() * rate_rad_s;
    }
    dynamics::step_position(robot_.tree, VectorXd(position), rate, step_s, position);
  }

  /// The motors' rates once both feet are at rest, springs as rigid as their authors have them.
  VectorXd rates_after(const Stretch& flight) {
    const VectorXd before = flight.velocities.rightCols<1>();
    posture_.set(flight.positions.rightCols<1>(), before);
    const MatrixXd feet = hopper::contact_rows(robot_, posture_.body().state(), all()).jacobian;
    const MatrixXd springs = posture_.spring_rows(posture_.body());
    MatrixXd rows(feet.rows() + springs.rows(), feet.cols());
    rows << feet, springs;
    MatrixXd mass(before.size(), before.size());
    posture_.body().mass_matrix(mass);
    const MatrixXd answers = mass.llt().solve(rows.transpose());
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> parts;
    parts.setThreshold(1e-9);
    const VectorXd after = before - answers * parts.compute(rows * answers).solve(rows * before);
    VectorXd motors_rad_s(kCassieMotors);
    for (Index i = 0; i < kCassieMotors; ++i) {
      motors_rad_s[i] = after[posture_.motor_rows()[static_cast<std::size_t>(i)]];
    }
    return motors_rad_s;
  }

  TouchingPoints all() const {
    return TouchingPoints::Constant(static_cast<Index>(robot_.contacts.size()), true);
  }
  Index joint_count() const { return robot_.tree.velocity_size() - kCassieBase; }

  Motion empty() const {
    Motion motion;
    motion.has_effort.assign(static_cast<std::size_t>(joint_count()), false);
    motion.has_touching = true;
    return motion;
  }

  void append(const Stretch& stretch, bool touches, Motion& motion) const {
    const Index before = motion.samples(), count = stretch.samples();
    motion.times_s.insert(motion.times_s.end(), stretch.times_s.begin(), stretch.times_s.end());
    const auto add = [&](const MatrixXd& from, MatrixXd& to) {
      to.conservativeResize(from.rows(), before + count);
      to.rightCols(count) = from;
    };
    add(stretch.positions, motion.positions);
    add(stretch.velocities, motion.velocities);
    add(stretch.accelerations, motion.accelerations);
    add(MatrixXd::Constant(static_cast<Index>(robot_.contacts.size()), count, touches ? 1.0 : 0.0),
        motion.touching);
  }

  /// At touch-down there are two samples of one time; take-off belongs to the stance.
  Motion put_together(const std::array<Stretch, 3>& stretches) const {
    Motion motion = empty();
    append(stretches[0], true, motion);
    Stretch air = stretches[1];
    air.times_s.erase(air.times_s.begin());
    const Index rest = air.samples();
    air.positions = air.positions.rightCols(rest).eval();
    air.velocities = air.velocities.rightCols(rest).eval();
    air.accelerations = air.accelerations.rightCols(rest).eval();
    append(air, false, motion);
    motion.breaks = {motion.samples()};
    append(stretches[2], true, motion);
    return motion;
  }

  const Robot& robot_;
  const PublishedJump& jump_;
  JumpClosure& closure_;
  CassiePosture posture_;
};

}  // namespace

PublishedJump read_jump(const std::filesystem::path& file) {
  io::CsvReader reader(file);
  const std::vector<std::string> header = reader.header();
  const auto place = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
  };
  PublishedJump jump;
  const std::array<MatrixXd*, 3> tables{&jump.positions_rad, &jump.velocities_rad_s,
                                        &jump.torques_Nm};
  while (reader.next()) {
    jump.times_s.push_back(reader.number(place("t")));
    const auto knots = static_cast<Index>(jump.times_s.size());
    for (std::size_t table = 0; table < tables.size(); ++table) {
      tables[table]->conservativeResize(kCassieMotors, knots);
      const std::string quantity = std::array{"q_", "qd_", "tau_"}[table];
      Index row = 0;
      for (const char* side : {"_left", "_right"}) {
        for (const char* joint : {"hip_roll", "hip_yaw", "hip_pitch", "knee", "toe"}) {
          (*tables[table])(row++, knots - 1) = reader.number(place(quantity + joint + side));
        }
      }
    }
  }
  return jump;
}

Motion jump_motion(const Robot& robot, const PublishedJump& jump, JumpClosure& closure) {
  return JumpMaker(robot, jump, closure).motion();
}

Motion standing_motion(const Robot& robot, const PublishedJump& jump, double duration_s) {
  JumpClosure closure;
  return JumpMaker(robot, jump, closure).standing(duration_s);
}

}  // namespace torquewright::test
