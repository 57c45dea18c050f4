// SPDX-License-Identifier: Apache-2.0
#include "tests/real_data/cassie/standing_modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "dynamics/position_step.hpp"
#include "hopper/tracking/linearisation.hpp"

namespace torquewright::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double kStep = 1e-4;    // of differences: links close to 1e-10 or so
constexpr double kSoon_s = 1e-9;  // too soon for a low-pass to let anything pass

class Modes {
 public:
  Modes(const hopper::Robot& robot, const hopper::ReferenceInstant& stands,
        hopper::Controller& controller)
      : robot_(robot),
        stands_(stands),
        controller_(controller),
        body_(robot),
        touches_(hopper::TouchingPoints::Constant(static_cast<Index>(robot.contacts.size()), true)),
        size_(robot.tree.velocity_size()) {}

  StandingModes of(const AnswerTimes& times) {
    const MatrixXd free = free_ways();
    const Index room = free.cols(), drives = stands_.drive_Nm.size(), state = 2 * room;
    const Index passed = state + drives;  // velocities behind the low-pass
    MatrixXd ways = MatrixXd::Zero(2 * size_, state);
    ways.topLeftCorner(size_, room) = free;
    ways.bottomRightCorner(size_, room) = free;
    const VectorXd still = VectorXd::Zero(2 * size_);
    const VectorXd holds_Nm = torque(still);
    const Index behind = times.low_pass_s > 0.0 ? room : 0;
    MatrixXd model = MatrixXd::Zero(passed + behind, passed + behind);
    model.block(0, room, room, room).setIdentity();
    for (Index i = 0; i < state; ++i) {
      model.block(room, i, room, 1) =
          free.transpose() * slope([&](double by) { return moves(by * ways.col(i), holds_Nm); });
      model.block(state, i, drives, 1) =
          slope([&](double by) { return next_torque(by * ways.col(i)); }) / times.lag_s;
    }
    for (Index i = 0; i < drives; ++i) {
      const VectorXd one = VectorXd::Unit(drives, i);
      model.block(room, state + i, room, 1) =
          free.transpose() * slope([&](double by) { return moves(still, holds_Nm + by * one); });
      model(state + i, state + i) = -1.0 / times.lag_s;
    }
    for (Index i = 0; i < behind; ++i) {
      const VectorXd at_once =
          slope([&](double by) { return torque(by * ways.col(room + i)); }) / times.lag_s;
      model.block(state, passed + i, drives, 1) = at_once - model.block(state, room + i, drives, 1);
      model(passed + i, room + i) = 1.0 / times.low_pass_s;
      model(passed + i, passed + i) = -1.0 / times.low_pass_s;
    }
    return sorted(model, ways);
  }

 private:
  /// Velocities of a robot whose feet hold.
  MatrixXd free_ways() {
    if (!body_.set(stands_.position, VectorXd::Zero(size_))) throw std::runtime_error("unreached");
    const MatrixXd feet = hopper::contact_rows(robot_, body_.state(), touches_).jacobian;
    Eigen::ColPivHouseholderQR<MatrixXd> parts;
    parts.setThreshold(1e-9);
    parts.compute(feet.transpose());
    const MatrixXd basis = parts.householderQ();
    return basis.rightCols(size_ - parts.rank());
  }

  template <typename Function>
  static VectorXd slope(const Function& function) {
    return (function(kStep) - function(-kStep)) / (2.0 * kStep);
  }

  VectorXd position(const VectorXd& deviation) const {
    VectorXd out = stands_.position;
    dynamics::step_position(robot_.tree, stands_.position, VectorXd(deviation.head(size_)), 1.0,
                            out);
    return out;
  }

  /// Of a first look, and of one right after a first look at rest.
  VectorXd torque(const VectorXd& deviation) {
    controller_.start();
    return look(0.0, deviation);
  }
  VectorXd next_torque(const VectorXd& deviation) {
    (void)torque(VectorXd::Zero(2 * size_));
    return look(kSoon_s, deviation);
  }
  VectorXd look(double time_s, const VectorXd& deviation) {
    VectorXd out(stands_.drive_Nm.size());
    controller_.control({.time_s = time_s,
                         .position = position(deviation),
                         .velocity = deviation.tail(size_),
                         .touches = touches_},
                        out);
    return out;
  }

  VectorXd moves(const VectorXd& deviation, const VectorXd& drive_Nm) {
    const auto out = hopper::held_acceleration(
        body_, {position(deviation), deviation.tail(size_), drive_Nm}, touches_);
    if (!out) throw std::runtime_error("a mechanism does not reach a deviation");
    return *out;
  }

  static StandingModes sorted(const MatrixXd& model, const MatrixXd& ways) {
    const Eigen::EigenSolver<MatrixXd> solver(model);
    std::vector<Index> order(static_cast<std::size_t>(model.cols()));
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      return solver.eigenvalues()[a].real() > solver.eigenvalues()[b].real();
    });
    StandingModes out;
    out.rates_1_s = solver.eigenvalues()(order);
    out.shapes = ways * solver.eigenvectors()(Eigen::seq(0, ways.cols() - 1), order);
    return out;
  }

  const hopper::Robot& robot_;
  const hopper::ReferenceInstant& stands_;
  hopper::Controller& controller_;
  hopper::WholeBody body_;
  hopper::TouchingPoints touches_;
  Index size_;
};

}  // namespace

StandingModes standing_modes(const hopper::Robot& robot, const hopper::ReferenceInstant& stands,
                             hopper::Controller& controller, const AnswerTimes& times) {
  return Modes(robot, stands, controller).of(times);
}

}  // namespace torquewright::test
