// SPDX-License-Identifier: Apache-2.0
// What every topology must keep, whatever it is. Oracles: its own evaluation of a design, and that
// no train gives more power than it takes.
#include "gearbox/topologies/topology.hpp"

#include <gtest/gtest.h>

#include <set>

#include "gearbox/train/cut_train.hpp"
#include "tests/gearbox/example_problem.hpp"

namespace torquewright::gearbox {
namespace {

// A few roundings of numbers of that size.
constexpr double kRounding = 1e-12;

class EachTopology : public testing::TestWithParam<Topology> {
 protected:
  const Topology& topology() const { return GetParam(); }

  Problem problem() const {
    Problem problem = test::knee();
    problem.topology = topology().name;
    problem.constraints = ConstraintSet::kBuildable;
    problem.objective = Objective::kHollowShaft;
    problem.load_output_torque_Nm = Rational(100);
    return problem;
  }

  /// Without two gears alike, so that none stands for another.
  Design design() const {
    std::vector<std::int64_t> teeth{24, 36, 30};
    teeth.resize(topology().free_gears);
    return {topology().complete(teeth), 4, Rational(3, 5)};
  }

  std::vector<double> teeth() const {
    const std::vector<std::int64_t> counts = design().teeth;
    return {counts.begin(), counts.end()};
  }

  DesignReport report() const { return topology().evaluate(problem(), design()); }
};

TEST_P(EachTopology, HasPartsThatFitEachOther) {
  const Topology& each = topology();
  EXPECT_EQ(std::set<std::string_view>(each.gears.begin(), each.gears.end()).size(),
            each.gears.size());
  ASSERT_EQ(each.gear_layers.size(), each.gears.size());
  EXPECT_TRUE(each.is_ring(each.held_ring));
  ASSERT_EQ(each.meshes.size(), 1 + each.gears.size() - each.free_gears);
  for (std::size_t i = 0; i < each.meshes.size(); ++i) {
    const MeshedGears& mesh = each.meshes[i];
    EXPECT_EQ(each.gear_layers[mesh.gear_1], each.gear_layers[mesh.gear_2]) << mesh.name;
    EXPECT_FALSE(each.is_ring(mesh.gear_1)) << mesh.name;
    EXPECT_EQ(each.is_ring(mesh.gear_2), i > 0) << mesh.name;
    EXPECT_EQ(mesh.name,
              std::string(each.gears[mesh.gear_1]) + "_" + std::string(each.gears[mesh.gear_2]));
  }
  EXPECT_EQ(each.drawn.size(), each.gears.size());
  EXPECT_EQ(each.views.size(), each.layer_count());
  EXPECT_EQ(each.complete(std::vector<std::int64_t>{24, 36, 30}).size(), each.gears.size());
}

TEST_P(EachTopology, IsFoundByItsName) {
  EXPECT_EQ(find_topology(topology().name)->meshes.size(), topology().meshes.size());
  EXPECT_EQ(find_train_parts(topology().name)->gears, topology().gears);
}

TEST_P(EachTopology, IsReportedGearByGearAndMeshByMesh) {
  const DesignReport found = report();
  ASSERT_EQ(found.gears.size(), topology().gears.size());
  for (std::size_t i = 0; i < found.gears.size(); ++i) {
    EXPECT_EQ(found.gears[i].name, topology().gears[i]);
    EXPECT_EQ(found.gears[i].internal, topology().is_ring(i));
    EXPECT_EQ(found.gears[i].layer, topology().layer_names()[topology().gear_layers[i]]);
  }
  EXPECT_EQ(found.gears[topology().held_ring].speed_per_input, 0.0);
  ASSERT_EQ(found.meshes.size(), topology().meshes.size());
  for (std::size_t i = 0; i < found.meshes.size(); ++i) {
    EXPECT_EQ(found.meshes[i].name, topology().meshes[i].name);
  }
}

TEST_P(EachTopology, HasTheRatioAndTheForcesOfItsReport) {
  const DesignReport found = report();
  const double ratio = found.ratio.get_d();
  EXPECT_NEAR(topology().reduction(teeth()), ratio, kRounding * std::abs(ratio));
  const double centre_m = 0.6e-3 * (teeth()[0] + teeth()[1]) / 2.0;
  const std::vector<double> forces = topology().forces_N(teeth(), 4, centre_m);
  ASSERT_EQ(forces.size(), found.meshes.size());
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const double reported = std::abs(found.meshes[i].tangential_force_N / *found.input_torque_Nm);
    EXPECT_NEAR(forces[i], reported, kRounding * reported) << i;
  }
}

TEST_P(EachTopology, LosesNothingWithoutLossesAndLessThanAllWithThem) {
  const std::size_t meshes = topology().meshes.size();
  const TrainEfficiency whole = topology().efficiency(teeth(), std::vector<double>(meshes, 1.0));
  EXPECT_NEAR(whole.forward, 1.0, kRounding);
  EXPECT_NEAR(whole.backward, 1.0, kRounding);
  const TrainEfficiency lossy = topology().efficiency(teeth(), std::vector<double>(meshes, 0.99));
  EXPECT_LT(lossy.forward, 0.99);
  EXPECT_GT(lossy.forward, 0.0);
}

TEST_P(EachTopology, StandsWithAsManyPlanetsAsItHas) {
  EXPECT_EQ(topology().assemble(design().teeth, 4).planets.size(), 4u);
}

TEST_P(EachTopology, KeepsItsRatioAtOtherSizes) {
  if (topology().largest_of_same_ratio == nullptr) return;
  const std::vector<std::int64_t> own = design().teeth;
  const std::int64_t most = 2 * own[topology().held_ring] + 1;
  const std::vector<std::int64_t> larger = topology().largest_of_same_ratio(own, most);
  ASSERT_EQ(larger.size(), own.size());
  for (std::size_t i = 0; i < own.size(); ++i) EXPECT_EQ(larger[i], 2 * own[i]);
  EXPECT_TRUE(topology().largest_of_same_ratio(own, 1).empty());
}

INSTANTIATE_TEST_SUITE_P(Topologies, EachTopology,
                         testing::ValuesIn(topologies().begin(), topologies().end()),
                         [](const auto& test) { return "of_" + std::string(test.param.name); });

TEST(Topologies, AreThoseOfTheListOfParts) {
  ASSERT_EQ(topologies().size(), all_train_parts().size());
  for (std::size_t i = 0; i < topologies().size(); ++i) {
    EXPECT_EQ(topologies()[i].name, all_train_parts()[i].name);
  }
  EXPECT_EQ(find_topology("9k"), nullptr);
  EXPECT_THROW(train_parts("9k"), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::gearbox
