// SPDX-License-Identifier: Apache-2.0
#include "hopper/demand/demand.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "hopper/contact/cone_least_squares.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/time_text.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr Index kSamplesBetweenProgress = 2000;
constexpr double kLeastSize_m = 1e-6;
constexpr double kShortest = 1e-8;  // e of eq. (6)
constexpr double kNearGuide =
    1e-3;  // weight of given forces beside the base's motion: they are near
constexpr double kKnownForce = 0.1;   // weights: a guide that is off by more counts less
constexpr double kFarGuide = 1e-5;    // of forces far away, which must not move the base,
constexpr double kFarAway = 10.0;     // in weights, and times the forces there are
constexpr Index kDoubtSamples = 300;  // at which the doubt of shared forces is found

// Of a point that slides: straight against it, and at the edges of a pyramid that stands askew.
constexpr Index kBrakes = 3;
constexpr double kFarthestBrake_rad = 0.25 * std::numbers::pi;

/// Walks through a motion sample by sample; everything it works in is allocated once.
class DemandPass {
 public:
  DemandPass(const Robot& robot, const Motion& motion, const ContactSchedule& contacts)
      : robot_(robot),
        motion_(motion),
        contacts_(contacts),
        body_(robot),
        rows_(body_),
        solver_(static_cast<Index>(robot.contacts.size())),
        points_(static_cast<Index>(robot.contacts.size())),
        size_(robot.tree.velocity_size()) {
    allocate();
  }

  Demand run(const std::function<void(double)>& on_progress) {
    for (Index sample = 0; sample < motion_.samples(); ++sample) {
      set(sample);
      if (sample == 0) {
        measure_robot();
        note_noise();
      }
      if (motion_.has_base && motion_.is_break(sample)) add_jolt(sample);
      if (motion_.has_base) {
        solve_sample(sample);
      } else {
        take_file_torques(sample);
      }
      if (on_progress && sample % kSamplesBetweenProgress == 0) {
        on_progress(static_cast<double>(sample) / static_cast<double>(motion_.samples()));
      }
    }
    spread_shared_doubt();
    return std::move(demand_);
  }

  std::vector<double> unexplained(const std::vector<Touching>& schedules) {
    VectorXd squares = VectorXd::Zero(static_cast<Index>(schedules.size()));
    for (Index sample = 0; sample < motion_.samples(); ++sample) {
      set(sample);
      if (sample == 0) measure_robot();
      note_centroid(sample);
      ask(sample);
      add_unexplained(sample, schedules, squares);
    }
    const VectorXd rms = (squares / static_cast<double>(motion_.samples())).cwiseSqrt();
    return {rms.begin(), rms.end()};
  }

  MatrixXd left_by_sliding(const MatrixXd& direction, const MatrixXd& residual) {
    ConeLeastSquares solver(kBrakes * points_);
    MatrixXd left = residual;
    set(0);
    measure_robot();
    for (Index sample = 0; sample < motion_.samples(); ++sample) {
      if (direction.col(sample).isZero(0.0)) continue;
      set(sample);
      note_centroid(sample);
      ask(sample);
      const Index count =
          gather_contacts([&](Index i) { return contacts_.may_press(i, sample); }, sample);
      gather_columns(count);
      const Index cones = replace_by_brakes(count, direction.col(sample));
      rows_.take(force_, asked_);
      const auto columns = braking_.leftCols(3 * cones);
      const auto status =
          solver.solve(columns, asked_.cwiseQuotient(scales_), braking_friction_.head(cones));
      if (status != ConeLeastSquares::Status::kSolved) continue;  // its best is no proof
      left.col(sample) = asked_ - scales_.cwiseProduct(columns * solver.x());
    }
    return left;
  }

 private:
  /// Of points that slide the brakes' forces a newton of normal force each, in the place of their
  /// cones; how many cones that makes. A brake is the axis of a cone whose tangents do nothing.
  Index replace_by_brakes(Index count, const VectorXd& direction) {
    braking_.setZero(scaled_.rows(), 3 * kBrakes * points_);
    braking_friction_.setOnes(kBrakes * points_);
    Index cones = 0;
    for (Index k = 0; k < count; ++k) {
      const Eigen::Vector2d slip = direction.segment<2>(2 * touching_[static_cast<std::size_t>(k)]);
      const auto columns = scaled_.middleCols(3 * k, 3);
      if (slip.isZero(0.0)) {
        braking_.middleCols(3 * cones, 3) = columns;
        braking_friction_[cones++] = friction_[k];
        continue;
      }
      for (Index brake = 0; brake < kBrakes; ++brake) {
        const double turned_rad = kFarthestBrake_rad * static_cast<double>(brake - 1);
        const Eigen::Vector2d force = -friction_[k] * (Eigen::Rotation2Dd(turned_rad) * slip);
        braking_.col(3 * cones++ + 2) = columns * Vector3d(force.x(), force.y(), 1.0);
      }
    }
    return cones;
  }

  /// Schedules that agree at the sample share their answer.
  void add_unexplained(Index sample, const std::vector<Touching>& schedules, VectorXd& squares) {
    VectorXd found = VectorXd::Zero(squares.size());
    for (std::size_t i = 0; i < schedules.size(); ++i) {
      const auto& presses = schedules[i];
      const auto at = static_cast<Index>(i);
      const auto same = [&](std::size_t other) {
        return (schedules[other].col(sample) == presses.col(sample)).all();
      };
      std::size_t known = i;
      for (std::size_t other = i; known == i && other-- > 0;) known = same(other) ? other : i;
      if (known != i) {
        found[at] = found[static_cast<Index>(known)];
        continue;
      }
      load_ = force_;
      solve_forces([&](Index point) { return presses(point, sample); }, sample);
      rows_.take(load_, asked_);
      found[at] = asked_.cwiseQuotient(scales_).squaredNorm();
    }
    squares += found;
  }

  void allocate() {
    const Index samples = motion_.samples();
    const auto drives = static_cast<Index>(body_.drive_count());
    has_file_torque_ = !robot_.drivetrains.empty();
    for (const Drivetrain& drivetrain : robot_.drivetrains) {
      for (const std::size_t joint : drivetrain.joints) {
        has_file_torque_ = has_file_torque_ && motion_.has_effort[joint - 1];
      }
    }
    demand_.has_dynamics = motion_.has_base;
    find_given_passive();
    demand_.drives.assign(body_.drive_count(), std::vector<DriveInstant>(motion_.times_s.size()));
    demand_.contact_Nm.setZero(drives, samples);
    if (has_file_torque_) demand_.file_torque_Nm.setZero(drives, samples);
    demand_.forces_N.setZero(3 * points_, samples);
    demand_.unsampled_Nm_s.setZero(drives, samples);
    demand_.shared_doubt_Nm.setZero(drives, samples);
    at_drives_.setZero(drives, 3 * points_);
    doubt_stride_ = std::max<Index>(1, samples / kDoubtSamples);
    demand_.before_gears_kg_m2.resize(drives);
    for (Index i = 0; i < drives; ++i) {
      demand_.before_gears_kg_m2[i] = body_.before_gears_kg_m2(static_cast<std::size_t>(i));
    }
    demand_.joint_effort.setZero(static_cast<Index>(robot_.tree.bodies.size()) - 1, samples);
    demand_.residual.setZero(rows_.size(), samples);
    demand_.rows = rows_.kinds();
    demand_.center_of_mass_m.setZero(3, samples);
    demand_.angular_momentum_Nm_s.setZero(3, samples);
    demand_.angular_velocity_rad_s.setZero(3, samples);
    demand_.lateral_inertia_kg_m2.setZero(1, samples);
    jacobians_.setZero(size_, 3 * points_);
    columns_.setZero(rows_.size(), 3 * points_);
    scaled_.setZero(rows_.size(), 3 * points_);
    friction_.setZero(points_);
    asked_.setZero(rows_.size());
    force_.setZero(size_);
    load_.setZero(size_);
    for (VectorXd* vector : {&change_, &lacking_, &still_, &held_}) vector->setZero(size_);
    drive_torque_.setZero(drives);
  }

  /// Joints that no actuator moves and whose torque the file gives.
  void find_given_passive() {
    std::vector<bool> is_driven(robot_.tree.bodies.size(), false);
    for (const Drivetrain& drivetrain : robot_.drivetrains) {
      for (const std::size_t joint : drivetrain.joints) is_driven[joint] = true;
    }
    for (std::size_t joint = 1; joint < is_driven.size(); ++joint) {
      if (!is_driven[joint] && motion_.has_effort[joint - 1]) given_passive_.push_back(joint);
    }
  }

  void set(Index sample) {
    if (body_.set(motion_.positions.col(sample), motion_.velocities.col(sample))) return;
    std::string angles;
    const Index joints = static_cast<Index>(robot_.tree.bodies.size()) - 1;
    for (const std::size_t joint : body_.unreached().joints) {
      const Index row = motion_.positions.rows() - joints + static_cast<Index>(joint) - 1;
      angles += fmt::format("{}{} at {:.6g} rad", angles.empty() ? "" : ", ",
                            robot_.tree.bodies[joint].joint.name, motion_.positions(row, sample));
    }
    io::refuse(motion_.file,
               fmt::format("t = {} s: {}: there {} cannot be, or it is singular",
                           io::time_text(motion_.time_s(sample)), angles, body_.unreached().what));
  }

  void measure_robot() {
    const dynamics::Centroid all = body_.centroid();
    demand_.weight_N = all.mass_kg * gravity_of_limits_m_s2(robot_.tree);
    demand_.size_m =
        std::max(kLeastSize_m, std::sqrt(all.inertia_kg_m2.trace() / 2.0 / all.mass_kg));
    scales_ = rows_.scales(demand_.weight_N, demand_.size_m);
  }

  /// What the accelerations' noise is in the free rows: M times it.
  void note_noise() {
    demand_.residual_noise.setZero(rows_.size());
    if (motion_.acceleration_noise.size() == 0 || !motion_.has_base) return;
    note_centroid(0);
    MatrixXd mass(size_, size_);
    body_.mass_matrix(mass);
    MatrixXd free(rows_.size(), size_);
    rows_.take(mass, free);
    demand_.residual_noise =
        (free.cwiseAbs2() * motion_.acceleration_noise.cwiseAbs2()).cwiseSqrt();
  }

  /// Where the ground presses on a contact point: soft ground, into which it has sunk, halfway
  /// between the point and the surface.
  dynamics::BodyPoint pressed_point(Index i, Index sample) {
    dynamics::BodyPoint point =
        touching_point(robot_.contacts[static_cast<std::size_t>(i)], body_.state());
    if (contacts_.height_m.size() == 0 || contacts_.height_m(i, sample) >= 0.0) return point;
    const Vector3d up_m(0, 0, -0.5 * contacts_.height_m(i, sample));
    point.p_B_m += body_.state().motion(point.body).R_WB.transpose() * up_m;
    return point;
  }

  /// Jacobians of the points of which it is asked, transposed, side by side; how many there are.
  template <typename Feels>
  Index gather_contacts(const Feels& feels, Index sample) {
    touching_.clear();
    for (Index i = 0; i < points_; ++i) {
      if (feels(i)) touching_.push_back(i);
    }
    const auto count = static_cast<Index>(touching_.size());
    for (Index k = 0; k < count; ++k) {
      const Index i = touching_[static_cast<std::size_t>(k)];
      jacobian_.setZero(3, size_);
      dynamics::point_jacobian(body_.state(), pressed_point(i, sample), jacobian_);
      jacobians_.middleCols(3 * k, 3) = jacobian_.transpose();
      friction_[k] = robot_.contacts[static_cast<std::size_t>(i)].friction_coefficient;
    }
    return count;
  }

  /// The free rows of the points' Jacobians, also in units of the rows' scales' force.
  void gather_columns(Index count) {
    columns_.leftCols(3 * count).setZero();
    rows_.take(jacobians_.leftCols(3 * count), columns_.leftCols(3 * count));
    scaled_.leftCols(3 * count) =
        scales_.cwiseInverse().asDiagonal() * columns_.leftCols(3 * count) * demand_.weight_N;
  }

  /// Forces on the touching points whose sum is nearest to what the free rows ask for.
  /// `asked` is in the units of the rows; the answer in those over the rows' scales' force.
  void share_out(Index count, const VectorXd& asked, double unit,
                 const ConeLeastSquares::Guide* guide = nullptr) {
    gather_columns(count);
    const VectorXd target = asked.cwiseQuotient(scales_) / unit;
    const auto status =
        solver_.solve(scaled_.leftCols(3 * count), target, friction_.head(count), guide);
    if (status != ConeLeastSquares::Status::kSolved) ++demand_.unsolved;
    shared_ = solver_.x() * (demand_.weight_N * unit);
    demand_.is_shared = demand_.is_shared || 3 * count > rows_.size();
  }

  void solve_sample(Index sample) {
    note_centroid(sample);
    ask(sample);
    load_ = force_;
    if (motion_.has_forces && !motion_.forces_guide) {
      take_file_forces(sample);
    } else {
      const Index count =
          solve_forces([&](Index i) { return contacts_.may_press(i, sample); }, sample);
      store_forces(count, sample);
      if (!motion_.has_forces) note_shared_doubt(count, sample);
    }
    take_off_held(sample);
    rows_.take(load_, asked_);
    demand_.residual.col(sample) = asked_;
    if (sample > 0 && !motion_.is_break(sample)) store_unsampled(sample);
    store_drives(sample);
    if (has_file_torque_) store_file_torque(sample);
  }

  /// Forces for the sample's accelerations. Rotors apart: they load no free row (but through the
  /// base's acceleration, which none has).
  void ask(Index sample) {
    body_.body_forces(motion_.accelerations.col(sample), force_);
    body_.add_dampers_and_springs(force_);
    body_.add_dry_friction(motion_.accelerations.col(sample), force_);
    for (const std::size_t joint : given_passive_) {
      const auto row = static_cast<Index>(joint) - 1;
      force_[body_.state().joint_row(joint)] -= motion_.efforts(row, sample);
    }
  }

  /// What the joints' own friction holds of the load, of joints that rest.
  void take_off_held(Index sample) {
    body_.held_by_friction(motion_.accelerations.col(sample), load_, held_);
    load_ -= held_;
    force_ -= held_;
  }

  void note_centroid(Index sample) {
    const dynamics::Centroid all = body_.centroid();
    rows_.set(body_.state(), all.position_m);
    demand_.center_of_mass_m.col(sample) = all.position_m;
    demand_.angular_momentum_Nm_s.col(sample) = all.angular_momentum_Nm_s;
    demand_.angular_velocity_rad_s.col(sample) = all.angular_velocity_rad_s;
    demand_.lateral_inertia_kg_m2(0, sample) = all.inertia_kg_m2(1, 1);
  }

  void take_file_forces(Index sample) {
    demand_.forces_N.col(sample) = motion_.forces_N.col(sample);
    for (Index i = 0; i < points_; ++i) {
      const Vector3d force_N = motion_.forces_N.block<3, 1>(3 * i, sample);
      dynamics::add_point_force(body_.state(), pressed_point(i, sample), -force_N, load_);
    }
  }

  /// Takes the forces of the points that press off the load; how many there are.
  template <typename Presses>
  Index solve_forces(const Presses& presses, Index sample) {
    const Index count = gather_contacts(presses, sample);
    if (count == 0) return 0;
    rows_.take(force_, asked_);
    if (motion_.forces_guide) {
      guide_ = {VectorXd(3 * count), VectorXd(3 * count)};
      for (Index k = 0; k < count; ++k) {
        const Index point = touching_[static_cast<std::size_t>(k)];
        guide_.x.segment<3>(3 * k) = contacts_.guide_N.block<3, 1>(3 * point, sample);
        const double doubt = contacts_.guide_doubt_N(point, sample) / demand_.weight_N;
        guide_.weights.segment<3>(3 * k).setConstant(
            kNearGuide / (1.0 + doubt * doubt / (kKnownForce * kKnownForce)));
      }
      guide_.x /= demand_.weight_N;
    }
    share_out(count, asked_, 1.0, motion_.forces_guide ? &guide_ : nullptr);
    load_.noalias() -= jacobians_.leftCols(3 * count) * shared_;
    return count;
  }

  void store_forces(Index count, Index sample) {
    for (Index k = 0; k < count; ++k) {
      demand_.forces_N.block<3, 1>(3 * touching_[static_cast<std::size_t>(k)], sample) =
          shared_.segment<3>(3 * k);
    }
  }

  /// The drives' torques at the farthest that forces inside the cones can go, without moving a free
  /// row, either way along those that move each torque the most.
  void note_shared_doubt(Index count, Index sample) {
    if (sample % doubt_stride_ != 0 || count < 2 || rows_.size() == 0) return;
    const auto columns = scaled_.leftCols(3 * count);
    MatrixXd gram = columns * columns.transpose();
    gram.diagonal().array() += kShortest;
    const Eigen::LDLT<MatrixXd> factor(gram);
    for (Index k = 0; k < 3 * count; ++k) {
      body_.at_actuators(jacobians_.col(k), drive_torque_);
      at_drives_.col(k) = drive_torque_;
    }
    rows_.take(force_, asked_);
    const VectorXd target = asked_.cwiseQuotient(scales_);
    for (Index drive = 0; drive < at_drives_.rows(); ++drive) {
      const VectorXd pull = at_drives_.row(drive).head(3 * count).transpose();
      const VectorXd way = pull - columns.transpose() * factor.solve(columns * pull);
      if (way.squaredNorm() <= kShortest * pull.squaredNorm()) continue;
      const double away = kFarAway * (1.0 + shared_.norm() / demand_.weight_N);
      for (const double far : {-away, away}) {
        guide_ = {shared_ / demand_.weight_N + far * way.normalized(),
                  VectorXd::Constant(3 * count, kFarGuide)};
        solver_.solve(columns, target, friction_.head(count), &guide_);
        const double change_Nm =
            std::abs(pull.dot(VectorXd(solver_.x() * demand_.weight_N - shared_)));
        double& doubt_Nm = demand_.shared_doubt_Nm(drive, sample);
        doubt_Nm = std::max(doubt_Nm, change_Nm);
      }
    }
  }

  /// Samples between those that were asked have the greater doubt of the two beside.
  void spread_shared_doubt() {
    MatrixXd& doubt_Nm = demand_.shared_doubt_Nm;
    for (Index sample = 0; sample < motion_.samples(); ++sample) {
      const Index before = sample - sample % doubt_stride_;
      if (sample == before) continue;
      const Index after = std::min(before + doubt_stride_, motion_.samples() - 1);
      doubt_Nm.col(sample) = doubt_Nm.col(before);
      if (after % doubt_stride_ == 0) {
        doubt_Nm.col(sample) = doubt_Nm.col(sample).cwiseMax(doubt_Nm.col(after));
      }
    }
  }

  /// Eq. (18): the velocities changed by dv, the samples' accelerations make up for a part of it.
  void store_unsampled(Index sample) {
    const double step_s = motion_.step_s(sample - 1);
    change_ =
        motion_.velocities.col(sample) - motion_.velocities.col(sample - 1) -
        0.5 * step_s * (motion_.accelerations.col(sample) + motion_.accelerations.col(sample - 1));
    // Forces are linear in the acceleration: the difference of two is M times the change.
    const VectorXd shifted = motion_.accelerations.col(sample) + change_;
    body_.body_forces(shifted, lacking_);
    body_.body_forces(motion_.accelerations.col(sample), still_);
    lacking_ -= still_;
    const auto presses = [&](Index i) {
      return contacts_.may_press(i, sample) || contacts_.may_press(i, sample - 1);
    };
    const Index count = gather_contacts(presses, sample);
    if (count > 0 && rows_.size() > 0) take_off_ground(sample, step_s, count);
    still_.setZero();
    body_.add_rotors(shifted, lacking_);
    body_.add_rotors(motion_.accelerations.col(sample), still_);
    lacking_ -= still_;
    body_.at_actuators(lacking_, drive_torque_);
    demand_.unsampled_Nm_s.col(sample) = drive_torque_;
  }

  /// What of it the ground gives: the shortest impulses that leave the free rows nothing, those
  /// included that contact forces left over.
  void take_off_ground(Index sample, double step_s, Index count) {
    gather_columns(count);
    rows_.take(lacking_, asked_);
    asked_ += 0.5 * step_s * (demand_.residual.col(sample) + demand_.residual.col(sample - 1));
    const auto columns = scaled_.leftCols(3 * count);
    MatrixXd gram = columns * columns.transpose();
    gram.diagonal().array() += kShortest;
    shared_ = columns.transpose() * gram.ldlt().solve(asked_.cwiseQuotient(scales_));
    shared_ *= demand_.weight_N;
    lacking_.noalias() -= jacobians_.leftCols(3 * count) * shared_;
  }

  void store_drives(Index sample) {
    body_.drives(motion_.accelerations.col(sample), load_, instants_);
    for (std::size_t i = 0; i < instants_.size(); ++i) {
      demand_.drives[i][static_cast<std::size_t>(sample)] = instants_[i];
    }
    force_ -= load_;  // what the contacts do
    body_.add_rotors(motion_.accelerations.col(sample), load_);
    demand_.joint_effort.col(sample) = load_.tail(demand_.joint_effort.rows());
    body_.at_actuators(force_, drive_torque_);
    demand_.contact_Nm.col(sample) = drive_torque_;
  }

  void store_file_torque(Index sample) {
    load_.tail(motion_.efforts.rows()) = motion_.efforts.col(sample);
    body_.at_actuators(load_, drive_torque_);
    demand_.file_torque_Nm.col(sample) = drive_torque_;
  }

  /// Nothing is said of the base: the file's torques are all there is.
  void take_file_torques(Index sample) {
    load_.setZero();
    store_drives_without_dynamics(sample);
    if (has_file_torque_) store_file_torque(sample);
  }

  void store_drives_without_dynamics(Index sample) {
    body_.drives(motion_.accelerations.col(sample), load_, instants_);
    for (std::size_t i = 0; i < instants_.size(); ++i) {
      demand_.drives[i][static_cast<std::size_t>(sample)] = instants_[i];
    }
  }

  /// From the sample before to this one: M dv + (bias) dt = J^T Lambda + (motors) dt, eq. (10).
  void add_jolt(Index sample) {
    Jolt jolt;
    jolt.sample = sample;
    jolt.time_s = motion_.time_s(sample);
    const double step_s = motion_.step_s(sample - 1);
    const VectorXd change = motion_.velocities.col(sample) - motion_.velocities.col(sample - 1);
    MatrixXd mass(size_, size_);
    body_.mass_matrix(mass);
    const dynamics::Centroid all = body_.centroid();
    rows_.set(body_.state(), all.position_m);
    VectorXd impulse(size_);
    body_.body_forces(VectorXd::Zero(size_), impulse);
    body_.add_dampers_and_springs(impulse);
    impulse = (mass * change + impulse * step_s).eval();
    const VectorXd before = motion_.velocities.col(sample - 1);
    const VectorXd after = motion_.velocities.col(sample);
    jolt.lost_energy_J = 0.5 * (before.dot(mass * before) - after.dot(mass * after));
    jolt.impulses_N_s.setZero(3 * points_);
    VectorXd contact = VectorXd::Zero(size_);
    const auto feels = [&](Index i) {
      return contacts_.touches(i, sample) ||
             contacts_.height_m(i, sample) <= contacts_.near_ground_m;
    };
    const Index count = gather_contacts(feels, sample);
    note_velocities(count, sample, jolt);
    if (count > 0) {
      rows_.take(impulse, asked_);
      share_out(count, asked_, std::sqrt(demand_.size_m / gravity_of_limits_m_s2(robot_.tree)));
      contact = jacobians_.leftCols(3 * count) * shared_;
      for (Index k = 0; k < count; ++k) {
        jolt.impulses_N_s.segment<3>(3 * touching_[static_cast<std::size_t>(k)]) =
            shared_.segment<3>(3 * k);
      }
    }
    finish_jolt(change, contact, impulse - contact, jolt);
    demand_.jolts.push_back(std::move(jolt));
  }

  /// Of the touching points, beside a jump.
  void note_velocities(Index count, Index sample, Jolt& jolt) {
    jolt.before_m_s.setZero(3 * points_);
    jolt.after_m_s.setZero(3 * points_);
    jolt.beside_m_s.setZero(points_);
    const Index reach = std::max<Index>(1, motion_.reach);
    Index first = sample - 1;
    while (first > 0 && sample - 1 - first < reach && !motion_.is_break(first)) --first;
    Index last = sample;
    while (last + 1 < motion_.samples() && last - sample < reach && !motion_.is_break(last + 1)) {
      ++last;
    }
    const auto at = [&](Index k, Index of) -> Vector3d {
      return jacobians_.middleCols(3 * k, 3).transpose() * motion_.velocities.col(of);
    };
    for (Index k = 0; k < count; ++k) {
      const Index point = touching_[static_cast<std::size_t>(k)];
      jolt.before_m_s.segment<3>(3 * point) = at(k, sample - 1);
      jolt.after_m_s.segment<3>(3 * point) = at(k, sample);
      jolt.beside_m_s[point] =
          (at(k, sample - 1) - at(k, first)).norm() + (at(k, last) - at(k, sample)).norm();
    }
  }

  void finish_jolt(const VectorXd& change, const VectorXd& contact, const VectorXd& left,
                   Jolt& jolt) {
    rows_.take(left, asked_);
    jolt.residual = asked_;
    const auto drives = static_cast<Index>(body_.drive_count());
    jolt.contact_Nm_s.resize(drives);
    jolt.drive_Nm_s.resize(drives);
    jolt.rotor_Nm_s.resize(drives);
    body_.at_actuators(contact, jolt.contact_Nm_s);
    body_.at_actuators(left, jolt.drive_Nm_s);
    body_.speed_changes(change, jolt.rotor_Nm_s);
    VectorXd carried_Nm_s(drives);
    body_.carried_momenta(change, carried_Nm_s);
    for (Index i = 0; i < drives; ++i) {
      jolt.rotor_Nm_s[i] =
          body_.before_gears_kg_m2(static_cast<std::size_t>(i)) * jolt.rotor_Nm_s[i] +
          carried_Nm_s[i];
    }
  }

  const Robot& robot_;
  const Motion& motion_;
  const ContactSchedule& contacts_;
  WholeBody body_;
  FreeRows rows_;
  ConeLeastSquares solver_;
  Index points_;
  Index size_;
  bool has_file_torque_ = false;
  std::vector<std::size_t> given_passive_;
  Demand demand_;
  VectorXd scales_;
  std::vector<Index> touching_;
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian_;
  MatrixXd jacobians_;  ///< Transposed, three columns a touching point.
  MatrixXd columns_;    ///< Their free rows.
  MatrixXd scaled_;
  MatrixXd braking_;  ///< Those with brakes in the place of what slides,
  VectorXd braking_friction_;
  VectorXd friction_;
  VectorXd asked_;
  VectorXd force_;
  VectorXd load_;
  VectorXd change_;
  VectorXd lacking_;
  VectorXd still_;
  VectorXd held_;
  VectorXd shared_;
  ConeLeastSquares::Guide guide_;
  Index doubt_stride_ = 1;
  MatrixXd at_drives_;  ///< By drive and force, three columns a touching point.
  VectorXd drive_torque_;
  std::vector<DriveInstant> instants_;
};

}  // namespace

Demand demand_of(const Robot& robot, const Motion& motion, const ContactSchedule& contacts,
                 const std::function<void(double share)>& on_progress) {
  return DemandPass(robot, motion, contacts).run(on_progress);
}

std::vector<double> unexplained_shares(const Robot& robot, const Motion& motion,
                                       const ContactSchedule& contacts,
                                       const std::vector<Touching>& schedules) {
  return DemandPass(robot, motion, contacts).unexplained(schedules);
}

MatrixXd left_by_sliding(const Robot& robot, const Motion& motion, const ContactSchedule& contacts,
                         const MatrixXd& direction, const MatrixXd& residual) {
  return DemandPass(robot, motion, contacts).left_by_sliding(direction, residual);
}

}  // namespace torquewright::hopper
