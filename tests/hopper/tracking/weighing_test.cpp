// SPDX-License-Identifier: Apache-2.0
// Oracles: Bayes' least squares over all looks at once, and the regulator that does not weigh.
#include "hopper/tracking/weighing.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "hopper/tracking/error_space.hpp"
#include "hopper/tracking/lqr.hpp"
#include "tests/hopper/tracking/closed_loop.hpp"
#include "tests/oracles/dice.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kWeighedErrors = 4, kFewDrives = 2, kUnknowns = 3;
constexpr double kPeriod_s = 1e-3;

MatrixXd some(oracles::Dice& dice, Index rows, Index columns) {
  MatrixXd out(rows, columns);
  for (double& number : out.reshaped()) {
    number = 1e-3 * static_cast<double>(dice.between(-1000, 1000));
  }
  return out;
}

std::vector<ErrorModel> some_models(oracles::Dice& dice, int count) {
  std::vector<ErrorModel> models;
  for (int i = 0; i < count; ++i) {
    models.push_back({some(dice, kWeighedErrors, kWeighedErrors),
                      some(dice, kWeighedErrors, kFewDrives),
                      some(dice, kWeighedErrors, kUnknowns)});
  }
  return models;
}

// Drives that do what the model says: the errors are a known part and one that is linear in the
// unknowns, so that all looks are one regression whose prior is the unknowns' spread.
TEST(Weighing, IsTheRegressionOverAllLooks) {
  oracles::Dice dice(91);
  const std::vector<ErrorModel> models = some_models(dice, 6);
  const VectorXd spread = (VectorXd(3) << 0.5, 1.5, 0.1).finished();
  const WeighingOptions options{0.3, 0.2, 0.5, 0.4, 0.0, 0.05};
  const VectorXd looked = (VectorXd(4) << 0.3, 0.2, 0.5, 0.4).finished().cwiseAbs2();
  const std::vector<MatrixXd> gains =
      WeighingGains(kWeighedErrors, spread, 1, options).over(models, kPeriod_s);
  Weighing weighing;
  weighing.start(kWeighedErrors, kUnknowns);
  MatrixXd information = spread.cwiseAbs2().cwiseInverse().asDiagonal();
  VectorXd evidence = VectorXd::Zero(kUnknowns), known = VectorXd::Zero(kWeighedErrors);
  MatrixXd by_unknown = MatrixXd::Zero(kWeighedErrors, kUnknowns);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const VectorXd feedback_Nm = some(dice, kFewDrives, 1), look = some(dice, kWeighedErrors, 1);
    weighing.look(models[i], gains[i], feedback_Nm, look);
    known = (models[i].by_error * known + models[i].by_drive * feedback_Nm).eval();
    by_unknown = (models[i].by_error * by_unknown + models[i].by_unknown).eval();
    information += by_unknown.transpose() * looked.cwiseInverse().asDiagonal() * by_unknown;
    evidence += by_unknown.transpose() * ((look - known).cwiseQuotient(looked));
    const VectorXd expected = information.llt().solve(evidence);
    EXPECT_LT((weighing.unknown() - expected).norm(), 1e-10 * (1.0 + expected.norm())) << i;
  }
}

// A stretch begins with what the one before it left: two of three periods are one of six.
TEST(Weighing, GoesOnFromStretchToStretch) {
  oracles::Dice dice(92);
  const std::vector<ErrorModel> all = some_models(dice, 6);
  const VectorXd spread = (VectorXd(3) << 0.5, 1.5, 0.1).finished();
  const std::vector<MatrixXd> whole = WeighingGains(kWeighedErrors, spread, 1).over(all, kPeriod_s);
  WeighingGains parts(kWeighedErrors, spread, 1);
  for (const std::size_t from : {0, 3}) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(from);
    const std::vector<MatrixXd> part = parts.over({first, first + 3}, kPeriod_s);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(part[i], whole[from + i]) << from + i;
  }
}

/// How far attitude and joints end from where they are to be, after standing with the thigh's
/// centre of mass off to a side by so much.
double ends_off(bool weighs, double sideways_m) {
  const Robot documented = test::robot_of("hopper.json");
  Robot built = documented;
  built.tree.bodies[0].inertia.center_of_mass_m.y() += sideways_m;
  const Reference reference = test::standing(documented, test::crouch(documented), 0.3);
  LqrOptions options;
  options.weighs = weighs;
  const LqrResult found = lqr_gains(documented, reference, options);
  const auto regulator = lqr_controller(documented, reference, found.gains, {}, {});
  test::ClosedLoop loop(built, *regulator);
  ReferenceInstant wanted;
  reference.at(0.0, wanted);
  loop.start(wanted.position, wanted.velocity, 0.0);
  EXPECT_TRUE(loop.run_until(0.8));
  const VectorXd error =
      aligned_error(documented.tree, wanted, loop.position(), loop.velocity()).error;
  return error.segment(3, 6).norm();
}

// What it knows of it leans against less. Not by how much: that is the balance of the weights.
TEST(Weighing, HoldsARobotThatIsNotAsDocumentedNearerToItsPosture) {
  EXPECT_LT(ends_off(true, 0.01), ends_off(false, 0.01));
}

}  // namespace
}  // namespace torquewright::hopper
