// SPDX-License-Identifier: Apache-2.0
// Oracles: central differences; closed forms of integrals, falls and of the documented motor at
// constant speed; dynamics::centroid() of the planned states; and plans, of which each must have
// more of what it was planned for than the plan of least effort.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dynamics/momentum.hpp"
#include "hopper/planning/objectives/library.hpp"
#include "hopper/planning/programme/flip_program.hpp"
#include "hopper/planning/programme/guess.hpp"
#include "hopper/planning/programme/plan_setup.hpp"
#include "hopper/planning/programme/smoothness.hpp"
#include "hopper/planning/programme/solved_motion.hpp"
#include "io/faults/spec_error.hpp"
#include "optimization/nonlinear/solve.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/dynamics/random_numbers.hpp"

namespace torquewright::hopper {
namespace {

using optimization::Rows;
using test::uniform;
using Values = std::vector<double>;

// Closed forms against sums of some hundred terms: rounding.
constexpr double kExact = 1e-12;

const Robot& the_hopper() {
  static const Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  return robot;
}

/// Of a phase: even in its outer parts, not inside.
std::vector<double> uneven_knots(int intervals) {
  std::vector<double> knots;
  for (int i = 0; i <= intervals; ++i) {
    const double s = static_cast<double>(i) / intervals;
    knots.push_back(s + 0.1 * std::sin(2.0 * std::numbers::pi * s) / std::numbers::pi);
  }
  return knots;
}

class Flip {
 public:
  explicit Flip(const std::vector<std::string>& stances = std::vector<std::string>{"flat", "heel",
                                                                                   "flight", "heel",
                                                                                   "flat"})
      : model(plan_model(the_hopper(), options)) {
    std::vector<MeshPhase> mesh;
    for (const Stance& stance : stances_of(model.plane, stances)) {
      mesh.push_back({stance, uneven_knots(4), {0.4, 0.4}});
    }
    const PlanGoal goal = plan_goal(model, options);
    program = flip_program(model, mesh, goal, options, key_frame_guess(model, mesh, goal, options));
    values = program.program.starts();
  }

  /// At rest without torque, in the guess's postures; the bus at its open voltage.
  void rest() {
    for (const PhaseVariables& phase : program.phases) {
      for (const PointVariables& point : phase.points) {
        for (int i = 0; i < 5; ++i) at(point.velocity + i) = at(point.acceleration + i) = 0.0;
        for (int i = 0; i < 3; ++i) at(point.drives + i) = 0.0;
      }
      for (int i = 0; phase.has_impact && i < 5; ++i) at(phase.velocity_before + i) = 0.0;
    }
  }

  /// Postures of the guess, everything else anywhere.
  void draw(oracles::Dice& dice) {
    for (const PhaseVariables& phase : program.phases) {
      at(phase.duration) = uniform(dice, 0.1, 1.0);
      for (const PointVariables& point : phase.points) {
        for (int i = 0; i < 5; ++i) at(point.velocity + i) = uniform(dice, -8, 8);
        for (int i = 0; i < 5; ++i) at(point.acceleration + i) = uniform(dice, -200, 200);
        for (int i = 0; i < 3; ++i) at(point.drives + i) = uniform(dice, -150, 150);
        at(point.position + 2) = uniform(dice, -3, 3);
        at(point.position + 3) = uniform(dice, 0.1, 2.2);
        at(point.position + 4) = uniform(dice, -0.6, 0.6);
        at(point.bus) = uniform(dice, 50, 70);
      }
      for (int i = 0; phase.has_impact && i < 5; ++i) {
        at(phase.velocity_before + i) = uniform(dice, -8, 8);
      }
    }
  }

  double& at(int variable) { return values[static_cast<std::size_t>(variable)]; }
  double value(const char* name) const {
    return objective_named(name).value(model, options, program, values);
  }
  PointVariables& take_off() { return program.phases[2].points.front(); }

  /// Shares of a phase's duration at its instants.
  static double share(const MeshPhase& mesh, std::size_t point) {
    const double low = mesh.knots[point / 2];
    return point % 2 == 0 ? low : 0.5 * (low + mesh.knots[point / 2 + 1]);
  }

  PlanOptions options;
  PlanModel model;
  FlipProgram program;
  Values values;
};

/// What adding an objective put into a program: costs and rows that were not there before.
struct Added {
  std::vector<const Rows*> costs;
  std::vector<const Rows*> rows;
};

template <typename Add>
Added added_by(Flip& flip, const Add& add) {
  const std::size_t costs = flip.program.program.costs().size();
  const std::size_t rows = flip.program.program.rows().size();
  add();
  const auto& starts = flip.program.program.starts();
  flip.values.insert(flip.values.end(),
                     starts.begin() + static_cast<std::ptrdiff_t>(flip.values.size()),
                     starts.end());
  Added out;
  for (std::size_t i = costs; i < flip.program.program.costs().size(); ++i) {
    out.costs.push_back(flip.program.program.costs()[i].get());
  }
  for (std::size_t i = rows; i < flip.program.program.rows().size(); ++i) {
    out.rows.push_back(flip.program.program.rows()[i].get());
  }
  return out;
}

Added added(Flip& flip, const Objective& objective, double weight = 1.0) {
  return added_by(flip, [&] { objective.add(flip.model, flip.options, weight, flip.program); });
}

Added added_smoothness(Flip& flip) {
  return added_by(flip, [&] { add_smoothness(flip.model, flip.program); });
}

Eigen::VectorXd values_of(const Rows& rows, const Eigen::VectorXd& x) {
  Eigen::VectorXd out(rows.size());
  rows.values(x, out);
  return out;
}

double sum(const std::vector<const Rows*>& costs, const Values& values) {
  double out = 0.0;
  for (const Rows* cost : costs) {
    out += values_of(*cost, optimization::gathered(*cost, values))[0];
  }
  return out;
}

/// Slopes against differences of values, curvatures against differences of slopes. A step of
/// eps^(1/3) leaves eps^(2/3) = 4e-11 of the largest term, times some hundred of their growth.
void expect_derivatives(const Rows& rows, const Eigen::VectorXd& x) {
  constexpr double kTolerance = 1e-7;
  const Eigen::Index n = rows.width();
  Eigen::MatrixXd slopes(rows.size(), n), differences(rows.size(), n);
  rows.slopes(x, slopes);
  Eigen::VectorXd multipliers(rows.size());
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    multipliers[i] = 1.0 + 0.3 * static_cast<double>(i);
  }
  Eigen::MatrixXd curvatures(n, n), second(n, n);
  rows.curvatures(x, multipliers, curvatures);
  double largest = values_of(rows, x).cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < n; ++i) {
    const double step = 6e-6 * std::max(1.0, std::abs(x[i]));
    Eigen::VectorXd less = x, more = x;
    less[i] -= step;
    more[i] += step;
    differences.col(i) = (values_of(rows, more) - values_of(rows, less)) / (more[i] - less[i]);
    Eigen::MatrixXd low(rows.size(), n), high(rows.size(), n);
    rows.slopes(less, low);
    rows.slopes(more, high);
    second.col(i) = (high - low).transpose() * multipliers / (more[i] - less[i]);
  }
  largest = std::max({largest, slopes.cwiseAbs().maxCoeff(), curvatures.cwiseAbs().maxCoeff()});
  EXPECT_LE((slopes - differences).cwiseAbs().maxCoeff(), kTolerance * largest) << rows.name();
  EXPECT_LE((curvatures - second).cwiseAbs().maxCoeff(), kTolerance * largest) << rows.name();
  EXPECT_GT(slopes.cwiseAbs().maxCoeff(), 0.0) << rows.name();
}

TEST(FlipObjectives, DerivativesAreThoseOfTheValues) {
  oracles::Dice dice(19);
  for (const Objective& objective : every_objective()) {
    SCOPED_TRACE(objective.name);
    Flip flip;
    const Added parts = added(flip, objective, 0.7);
    flip.draw(dice);
    ASSERT_FALSE(parts.costs.empty());
    for (const auto& list : {parts.costs, parts.rows}) {
      for (const Rows* rows : list) {
        expect_derivatives(*rows, optimization::gathered(*rows, flip.values));
      }
    }
  }
}

TEST(FlipSmoothness, DerivativesAreThoseOfTheValues) {
  oracles::Dice dice(20);
  Flip flip;
  const Added parts = added_smoothness(flip);
  flip.draw(dice);
  for (const Rows* rows : parts.costs) {
    expect_derivatives(*rows, optimization::gathered(*rows, flip.values));
  }
}

/// A cost is the value times a number of one sign, whatever the motion: what is minimised is what
/// is reported. Those with a bound for an unknown have it in OfTheLeastIsTheValue below.
TEST(FlipObjectives, CostsAreProportionalToValuesAndWeights) {
  oracles::Dice dice(21);
  for (const Objective& objective : every_objective()) {
    if (objective.name == "gear_load" || objective.name == "region_margin") continue;
    SCOPED_TRACE(objective.name);
    Flip flip;
    const Added once = added(flip, objective, 1.0);
    const Added thrice = added(flip, objective, 3.0);
    flip.draw(dice);
    flip.at(flip.take_off().velocity + 1) = 2.0;  // upwards, where height is exact
    const double cost = sum(once.costs, flip.values);
    const double value = objective.value(flip.model, flip.options, flip.program, flip.values);
    EXPECT_NEAR(sum(thrice.costs, flip.values), 3.0 * cost, kExact * std::abs(cost));
    flip.draw(dice);
    flip.at(flip.take_off().velocity + 1) = 3.0;
    const double other = objective.value(flip.model, flip.options, flip.program, flip.values);
    EXPECT_NEAR(sum(once.costs, flip.values) / cost, other / value,
                1e-10 * (1.0 + std::abs(other / value)));
    const bool is_least = std::string_view(objective.sentence).starts_with("least");
    EXPECT_EQ(cost * value > 0.0, is_least);
  }
}

/// The bound that is an unknown can be at the value and no further.
TEST(FlipObjectives, TheBoundOfTheLeastIsTheValue) {
  oracles::Dice dice(22);
  Flip flip;
  const Added parts = added(flip, objective_named("region_margin"));
  flip.draw(dice);
  const double value = flip.value("region_margin");
  double least = 1e9;
  flip.values.back() = value;
  for (const Rows* rows : parts.rows) {
    const auto x = optimization::gathered(*rows, flip.values);
    least = std::min(least, values_of(*rows, x).minCoeff());
  }
  EXPECT_NEAR(least, 0.0, kExact);
  EXPECT_LT(sum(parts.costs, flip.values) * value, 0.0);
}

TEST(FlipObjectives, EffortOfTorquesThatRiseEvenlyIsAThird) {
  Flip flip;
  flip.rest();
  double expected_s = 0.0;
  for (std::size_t p = 0; p < flip.program.phases.size(); ++p) {
    const PhaseVariables& phase = flip.program.phases[p];
    const double duration_s = 0.1 * static_cast<double>(p + 1);
    flip.at(phase.duration) = duration_s;
    expected_s += duration_s * (1.0 / 3.0 + 0.25);
    for (std::size_t i = 0; i < phase.points.size(); ++i) {
      const auto most = [&](std::size_t drive) {
        return (*flip.model.regions)[drive].greatest_torque_Nm();
      };
      flip.at(phase.points[i].drives) = Flip::share(flip.program.mesh[p], i) * most(0);
      flip.at(phase.points[i].drives + 2) = -0.5 * most(2);
    }
  }
  EXPECT_NEAR(flip.value("effort"), expected_s, kExact);
}

/// The knee's mechanism is a parallelogram, its drive turns as the joint does. Documented: 20:1,
/// 0.32 Nm/A and 0.28 ohm of one equivalent winding, so power = torque speed + R (torque/6.4)^2.
TEST(FlipObjectives, EnergyIsTheMotorsWorkAndItsCopper) {
  for (const double torque_Nm : {50.0, -50.0}) {
    Flip flip;
    flip.rest();
    const PhaseVariables& phase = flip.program.phases[2];
    flip.at(phase.duration) = 0.3;
    for (std::size_t i = 0; i < phase.points.size(); ++i) {
      const double s = Flip::share(flip.program.mesh[2], i);
      flip.at(phase.points[i].velocity + 3) = 4.0 * (1.0 + s);
      flip.at(phase.points[i].drives) = torque_Nm * s;
    }
    const double work_J = 0.3 * torque_Nm * 4.0 * (1.0 / 2.0 + 1.0 / 3.0);
    const double copper_J = 0.3 * 0.28 * torque_Nm * torque_Nm / (6.4 * 6.4) / 3.0;
    EXPECT_NEAR(flip.value("energy"), work_J + copper_J, 1e-9 * std::abs(work_J));
  }
}

/// A fall in steps of 0.1 ms: the highest is missed by at most g (0.1 ms)^2/8.
TEST(FlipObjectives, HeightIsThatOfTheFall) {
  for (const double rise_m_s : {2.5, 0.0, -1.0}) {
    Flip flip;
    flip.at(flip.take_off().position + 1) = 0.6;
    flip.at(flip.take_off().velocity + 1) = rise_m_s;
    const double g = flip.model.plane.robot.tree.gravity_m_s2;
    double highest_m = 0.0;
    for (int i = 0; i < 10000; ++i) {
      const double t = 1e-4 * i;
      highest_m = std::max(highest_m, 0.6 + rise_m_s * t - 0.5 * g * t * t);
    }
    EXPECT_NEAR(flip.value("height"), highest_m, g * 1e-8 / 8.0 + 1e-15);
  }
}

TEST(FlipObjectives, HeightKeepsTheTakeOffUpwards) {
  Flip flip;
  const Added parts = added(flip, objective_named("height"));
  ASSERT_EQ(parts.rows.size(), 1u);
  EXPECT_EQ(parts.rows[0]->variables(), std::vector<int>{flip.take_off().velocity + 1});
  EXPECT_EQ(parts.rows[0]->bounds()[0].lower, 0.0);
}

TEST(FlipObjectives, TimeIsThatOfAllPhases) {
  Flip flip;
  for (std::size_t p = 0; p < 5; ++p) {
    flip.at(flip.program.phases[p].duration) = std::pow(2.0, -static_cast<double>(p));
  }
  EXPECT_EQ(flip.value("time"), 1.0 + 0.5 + 0.25 + 0.125 + 0.0625);
}

TEST(FlipObjectives, MomentaAreThoseOfTheTakeOffState) {
  oracles::Dice dice(23);
  for (int draw = 0; draw < 5; ++draw) {
    Flip flip;
    flip.draw(dice);
    const PlannedInstant at =
        motion_of(flip.program, flip.model, flip.values).phases[2].instants.front();
    const TreeMotion tree = tree_motion(flip.model.plane, PlanFrame::kMass,
                                        {at.position, at.velocity, at.acceleration});
    dynamics::TreeState state(flip.model.plane.robot.tree);
    state.set(tree.position, tree.velocity);
    const dynamics::Centroid whole = dynamics::centroid(state);
    EXPECT_NEAR(flip.value("cam"), whole.angular_momentum_Nm_s.y(), 1e-11);
    EXPECT_NEAR(flip.value("cav"), whole.angular_velocity_rad_s.y(), 1e-10);
    EXPECT_EQ(flip.value("bav"), tree.velocity[2]);
  }
}

/// A knee that turned at 3 rad/s stops: its rotor, 20^2 of 922 kg mm^2, gives 1.106 Nm s to the
/// gears, over 10 ms 110.6 Nm; the torque that follows counts beside it with its size, whatever its
/// sign.
TEST(FlipObjectives, GearLoadIsTheRotorsImpulseAndWhatFollows) {
  constexpr double kRotor_kg_m2 = 400.0 * 0.000922;
  for (const double torque_Nm : {40.0, -40.0}) {
    Flip flip;
    flip.rest();
    const PhaseVariables& landing = flip.program.phases[3];
    flip.at(landing.velocity_before + 3) = 3.0;
    const PointVariables& middle = landing.points[1];
    flip.at(middle.drives) = torque_Nm;
    flip.at(middle.acceleration + 3) = -20.0;
    const double expected_Nm = kRotor_kg_m2 * 3.0 / flip.options.check.load_window_s +
                               std::abs(torque_Nm + kRotor_kg_m2 * 20.0);
    // Before the gears, which lose nothing in the document.
    EXPECT_NEAR(flip.value("gear_load"), expected_Nm / 20.0, 1e-10);
    // The first interval of 0.14 s holds the window; what is after it is no landing.
    flip.at(landing.points[3].drives) = 1000.0;
    EXPECT_NEAR(flip.value("gear_load"), expected_Nm / 20.0, 1e-10);
    flip.at(flip.program.phases[2].points.back().drives) = 1000.0;
    EXPECT_NEAR(flip.value("gear_load"), expected_Nm / 20.0, 1e-10);
    flip.at(flip.program.phases[4].points.front().drives) = 300.0;  // the other landing's
    EXPECT_NEAR(flip.value("gear_load"), 300.0 / 20.0, 1e-10);
  }
}

/// By the ankle's limit, 17 Nm at the motor; two drives of 8:1.
TEST(FlipObjectives, GearLoadIsOfTheDriveNearestItsLimit) {
  Flip flip;
  flip.rest();
  const PointVariables& begin = flip.program.phases[3].points.front();
  flip.at(begin.drives) = 130.0;      // of the knee's 287
  flip.at(begin.drives + 1) = 100.0;  // of 122
  EXPECT_NEAR(flip.value("gear_load"), 100.0 / 8.0, 1e-12);
  flip.at(begin.drives) = -260.0;
  EXPECT_NEAR(flip.value("gear_load"), 260.0 / 20.0, 1e-12);
}

/// Rows hold with the rotors' parts at their magnitudes and the greatest at the value, not below.
TEST(FlipObjectives, TheBoundOfTheGreatestGearLoadIsTheValue) {
  Flip flip;
  const Added parts = added(flip, objective_named("gear_load"));
  flip.rest();
  const PhaseVariables& landing = flip.program.phases[3];
  flip.at(landing.velocity_before + 3) = -3.0;
  flip.at(landing.points[2].drives) = -70.0;
  const double limit_Nm = flip.model.gear_Nm[0];
  const double impulse_Nm = 400.0 * 0.000922 * 3.0 / flip.options.check.load_window_s;
  // Added in this order: the greatest, the rotors' of the heel's landing, those of the toe's.
  const std::size_t first = flip.values.size() - 7;
  std::fill(flip.values.end() - 7, flip.values.end(), 0.0);
  flip.values[first] = (impulse_Nm + 70.0) / limit_Nm;
  flip.values[first + 1] = impulse_Nm / limit_Nm;
  EXPECT_NEAR(flip.value("gear_load"), flip.values[first] * limit_Nm / 20.0, 1e-10);
  const auto worst = [&] {
    double most = -1e9;
    for (const Rows* rows : parts.rows) {
      const auto x = optimization::gathered(*rows, flip.values);
      most = std::max(most, values_of(*rows, x).maxCoeff());
    }
    return most;
  };
  EXPECT_NEAR(worst(), 0.0, kExact);
  flip.values[first] -= 1e-6;
  EXPECT_NEAR(worst(), 1e-6, kExact);
  flip.values[first] += 1e-6;
  flip.values[first + 1] -= 1e-6;
  EXPECT_NEAR(worst(), 1e-6, kExact);
}

/// At rest the torque alone counts; at speed the voltage: 6.4/0.28 (V - 6.4 w) of the documented
/// motor, V less the margin.
TEST(FlipObjectives, RegionMarginIsTheLeastDistance) {
  Flip flip;
  flip.rest();
  const double most_Nm = (*flip.model.regions)[0].greatest_torque_Nm();
  const PointVariables& at = flip.program.phases[1].points[3];
  flip.at(at.drives) = -0.7 * most_Nm;
  EXPECT_NEAR(flip.value("region_margin"), 0.3, kExact);
  flip.at(at.drives) = 20.0;
  flip.at(at.velocity + 3) = 8.0;
  flip.at(at.bus) = 60.0;
  const double bound_Nm = 6.4 / 0.28 * (60.0 * (1.0 - flip.options.margins.voltage) - 6.4 * 8.0);
  EXPECT_NEAR(flip.value("region_margin"), (bound_Nm - 20.0) / most_Nm, 1e-9);
}

TEST(FlipSmoothness, IsTheIntegralOfSquaredRatesAndAccelerations) {
  Flip flip;
  const Added parts = added_smoothness(flip);
  flip.rest();
  const PhaseVariables& phase = flip.program.phases[1];
  flip.at(phase.duration) = 0.2;
  const double most_Nm = (*flip.model.regions)[1].greatest_torque_Nm();
  for (std::size_t i = 0; i < phase.points.size(); ++i) {
    flip.at(phase.points[i].drives + 1) = Flip::share(flip.program.mesh[1], i) * most_Nm;
    flip.at(phase.points[i].acceleration + 4) = 100.0;
    flip.at(phase.points[i].acceleration) = 55.0;  // of the frame: free
  }
  EXPECT_NEAR(sum(parts.costs, flip.values), 1e-5 / 0.2 + 1e-3 * 0.2, kExact);
  // A middle off by half the greatest: rates either way over half an interval, and the bend.
  flip.rest();
  flip.at(phase.points[3].drives + 1) = 0.5 * most_Nm;
  const double interval_s = 0.2 * (flip.program.mesh[1].knots[2] - flip.program.mesh[1].knots[1]);
  EXPECT_NEAR(sum(parts.costs, flip.values), 1e-5 / interval_s + 1e-3, kExact);
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string refusal_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const io::SpecError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FlipObjectives, AreFoundByName) {
  const std::vector<std::string> names = objective_names();
  EXPECT_EQ(names, (std::vector<std::string>{"effort", "energy", "gear_load", "region_margin",
                                             "height", "time", "cam", "cav", "bav"}));
  for (const std::string& name : names) {
    EXPECT_EQ(objective_named(name).name, name);
    EXPECT_FALSE(objective_named(name).sentence.empty());
  }
  const std::string near = refusal_of([] { objective_named("energie"); });
  EXPECT_TRUE(says(near, "--objective"));
  EXPECT_TRUE(says(near, "\"energie\"; did you mean \"energy\"?"));
  for (const std::string& name : names) EXPECT_TRUE(says(near, name));
  const std::string far = refusal_of([] { objective_named("beauty"); });
  EXPECT_TRUE(says(far, "\"beauty\"; there are effort, energy"));
}

TEST(FlipObjectives, WithoutNamesItIsEffort) {
  PlanOptions options;
  ASSERT_EQ(objectives_of(options).size(), 1u);
  EXPECT_EQ(objectives_of(options)[0].name, "effort");
  EXPECT_EQ(objectives_of(options)[0].weight, 1.0);
  options.objectives = {{"cav", 2.0}, {"time", 0.5}};
  ASSERT_EQ(objectives_of(options).size(), 2u);
  EXPECT_EQ(objectives_of(options)[1].weight, 0.5);
}

TEST(FlipObjectives, OfFlightsAndLandingsRefuseAMotionWithout) {
  Flip standing({"flat"});
  for (const char* name : {"height", "cam", "cav", "bav"}) {
    const Objective& objective = objective_named(name);
    EXPECT_TRUE(says(refusal_of([&] { added(standing, objective); }),
                     std::string(name) + " is about a flight, and no phase"));
    EXPECT_TRUE(says(refusal_of([&] { standing.value(name); }), "no phase"));
  }
  EXPECT_TRUE(says(refusal_of([&] { added(standing, objective_named("gear_load")); }),
                   "gear_load is about landings"));
  for (const char* name : {"effort", "energy", "region_margin", "time"}) {
    EXPECT_EQ(refusal_of([&] { added(standing, objective_named(name)); }), "accepted") << name;
  }
}

struct Solved {
  bool is_solved = false;
  Values objectives;
};

/// The hopper's flip, coarse, its durations free.
Solved planned(const std::string& objective) {
  PlanOptions options;
  options.margins = {0.02, 0.04, 0.15, 0.05, 0.05, 0.02, 0.02};
  options.objectives = {{objective, 1.0}};
  const PlanModel model = plan_model(the_hopper(), options);
  std::vector<MeshPhase> mesh, fixed;
  const std::vector<std::string> names{"flat", "heel", "flight", "heel", "flat"};
  const double durations_s[] = {0.45, 0.12, 0.52, 0.08, 0.7};
  const optimization::Bounds ranges_s[] = {
      {0.2, 0.8}, {0.03, 0.3}, {0.3, 0.8}, {0.02, 0.3}, {0.4, 1.2}};
  const int intervals[] = {5, 8, 8, 8, 5};
  const std::vector<Stance> stances = stances_of(model.plane, names);
  for (std::size_t p = 0; p < 5; ++p) {
    std::vector<double> knots;
    for (int i = 0; i <= intervals[p]; ++i) {
      knots.push_back(static_cast<double>(i) / intervals[p]);
    }
    mesh.push_back({stances[p], knots, ranges_s[p]});
    fixed.push_back({stances[p], knots, {durations_s[p], durations_s[p]}});
  }
  const PlanGoal goal = plan_goal(model, options);
  const FlipProgram program =
      flip_program(model, mesh, goal, options, key_frame_guess(model, fixed, goal, options));
  optimization::NonlinearOptions search;
  search.tolerance = 1e-5;
  const auto solution = optimization::solve(program.program, search);
  Solved out{solution.is_solved(), {}};
  for (const Objective& one : every_objective()) {
    out.objectives.push_back(one.value(model, options, program, solution.values));
  }
  return out;
}

TEST(FlipPlans, HaveMoreOfWhatTheyArePlannedFor) {
  const Solved effort = planned("effort");
  ASSERT_TRUE(effort.is_solved);
  for (std::size_t i = 1; i < every_objective().size(); ++i) {
    const Objective& objective = every_objective()[i];
    const Solved own = planned(std::string(objective.name));
    EXPECT_TRUE(own.is_solved) << objective.name;
    const double gain = own.objectives[i] - effort.objectives[i];
    const bool is_least = objective.sentence.starts_with("least");
    EXPECT_GT(is_least ? -gain : gain, 1e-3 * std::abs(effort.objectives[i])) << objective.name;
    EXPECT_GT(own.objectives[0], effort.objectives[0]) << objective.name;  // which costs effort
  }
}

}  // namespace
}  // namespace torquewright::hopper
