// SPDX-License-Identifier: Apache-2.0
// Oracle: inverse kinematics by trying angles. A crank is turned about its axis in small steps
// until the distance of both pins is the rod's length; limits are then those of the rod and the
// crank as they stand, levers by differences and their least by a singular value.
#include "robot/model/workspace.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "robot/mechanisms/parallel_ankle.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr int kSteps = 16;
constexpr int kTried = 720;          // of a turn of a crank
constexpr double kAtTheEdge = 1e-6;  // rad or m: too near a limit to tell by differences

struct Ankle {
  Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;

  Drivetrain& drivetrain() {
    return *std::find_if(robot.drivetrains.begin(), robot.drivetrains.end(),
                         [](const Drivetrain& one) { return one.joints.size() == 2; });
  }
  ParallelAnkleGeometry geometry() {
    return dynamic_cast<const ParallelAnkle&>(*drivetrain().mechanism).geometry();
  }
  void become(const ParallelAnkleGeometry& geometry) {
    drivetrain().mechanism = std::make_shared<ParallelAnkle>(geometry);
  }
};

/// Of the hopper: pitch about y, then roll about x, both through the ankle.
Eigen::Matrix3d foot_to_calf(double pitch_rad, double roll_rad) {
  return (AngleAxisd(pitch_rad, Vector3d::UnitY()) * AngleAxisd(roll_rad, Vector3d::UnitX()))
      .toRotationMatrix();
}

class TriedAnkle {
 public:
  explicit TriedAnkle(const ParallelAnkleGeometry& geometry) : geometry_(geometry) {}

  /// The least room of all limits; negative outside; nothing where a rod does not reach.
  std::optional<double> room(double pitch_rad, double roll_rad) const {
    double least = 1.0;
    Eigen::Matrix2d levers;
    for (int i = 0; i < 2; ++i) {
      const AnkleRod& rod = geometry_.rods[static_cast<std::size_t>(i)];
      const auto crank_rad = found_rad(rod, pin_m(rod, pitch_rad, roll_rad));
      if (!crank_rad) return std::nullopt;
      const Vector3d crank = AngleAxisd(*crank_rad, rod.actuator_axis) * rod.crank_m;
      const Vector3d along =
          (pin_m(rod, pitch_rad, roll_rad) - rod.actuator_center_m - crank) / rod.rod_length_m;
      const double in_line = std::abs(along.dot(rod.actuator_axis.cross(crank).normalized()));
      least = std::min(least, std::asin(in_line) - geometry_.transmission_limit_rad);
      const Vector3d foot_pin = foot_to_calf(pitch_rad, roll_rad) * rod.foot_pin_axis;
      for (const Vector3d& pin : {rod.actuator_axis, foot_pin}) {
        least = std::min(least, geometry_.rod_tilt_limit_rad - std::asin(std::abs(along.dot(pin))));
      }
      constexpr double kSmall_rad = 1e-6;
      levers(i, 0) = along.dot(pin_m(rod, pitch_rad + kSmall_rad, roll_rad) -
                               pin_m(rod, pitch_rad - kSmall_rad, roll_rad)) /
                     (2 * kSmall_rad);
      levers(i, 1) = along.dot(pin_m(rod, pitch_rad, roll_rad + kSmall_rad) -
                               pin_m(rod, pitch_rad, roll_rad - kSmall_rad)) /
                     (2 * kSmall_rad);
    }
    const double lever_m = Eigen::JacobiSVD<Eigen::Matrix2d>(levers).singularValues()[1];
    return std::min(least, lever_m - geometry_.lever_limit_m);
  }

 private:
  Vector3d pin_m(const AnkleRod& rod, double pitch_rad, double roll_rad) const {
    return geometry_.first.p_PB_m + foot_to_calf(pitch_rad, roll_rad) * rod.foot_attachment_m;
  }

  /// Where the rod fits, the nearest to the crank's zero, of which the hopper's cranks stay within
  /// a quarter turn.
  static std::optional<double> found_rad(const AnkleRod& rod, const Vector3d& pin_m) {
    const auto gap_m = [&](double crank_rad) {
      const Vector3d crank = AngleAxisd(crank_rad, rod.actuator_axis) * rod.crank_m;
      return (pin_m - rod.actuator_center_m - crank).norm() - rod.rod_length_m;
    };
    std::optional<double> nearest;
    const double step_rad = 2 * std::numbers::pi / kTried;
    for (int i = -kTried / 2; i < kTried / 2; ++i) {
      double low = i * step_rad, high = low + step_rad;
      if ((gap_m(low) < 0) == (gap_m(high) < 0)) continue;
      const bool rises = gap_m(low) < 0;
      for (int halved = 0; halved < 45; ++halved) {
        const double middle = 0.5 * (low + high);
        ((gap_m(middle) < 0) == rises ? low : high) = middle;
      }
      if (!nearest || std::abs(low) < std::abs(*nearest)) nearest = low;
    }
    return nearest;
  }

  ParallelAnkleGeometry geometry_;
};

struct Compared {
  int inside = 0, outside = 0, unreached = 0;
};

Compared compared(Ankle& ankle) {
  const TriedAnkle tried(ankle.geometry());
  const Workspace workspace = workspace_of(ankle.robot, ankle.drivetrain(), kSteps);
  Compared count;
  for (const WorkspacePlace& place : workspace.places) {
    const auto room = tried.room(place.joint_rad[0], place.joint_rad[1]);
    if (room && std::abs(*room) < kAtTheEdge) continue;
    const bool is_inside = room && *room > 0;
    EXPECT_EQ(place.is_inside(), is_inside)
        << place.joint_rad[0] << " " << place.joint_rad[1] << " " << place.crossed;
    ++(is_inside ? count.inside : room ? count.outside : count.unreached);
  }
  return count;
}

TEST(Workspace, OfTheHoppersAnkleIsWhereItsRodsFit) {
  Ankle ankle;
  const Compared count = compared(ankle);
  EXPECT_GT(count.inside, 200);
  EXPECT_GT(count.outside, 100);  // beyond the joints' ranges
}

// Narrower limits and shorter rods cut into the ranges themselves.
TEST(Workspace, OfANarrowerAnkleLosesPartOfItsRanges) {
  Ankle ankle;
  ParallelAnkleGeometry geometry = ankle.geometry();
  geometry.rod_tilt_limit_rad = 0.25;
  geometry.rods[0].crank_m *= 0.6;
  geometry.rods[0].actuator_center_m.x() -= 0.024;  // the same pin at zero
  ankle.become(geometry);
  const Compared count = compared(ankle);
  EXPECT_GT(count.inside, 50);
  EXPECT_GT(count.outside, 100);
  EXPECT_GT(count.unreached, 20);
  const Workspace workspace = workspace_of(ankle.robot, ankle.drivetrain(), kSteps);
  std::size_t kept_out = 0;
  for (const auto& [word, number] : workspace.kept_out()) kept_out += number;
  EXPECT_GT(kept_out, 10U);
  EXPECT_LT(kept_out, workspace.in_range());
}

// The seed's ranges, -50 to 40 and -30 to 30 degrees, stand whole; the grid holds their ends.
TEST(Workspace, HoldsTheRangesOfTheSeed) {
  Ankle ankle;
  const Workspace workspace = workspace_of(ankle.robot, ankle.drivetrain(), kSteps);
  EXPECT_EQ(workspace.in_range(), static_cast<std::size_t>((kSteps + 1) * (kSteps + 1)));
  EXPECT_TRUE(workspace.kept_out().empty());
  const auto [from_rad, to_rad] = workspace.own_range_rad(0);
  EXPECT_LE(from_rad, -50 * std::numbers::pi / 180 + 1e-9);
  EXPECT_GE(to_rad, 40 * std::numbers::pi / 180 - 1e-9);
  // Along a row the end is where the tried ankle still stands and its neighbour does not.
  const TriedAnkle tried(ankle.geometry());
  const double step_rad = (90.0 / kSteps) * std::numbers::pi / 180;
  const double held_rad = 0.0;
  EXPECT_GT(*tried.room(to_rad, held_rad), 0);
  const auto further = tried.room(to_rad + step_rad, held_rad);
  const bool is_end_of_grid = to_rad > (40 + 45 - 1) * std::numbers::pi / 180;
  EXPECT_TRUE(is_end_of_grid || !further || *further < 0);
}

}  // namespace
}  // namespace torquewright::hopper
