// SPDX-License-Identifier: Apache-2.0
#include "tests/real_data/cassie/cassie_posture.hpp"

#include <Eigen/QR>
#include <cmath>
#include <stdexcept>
#include <string>

#include "dynamics/position_step.hpp"
#include "hopper/tracking/contact_rows.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using hopper::Robot;
using hopper::TouchingPoints;

namespace {

constexpr double kBend_rad = 1e-4;  // of differences

std::size_t body_of(const Robot& robot, const std::string& joint) {
  const auto body = robot.find_joint(joint);
  if (!body) throw std::runtime_error("Cassie has no joint " + joint);
  return *body;
}

Index row_of(std::size_t body) { return kCassieBase + static_cast<Index>(body) - 1; }

/// Places of joints in `joints` and in positions.
Index place_of(std::size_t body) { return static_cast<Index>(body) - 1; }

}  // namespace

CassiePosture::CassiePosture(const Robot& robot) : robot_(robot), body_(robot) {
  std::size_t motor = 0, link = 0;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string name = side == 0 ? "left-" : "right-";
    for (const char* joint : {"hip-roll", "hip-yaw", "hip-pitch", "knee", "foot"}) {
      motor_rows_[motor++] = row_of(body_of(robot, name + joint));
    }
    Leg& leg = legs_[side];
    leg.knee = body_of(robot, name + "knee");
    leg.shin = body_of(robot, name + "shin");
    leg.tarsus = body_of(robot, name + "tarsus");
    leg.foot = body_of(robot, name + "foot");
    for (const hopper::Follower& follower : robot.followers) {
      for (const std::size_t joint : follower.joints) {
        if (joint == leg.tarsus) leg.follower = &follower;
      }
    }
    if (leg.follower == nullptr) throw std::runtime_error("Cassie's Achilles rod is not here");
    const auto& bodies = leg.follower->links->geometry().tree.bodies;
    for (std::size_t i = leg.follower->joints.size() + 1; i < bodies.size(); ++i) {
      if (bodies[i].joint.passive.stiffness > 0.0) leg.heel = place_of(i);
    }
    const auto links = body_.links();
    for (link = 0; link < links.size(); ++link) {
      if (links[link].joint.name == bodies[static_cast<std::size_t>(leg.heel) + 1].joint.name) {
        leg.heel_link = link;
      }
    }
  }
}

double CassiePosture::heel_rad(const Leg& leg, double knee_rad, double shin_rad,
                               double tarsus_rad) const {
  VectorXd joints(static_cast<Index>(leg.follower->joints.size()));
  for (Index i = 0; i < joints.size(); ++i) {
    const std::size_t body = leg.follower->joints[static_cast<std::size_t>(i)];
    joints[i] = body == leg.knee ? knee_rad : body == leg.shin ? shin_rad : tarsus_rad;
  }
  const VectorXd still = VectorXd::Zero(joints.size());
  const auto followed = leg.follower->links->follow<double>(joints, still);
  if (!followed) throw std::runtime_error("Cassie's Achilles rod does not close");
  return followed->position[leg.heel];
}

/// By secants.
double CassiePosture::tarsus_rad(const Leg& leg, double knee_rad, double shin_rad,
                                 double heel_rad) const {
  const auto off = [&](double tarsus_rad) {
    return this->heel_rad(leg, knee_rad, shin_rad, tarsus_rad) - heel_rad;
  };
  double before = 0.227 - knee_rad - shin_rad, here = before + kBend_rad;
  double off_before = off(before), off_here = off(here);
  for (int step = 0; step < 30 && std::abs(off_here) > 1e-13 && off_here != off_before; ++step) {
    const double next = here - off_here * (here - before) / (off_here - off_before);
    before = here;
    off_before = off_here;
    here = next;
    off_here = off(here);
  }
  return here;
}

VectorXd CassiePosture::joints(const VectorXd& motors_rad, const CassieSprings& bent_rad) const {
  VectorXd joints = VectorXd::Zero(static_cast<Index>(robot_.tree.bodies.size()) - 1);
  for (Index motor = 0; motor < kCassieMotors; ++motor) {
    joints[motor_rows_[static_cast<std::size_t>(motor)] - kCassieBase] = motors_rad[motor];
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const Leg& leg = legs_[side];
    const auto of = 2 * static_cast<Index>(side);
    const double knee_rad = joints[place_of(leg.knee)];
    const double shin_rad = joints[place_of(leg.shin)] = bent_rad[of];
    const double tarsus_rad = joints[place_of(leg.tarsus)] =
        this->tarsus_rad(leg, knee_rad, shin_rad, bent_rad[of + 1]);
    joints[place_of(leg.foot)] -= shin_rad + tarsus_rad - this->tarsus_rad(leg, knee_rad, 0.0, 0.0);
  }
  return joints;
}

MatrixXd CassiePosture::spring_rows(const hopper::WholeBody& body) const {
  MatrixXd rows = MatrixXd::Zero(4, robot_.tree.velocity_size());
  for (std::size_t side = 0; side < 2; ++side) {
    const auto of = 2 * static_cast<Index>(side);
    rows(of, row_of(legs_[side].shin)) = 1.0;
    rows.row(of + 1) = body.link_motion(legs_[side].heel_link).transpose();
  }
  return rows;
}

void CassiePosture::set(const VectorXd& position, const VectorXd& velocity) {
  if (!body_.set(position, velocity)) throw std::runtime_error(body_.unreached().what);
}

VectorXd CassiePosture::places_m(const VectorXd& position) {
  set(position, VectorXd::Zero(robot_.tree.velocity_size()));
  VectorXd places_m(3 * static_cast<Index>(robot_.contacts.size()));
  for (std::size_t i = 0; i < robot_.contacts.size(); ++i) {
    places_m.segment<3>(3 * static_cast<Index>(i)) = dynamics::point_position_m(
        body_.state(), hopper::touching_point(robot_.contacts[i], body_.state()));
  }
  return places_m;
}

void CassiePosture::stand(const VectorXd& places_m, bool by_heights, VectorXd& position) {
  const auto points = static_cast<Index>(robot_.contacts.size());
  const TouchingPoints all = TouchingPoints::Constant(points, true);
  for (int step = 0; step < 20; ++step) {
    VectorXd off = -this->places_m(position);
    if (!by_heights) off += places_m;
    const hopper::ContactRows contacts = hopper::contact_rows(robot_, body_.state(), all);
    MatrixXd rows = contacts.jacobian.leftCols(kCassieBase);
    if (by_heights) {
      rows = contacts.heights().leftCols(kCassieBase).eval();
      off = Eigen::Map<const VectorXd, 0, Eigen::InnerStride<3>>(off.data() + 2, points).eval();
    }
    VectorXd move = VectorXd::Zero(robot_.tree.velocity_size());
    move.head(kCassieBase) = Eigen::CompleteOrthogonalDecomposition<MatrixXd>(rows).solve(off);
    dynamics::step_position(robot_.tree, VectorXd(position), move, 1.0, position);
    if (move.norm() < 1e-13) return;
  }
}

CassieSprings CassiePosture::bent_by_weight(const VectorXd& motors_rad, VectorXd& position) {
  const TouchingPoints all =
      TouchingPoints::Constant(static_cast<Index>(robot_.contacts.size()), true);
  const VectorXd still = VectorXd::Zero(robot_.tree.velocity_size());
  // What each spring lacks of torque.
  const auto lacking_Nm = [&](const CassieSprings& bent_rad) -> Eigen::Vector4d {
    position.tail(still.size() - kCassieBase) = joints(motors_rad, bent_rad);
    stand({}, true, position);
    set(position, still);
    VectorXd force(still.size());
    body_.inverse_dynamics(still, force);
    const MatrixXd contacts = hopper::contact_rows(robot_, body_.state(), all).jacobian;
    const VectorXd held =
        Eigen::CompleteOrthogonalDecomposition<MatrixXd>(contacts.leftCols(kCassieBase).transpose())
            .solve(force.head(kCassieBase));
    force -= contacts.transpose() * held;
    Eigen::Vector4d lacking;
    for (std::size_t side = 0; side < 2; ++side) {
      lacking[2 * static_cast<Index>(side)] = force[row_of(legs_[side].shin)];
      lacking[2 * static_cast<Index>(side) + 1] = force[row_of(legs_[side].tarsus)];
    }
    return lacking;
  };
  CassieSprings bent = CassieSprings::Zero();
  for (int step = 0; step < 10; ++step) {
    const Eigen::Vector4d here = lacking_Nm(bent);
    Eigen::Matrix4d slopes;
    for (Index i = 0; i < 4; ++i) {
      slopes.col(i) = (lacking_Nm(bent + kBend_rad * CassieSprings::Unit(i)) - here) / kBend_rad;
    }
    const Eigen::Vector4d more = -slopes.fullPivLu().solve(here);
    bent += more;
    if (more.norm() < 1e-12) break;
  }
  (void)lacking_Nm(bent);
  return bent;
}

}  // namespace torquewright::test
