// SPDX-License-Identifier: Apache-2.0
// Candidates on one joint. Oracle: a program apart, OneJoint below, that knows Newton's law of a
// pendulum and Ohm's of a line, sample by sample, and none of the tool's regions or trees.
#include "hopper/candidates/candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hopper/candidates/candidates_spec.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/mechanisms/constant_jacobian.hpp"
#include "tests/actuator/example_actuator.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Verdict;
using Eigen::Index;

constexpr double kMass_kg = 4.0, kReach_m = 0.35, kOwn_kg_m2 = 0.05, kGravity = 9.81;
constexpr double kMountReach_m = 0.5;  // where actuators' mass hangs, if stated

struct Shop {
  const char* name;
  double kt, ohm, volt, ampere, rotor_kg_m2, forward, backward, coulomb_Nm, viscous, mass_kg;
};
constexpr Shop kShops[]{{"light", 0.12, 0.20, 48, 30, 4e-5, 0.92, 0.88, 0.3, 0.02, 0.6},
                        {"heavy", 0.35, 0.30, 60, 40, 9e-4, 0.80, 0.70, 0.9, 0.05, 2.5},
                        {"smooth", 0.20, 0.25, 48, 25, 2e-4, 1.00, 1.00, 0.0, 0.00, 1.2}};
constexpr double kRatios[]{4, 6, 8, 10, 14, 18, 24, 32};
constexpr double kOldRotor_kg_m2 = 3e-3, kOldRatio = 9.0, kOldMass_kg = 1.0;

actuator::Actuator bought(const Shop& shop, double ratio) {
  actuator::Actuator actuator;
  actuator.name = shop.name;
  actuator.motor.torque_constant_Nm_A = shop.kt;
  actuator.motor.resistance_ohm = shop.ohm;
  actuator.motor.rotor_inertia_kg_m2 = shop.rotor_kg_m2;
  actuator.drive = {
      .bus_voltage_V = shop.volt, .peak_current_A = shop.ampere, .continuous_current_A = {}};
  actuator.transmission.ratio = ratio;
  actuator.transmission.forward_efficiency = shop.forward;
  actuator.transmission.backward_efficiency = shop.backward;
  actuator.effects = {actuator::effect("coulomb_friction", {shop.coulomb_Nm}),
                      actuator::effect("viscous_friction", {shop.viscous})};
  actuator.mass_kg = shop.mass_kg;
  return actuator;
}

/// A pendulum about +y, level at 0; positive turns down.
Robot pendulum(bool is_mounted) {
  Robot robot;
  dynamics::Body arm;
  arm.joint.name = "hinge";
  arm.inertia = {kMass_kg, {kReach_m, 0, 0}, kOwn_kg_m2 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies = {dynamics::Body{}, arm};
  Drivetrain drivetrain;
  drivetrain.mechanism = std::make_shared<ConstantJacobian>(direct_drive());
  drivetrain.joints = {1};
  actuator::Actuator old =
      bought({"old", 0.3, 0.2, 100, 100, kOldRotor_kg_m2, 1, 1, 0, 0, 1.0}, kOldRatio);
  old.mass_kg = kOldMass_kg;
  drivetrain.actuators = {old};
  drivetrain.actuator_names = {"hinge"};
  drivetrain.actuator_files = {"old.json"};
  drivetrain.rotors_in_tree = false;
  if (is_mounted) drivetrain.mount = {1, {kMountReach_m, 0, 0}};
  robot.drivetrains = {drivetrain};
  return robot;
}

constexpr double kSwing_rad = 0.6, kPulse_rad_s = 9.0;

Motion swing() {
  Motion motion;
  for (int i = 0; i <= 1200; ++i) motion.times_s.push_back(1e-3 * i);
  motion.positions.resize(1, motion.samples());
  motion.velocities.resize(1, motion.samples());
  motion.accelerations.resize(1, motion.samples());
  for (Index i = 0; i < motion.samples(); ++i) {
    const double phase = kPulse_rad_s * motion.time_s(i) + 0.2;
    motion.positions(0, i) = kSwing_rad * std::sin(phase);
    motion.velocities(0, i) = kSwing_rad * kPulse_rad_s * std::cos(phase);
    motion.accelerations(0, i) = -kSwing_rad * kPulse_rad_s * kPulse_rad_s * std::sin(phase);
  }
  motion.efforts.setZero(1, motion.samples());
  motion.has_effort = {false};
  return motion;
}

/// The oracle.
class OneJoint {
 public:
  OneJoint(const Shop& shop, double ratio, double extra_kg) : shop_(shop), n_(ratio) {
    const double rotor = ratio * ratio * shop.rotor_kg_m2;
    double last_square = 0.0, last_power = 0.0;
    const double step = 1e-3;
    for (int i = 0; i <= 1200; ++i) {
      const double phase = kPulse_rad_s * step * i + 0.2;
      const double q = kSwing_rad * std::sin(phase);
      const double w = kSwing_rad * kPulse_rad_s * std::cos(phase);
      const double a = -kSwing_rad * kPulse_rad_s * kPulse_rad_s * std::sin(phase);
      const double inertia = kOwn_kg_m2 + kMass_kg * kReach_m * kReach_m +
                             extra_kg * kMountReach_m * kMountReach_m + rotor;
      const double lever = kMass_kg * kReach_m + extra_kg * kMountReach_m;
      const double torque = inertia * a - lever * kGravity * std::cos(q);
      peak = std::max(peak, std::abs(torque));
      // Newton's law of the rotor: the motor turns it before the mesh, the mesh bears the rest.
      const double before = before_mesh(torque - rotor * a, w) + rotor * a;
      const double asked = after_mesh(before, w);
      margin = std::min({margin, greatest(w) - asked, asked - least(w)});
      const double current = (before + drag(w)) / (n_ * shop.kt);
      const double square = current * current;
      const double power = shop.ohm * square + shop.kt * current * ratio * w;
      if (i > 0) {
        copper += 0.5 * step * shop.ohm * (square + last_square);
        energy += 0.5 * step * (power + last_power);
      }
      last_square = square;
      last_power = power;
    }
    share = margin / greatest_at_rest();
  }

  double peak = 0.0, margin = std::numeric_limits<double>::infinity();
  double share = 0.0, copper = 0.0, energy = 0.0;

 private:
  double drag(double w) const {
    return w == 0.0 ? 0.0 : std::copysign(shop_.coulomb_Nm + shop_.viscous * std::abs(w), w);
  }
  double before_mesh(double torque, double w) const {
    return torque * w > 0.0 ? torque / shop_.forward : torque * shop_.backward;
  }
  double after_mesh(double torque, double w) const {
    return torque * w > 0.0 ? torque * shop_.forward : torque / shop_.backward;
  }
  double on_load(double current, double w, double friction) const {
    return after_mesh(n_ * shop_.kt * current - friction, w);
  }
  double greatest(double w) const {
    const double free = (shop_.volt - shop_.kt * n_ * w) / shop_.ohm;
    return on_load(std::min(shop_.ampere, free), w, drag(w));
  }
  double least(double w) const {
    const double free = (-shop_.volt - shop_.kt * n_ * w) / shop_.ohm;
    return on_load(std::max(-shop_.ampere, free), w, drag(w));
  }
  /// Held against a load that would drive it back: friction helps.
  double greatest_at_rest() const {
    const double ampere = std::min(shop_.ampere, shop_.volt / shop_.ohm);
    return (n_ * shop_.kt * ampere + shop_.coulomb_Nm) / shop_.backward;
  }

  Shop shop_;
  double n_;
};

CandidateSet candidates() {
  CandidateSet candidates;
  candidates.by_drivetrain.resize(1);
  for (const Shop& shop : kShops) {
    for (const double ratio : kRatios) {
      candidates.by_drivetrain[0].push_back(
          {std::string(shop.name) + std::to_string(static_cast<int>(ratio)), bought(shop, ratio)});
    }
  }
  return candidates;
}

std::vector<CandidateResult> tried(const Robot& robot, Motion motion, const CheckOptions& options,
                                   const CandidateSet& candidates, std::size_t threads) {
  const HopperReport report = check_motion(robot, motion, options);
  return try_candidates(robot, motion, options, report, candidates, threads);
}

/// What the file says of the old motor's torque.
enum class FileTorque { kNone, kWithRotor, kWithoutRotor };

Motion swing_with(FileTorque file) {
  Motion motion = swing();
  if (file == FileTorque::kNone) return motion;
  motion.has_effort = {true};
  const double old = kOldRotor_kg_m2 * kOldRatio * kOldRatio;
  for (Index i = 0; i < motion.samples(); ++i) {
    const double inertia =
        kOwn_kg_m2 + kMass_kg * kReach_m * kReach_m + (file == FileTorque::kWithRotor ? old : 0.0);
    motion.efforts(0, i) = inertia * motion.accelerations(0, i) -
                           kMass_kg * kReach_m * kGravity * std::cos(motion.positions(0, i));
  }
  return motion;
}

void expect_oracles_ranking(const std::vector<CandidateResult>& results, bool is_mounted) {
  ASSERT_EQ(results.size(), 24u);
  int passing = 0;
  for (const CandidateResult& result : results) {
    const Shop& shop = *std::find_if(std::begin(kShops), std::end(kShops), [&](const Shop& one) {
      return result.name.starts_with(one.name);
    });
    const OneJoint truth(shop, result.ratio, is_mounted ? shop.mass_kg - kOldMass_kg : 0.0);
    EXPECT_EQ(result.verdict, truth.margin >= 0.0 ? Verdict::kPass : Verdict::kFail) << result.name;
    // The dynamics agree to round-off of some 100 Nm.
    EXPECT_NEAR(result.peak_torque_Nm, truth.peak, 1e-10) << result.name;
    EXPECT_NEAR(result.margin_share, truth.share, 1e-9) << result.name;
    if (result.verdict != Verdict::kPass) continue;  // what no current yields is counted clipped
    ++passing;
    EXPECT_NEAR(result.copper_loss_J.value(), truth.copper, 1e-9 * truth.copper) << result.name;
    EXPECT_NEAR(result.energy_J.value(), truth.energy, 1e-9 * truth.copper) << result.name;
  }
  EXPECT_GE(passing, 4);   // else nothing was ranked
  EXPECT_LE(passing, 20);  // or refused
  for (std::size_t i = 1; i < results.size(); ++i) {
    const bool after_pass = results[i - 1].verdict == Verdict::kPass;
    if (after_pass != (results[i].verdict == Verdict::kPass)) {
      EXPECT_TRUE(after_pass);
      continue;
    }
    EXPECT_GE(results[i - 1].margin_share, results[i].margin_share);
  }
}

// The file's torques are the old motor's: the dynamics with the candidate's rotor take their place.
TEST(Candidates, HaveTheDemandOfTheirOwnRotorWhateverTheFileHolds) {
  for (const FileTorque file :
       {FileTorque::kNone, FileTorque::kWithRotor, FileTorque::kWithoutRotor}) {
    const auto results = tried(pendulum(false), swing_with(file), {}, candidates(), 1);
    expect_oracles_ranking(results, false);
    EXPECT_EQ(results[0].torques, CandidateTorques::kDynamics);
  }
}

// Asked for, the file's torques count, the old rotor's part exchanged for the new one's.
TEST(Candidates, ExchangeTheRotorInTheFilesTorques) {
  CheckOptions options;
  options.torques = TorqueSource::kFile;
  for (const FileTorque file : {FileTorque::kWithRotor, FileTorque::kWithoutRotor}) {
    for (const bool is_mounted : {false, true}) {
      Robot robot = pendulum(is_mounted);
      const auto results = tried(robot, swing_with(file), options, candidates(), 2);
      expect_oracles_ranking(results, is_mounted);
      EXPECT_EQ(results[0].torques, CandidateTorques::kExchangedFile);
    }
  }
  EXPECT_THROW(tried(pendulum(false), swing_with(FileTorque::kNone), options, candidates(), 1),
               io::SpecError);
}

TEST(Candidates, CarryTheirMassWhereItIsMounted) {
  expect_oracles_ranking(
      tried(pendulum(true), swing_with(FileTorque::kWithRotor), {}, candidates(), 1), true);
}

// What the joint states of the old rotor leaves with it.
TEST(Candidates, TakeTheOldRotorOutOfTheJoint) {
  Robot robot = pendulum(false);
  robot.drivetrains[0].rotors_in_tree = true;
  robot.tree.bodies[1].joint.reflected_inertia = kOldRotor_kg_m2 * kOldRatio * kOldRatio;
  expect_oracles_ranking(tried(robot, swing(), {}, candidates(), 1), false);
}

// A base that floats, nobody says where: only torques are known. Held at 10 rad/s2 with 9 Nm; the
// old rotor takes 2.43 of them or not, the new one 1.6: 8.17 or 10.6 Nm of what it bears.
TEST(Candidates, AreUndecidedWhereWhatTheFileHoldsDecides) {
  Robot robot = pendulum(false);
  robot.tree.base = dynamics::BaseKind::kPlanar;
  Motion motion;
  for (int i = 0; i <= 100; ++i) motion.times_s.push_back(1e-3 * i);
  motion.has_base = false;
  motion.positions.setZero(4, motion.samples());
  motion.velocities.setZero(4, motion.samples());
  motion.accelerations.setZero(4, motion.samples());
  motion.efforts.setConstant(1, motion.samples(), 9.0);
  motion.has_effort = {true};
  motion.accelerations.row(3).setConstant(10.0);
  for (Index i = 0; i < motion.samples(); ++i) {
    const double t = motion.time_s(i);
    motion.positions(3, i) = 5.0 * t * t + 1e-3 * t;
    motion.velocities(3, i) = 10.0 * t + 1e-3;
  }
  const auto verdict_at = [&](double bears_Nm) {
    Shop shop{"plain", 0.2, 0.01, 100, bears_Nm / 0.2 / 40, 1e-4, 1, 1, 0, 0, 1.0};
    CandidateSet one;
    one.by_drivetrain = {{{"plain40", bought(shop, 40)}}};
    return tried(robot, motion, {}, one, 1).at(0).verdict;
  };
  EXPECT_EQ(verdict_at(8.1), Verdict::kFail);
  EXPECT_EQ(verdict_at(8.3), Verdict::kUndecided);
  EXPECT_EQ(verdict_at(10.5), Verdict::kUndecided);
  EXPECT_EQ(verdict_at(10.7), Verdict::kPass);
}

// Oracle: the check itself. On its own candidates the robot's actuator has the figures of its
// drive.
TEST(Candidates, HaveTheChecksFiguresWhereTheyAreTheRobotsOwn) {
  Robot robot = pendulum(false);
  Motion motion = swing();
  const HopperReport report = check_motion(robot, motion, {});
  const actuator::CheckedInterpretation& drive = report.check.drives.at(0).interpretation;
  CandidateSet own;
  own.by_drivetrain = {{{"own", robot.drivetrains[0].actuators[0]}}};
  const CandidateResult result = try_candidates(robot, motion, {}, report, own, 1).at(0);
  EXPECT_EQ(result.peak_torque_Nm, drive.peak_torque_Nm);
  EXPECT_EQ(result.energy_J, drive.energy_drawn_J - drive.energy_returned_J);
  EXPECT_EQ(result.speed_margin_rad_s, drive.speed_margin_rad_s);
}

// A drive by its curve draws nobody knows what: no energy of 0 that no winding could beat, and it
// does not push the others off the front.
TEST(Candidates, KnownByTheirCurveHaveNoEnergy) {
  const Robot robot = pendulum(false);
  Motion motion = swing();
  const HopperReport report = check_motion(robot, motion, {});
  actuator::Actuator curve = robot.drivetrains[0].actuators[0];
  actuator::Envelope envelope;
  envelope.ratio = curve.transmission.ratio;
  envelope.peak.greatest = {{-1000.0, 500.0}, {1000.0, 500.0}};
  envelope.peak.least = {{-1000.0, -500.0}, {1000.0, -500.0}};
  curve.envelope = envelope;
  curve.battery.reset();
  CandidateSet two;
  two.by_drivetrain = {{{"curve", curve}, {"own", robot.drivetrains[0].actuators[0]}}};
  const auto results = try_candidates(robot, motion, {}, report, two, 1);
  ASSERT_EQ(results.size(), 2u);
  for (const CandidateResult& each : results) {
    EXPECT_EQ(each.energy_J.has_value(), each.name == "own") << each.name;
    EXPECT_EQ(each.copper_loss_J.has_value(), each.name == "own") << each.name;
    EXPECT_EQ(candidate_of(candidate_text(each)).energy_J, each.energy_J);
  }
  EXPECT_TRUE(results[0].is_on_front);
}

// The shelf of `actuator find`. Oracle: the documents of specs/catalogue, read as a folder.
TEST(Candidates, OfTheCatalogueAreItsDocuments) {
  const std::string specs = TORQUEWRIGHT_SOURCE_DIR "/specs/";
  const ReadRobot robot = read_robot(specs + "robot/hopper.json");
  const CandidateSet shelf = catalogue_candidates(robot, std::nullopt);
  const CandidateSet folder = read_candidate_set(specs + "catalogue", robot, std::nullopt);
  ASSERT_EQ(shelf.by_drivetrain.size(), folder.by_drivetrain.size());
  for (std::size_t i = 0; i < shelf.by_drivetrain.size(); ++i) {
    ASSERT_EQ(shelf.by_drivetrain[i].size(), folder.by_drivetrain[i].size());
    for (std::size_t k = 0; k < shelf.by_drivetrain[i].size(); ++k) {
      EXPECT_EQ(shelf.by_drivetrain[i][k].name, folder.by_drivetrain[i][k].name);
    }
  }
  EXPECT_GE(shelf.by_drivetrain[0].size(), 60u);
  const CandidateSet geared = catalogue_candidates(robot, read_ratio_sweep("8:9"));
  EXPECT_EQ(geared.by_drivetrain[0].size(), 2 * shelf.by_drivetrain[0].size());
}

/// Accelerations of a speed V cos(w t), fitted over `reach` samples of length h on either side:
/// the parabola's slope is a share sum(2 k sin(k w h)) / (2 w h sum(k^2)) of the true one.
double share_of_slope(int reach, double angle_rad) {
  double slope = 0.0;
  double squares = 0.0;
  for (int k = 1; k <= reach; ++k) {
    slope += 2.0 * k * std::sin(k * angle_rad);
    squares += 2.0 * k * k;
  }
  return slope / (squares * angle_rad);
}

// Without weight, and accelerations derived from speeds: over windows twice as wide they differ by
// a known share. The doubt is of the candidate's rotor too, which is three times the arm.
TEST(Candidates, AreUndecidedWhereTheDoubtOfDerivedAccelerationsDecides) {
  constexpr double kStep_s = 0.01, kRotor = 1e-3, kRatio = 40.0;
  Robot robot = pendulum(false);
  robot.tree.gravity_m_s2 = 0.0;
  Motion motion;
  for (int i = 0; i <= 140; ++i) motion.times_s.push_back(kStep_s * i);
  motion.positions.resize(1, motion.samples());
  motion.velocities.resize(1, motion.samples());
  double greatest_rad_s2 = 0.0;
  for (Index i = 0; i < motion.samples(); ++i) {
    const double phase = kPulse_rad_s * motion.time_s(i);
    motion.positions(0, i) = kSwing_rad * std::sin(phase);
    motion.velocities(0, i) = kSwing_rad * kPulse_rad_s * std::cos(phase);
    greatest_rad_s2 = std::max(
        greatest_rad_s2, std::abs(kSwing_rad * kPulse_rad_s * kPulse_rad_s * std::sin(phase)));
  }
  motion.acceleration_origin = Origin::kDerived;
  motion.efforts.setZero(1, motion.samples());
  motion.has_effort = {false};
  const double inertia = kOwn_kg_m2 + kMass_kg * kReach_m * kReach_m + kRatio * kRatio * kRotor;
  const double narrow = share_of_slope(1, kPulse_rad_s * kStep_s);
  const double doubt = narrow - share_of_slope(2, kPulse_rad_s * kStep_s);
  const auto verdict_at = [&](double share) {
    const double bears_Nm = inertia * greatest_rad_s2 * share;
    Shop shop{"plain", 0.2, 0.001, 400, bears_Nm / 0.2 / kRatio, kRotor, 1, 1, 0, 0, 1.0};
    CandidateSet one;
    one.by_drivetrain = {{{"plain", bought(shop, kRatio)}}};
    return tried(robot, motion, {}, one, 1).at(0).verdict;
  };
  constexpr double kBeside = 1e-4;  // of some 3e-3 of doubt
  EXPECT_EQ(verdict_at(narrow - doubt - kBeside), Verdict::kFail);
  EXPECT_EQ(verdict_at(narrow - doubt + kBeside), Verdict::kUndecided);
  EXPECT_EQ(verdict_at(narrow + doubt - kBeside), Verdict::kUndecided);
  EXPECT_EQ(verdict_at(narrow + doubt + kBeside), Verdict::kPass);
}

}  // namespace
}  // namespace torquewright::hopper
