// SPDX-License-Identifier: Apache-2.0
// Trains of central gears on stepped planets, of any topology. Oracles: rolling without slip solved
// as linear equations, balance of a planet, conservation of power with what each mesh takes.
#include "gearbox/train/central_gears.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <random>

#include "gearbox/topologies/topology.hpp"
#include "gearbox/train/kinematics.hpp"
#include "tests/gearbox/linear_solve.hpp"

namespace torquewright::gearbox {
namespace {

// Some roundings of numbers near 1, grown by solving.
constexpr double kSolved = 1e-10;

std::vector<double> random_teeth(std::mt19937& generator, const TrainParts& parts) {
  const auto among = [&](int low, int high) {
    return static_cast<double>(low + static_cast<int>(generator() % unsigned(high - low + 1)));
  };
  std::vector<double> teeth{among(12, 60), among(18, 50), among(18, 50)};
  teeth.resize(parts.free_gears);
  for (std::size_t gear = parts.free_gears; gear < parts.gears.size(); ++gear) {
    teeth.push_back(teeth[0] + teeth[1] + teeth[parts.planet_beside(gear)] + among(-1, 1));
  }
  return teeth;
}

bool moves(const TrainParts& parts, const std::vector<double>& teeth) {
  return std::abs(1.0 - basic_ratios<double>(parts, teeth).second) > 0.01;
}

/// A train of every topology, at random.
void each_train(const std::function<void(const TrainParts&, const std::vector<double>&)>& visit) {
  std::mt19937 generator(3);
  for (const TrainParts& parts : all_train_parts()) {
    SCOPED_TRACE(parts.name);
    for (int trial = 0; trial < 200;) {
      const std::vector<double> teeth = random_teeth(generator, parts);
      if (!moves(parts, teeth)) continue;
      ++trial;
      visit(parts, teeth);
    }
  }
}

/// z (w - w_C) = -+ p (w_P - w_C) of the sun, the held ring and the output ring, the sun's speed 1;
/// without an output ring the third unknown is the carrier again.
std::array<double, 3> rolling(const TrainParts& parts, const std::vector<double>& teeth) {
  const double p_S = teeth[1], p_h = teeth[parts.planet_beside(parts.held_ring)];
  const double z_S = teeth[0], z_h = teeth[parts.held_ring];
  std::array<test::Row, 3> rows{
      {{-z_S - p_S, p_S, 0.0, -z_S}, {p_h - z_h, -p_h, 0.0, 0.0}, {1.0, 0.0, -1.0, 0.0}}};
  if (parts.output_ring) {
    const double z_o = teeth[*parts.output_ring],
                 p_o = teeth[parts.planet_beside(*parts.output_ring)];
    rows[2] = {p_o - z_o, -p_o, z_o, 0.0};
  }
  return test::solve(rows);
}

TEST(CentralGears, RollWithoutSlip) {
  each_train([](const TrainParts& parts, const std::vector<double>& teeth) {
    const auto [carrier, planet, output] = rolling(parts, teeth);
    const TrainSpeeds speeds = train_speeds(parts, teeth);
    EXPECT_NEAR(speeds.carrier, carrier, kSolved);
    EXPECT_NEAR(speeds.gears[1], planet, kSolved);
    EXPECT_NEAR(1.0 / basic_ratios<double>(parts, teeth).reduction(), output, kSolved);
    EXPECT_EQ(speeds.gears[parts.held_ring], 0.0);
    if (!parts.output_ring) return;
    EXPECT_NEAR(speeds.gears[*parts.output_ring], output, kSolved);
  });
}

/// Forces along the way of the planet's axis, and moments about it: the sun and the held ring push,
/// the output ring is pushed.
TEST(CentralGears, LeaveAPlanetInBalance) {
  each_train([](const TrainParts& parts, const std::vector<double>& teeth) {
    constexpr double kCentre_m = 0.02;
    const double reduction = basic_ratios<double>(parts, teeth).reduction();
    if (reduction < 1.0) return;  // The output turns backwards: the signs below are others.
    const std::vector<double> forces = mesh_forces_N(parts, teeth, 3, kCentre_m);
    double along = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const bool is_sun = i == 0;
      const double z = teeth[is_sun ? 0 : parts.meshes[i].gear_2];
      const double p = teeth[is_sun ? 1 : parts.meshes[i].gear_1];
      const double radius_m = kCentre_m * p / (is_sun ? z + p : z - p);
      const double push = parts.meshes[i].gear_2 == parts.output_ring ? -forces[i] : forces[i];
      along += push;
      moment += (is_sun ? -1.0 : 1.0) * push * radius_m;
    }
    const double carrier_Nm = parts.output_ring ? 0.0 : reduction;
    EXPECT_NEAR(3.0 * kCentre_m * along, carrier_Nm, kSolved * reduction);
    EXPECT_NEAR(moment, 0.0, kSolved * reduction);
  });
}

/// Rolling powers T (w - w_C) go through the meshes: what a central gear gives reaches the planets
/// times its mesh's efficiency, what it takes leaves them over it. Torques of all that is outside
/// sum to 0. The held ring's torque follows from each guess of who gives, and must agree with it.
std::optional<double> lossy_forward(const TrainParts& parts, const std::vector<double>& teeth,
                                    const std::vector<double>& efficiencies) {
  const auto [carrier, planet, output] = rolling(parts, teeth);
  const ThreeKMeshEfficiencies<double> mesh = by_role(parts, efficiencies);
  for (int guess = 0; guess < 4; ++guess) {
    const auto passed = [&](double eta, int bit) {
      return (guess >> bit & 1) != 0 ? eta : 1 / eta;
    };
    const double sun = (1.0 - carrier) * mesh.sun_planet_1;  // For 1 Nm at the sun.
    const double held = -carrier * passed(mesh.planet_1_fixed_ring, 0);
    const double out = (output - carrier) * passed(mesh.planet_2_output_ring, 1);
    // sun + T_h held + T_o out = 0, and T_o = -1 - T_h; without output ring `out` is 0.
    const double held_Nm = (out - sun) / (held - out);
    const double output_Nm = -1.0 - held_Nm;
    const bool held_gives = -held_Nm * carrier > 0.0;
    const bool output_gives = output_Nm * (output - carrier) > 0.0;
    if (held_gives != ((guess & 1) != 0)) continue;
    if (parts.output_ring && output_gives != ((guess & 2) != 0)) continue;
    const double efficiency = -output_Nm * output;
    if (efficiency > 0.0 && efficiency <= 1.0) return efficiency;
  }
  return std::nullopt;
}

TEST(CentralGears, LoseWhatTheirMeshesTake) {
  int compared = 0;
  each_train([&](const TrainParts& parts, const std::vector<double>& teeth) {
    std::vector<double> efficiencies{0.99, 0.995, 0.993};
    efficiencies.resize(parts.meshes.size());
    const auto lossy = lossy_forward(parts, teeth, efficiencies);
    if (!lossy) return;
    ++compared;
    EXPECT_NEAR(train_efficiency(parts, teeth, efficiencies).forward, *lossy, kSolved);
  });
  EXPECT_GT(compared, 700);
}

/// r_S psi + r_1 x = j_S and r_h psi - r_p x = j_h of carrier and planet, sun and held ring still;
/// the output ring: r_O o = r_O psi - r_q x + j_O.
TEST(CentralGears, OpenTheGapsOfTheirMeshesAtTheOutput) {
  each_train([](const TrainParts& parts, const std::vector<double>& teeth) {
    const std::vector<double> by_mesh = mesh_backlash_rad_per_m(parts, teeth, teeth);
    for (std::size_t gap = 0; gap < by_mesh.size(); ++gap) {
      std::array<double, 3> j{};  // Sun, held ring, output ring.
      const std::size_t ring = parts.meshes[gap].gear_2;
      j[gap == 0 ? 0 : ring == parts.held_ring ? 1 : 2] = 1.0;
      const double p_h = teeth[parts.planet_beside(parts.held_ring)];
      std::array<test::Row, 3> rows{{{teeth[0], teeth[1], 0.0, j[0]},
                                     {teeth[parts.held_ring], -p_h, 0.0, j[1]},
                                     {1.0, 0.0, -1.0, 0.0}}};
      if (parts.output_ring) {
        const double z_o = teeth[*parts.output_ring];
        rows[2] = {-z_o, teeth[parts.planet_beside(*parts.output_ring)], z_o, j[2]};
      }
      EXPECT_NEAR(by_mesh[gap], std::abs(test::solve(rows)[2]), kSolved);
    }
  });
}

// The two older topologies have formulas of their own.
TEST(CentralGears, AgreeWithTheFormulasOfASingleTopology) {
  each_train([](const TrainParts& parts, const std::vector<double>& z) {
    const double reduction = basic_ratios<double>(parts, z).reduction();
    if (parts.name == "3k") {
      const ThreeKTeeth<double> teeth{z[0], z[1], z[2], z[3], z[4]};
      EXPECT_NEAR(reduction, three_k_reduction(teeth), kSolved * std::abs(reduction));
    } else if (parts.name == "planetary") {
      EXPECT_NEAR(reduction, 1.0 + z[2] / z[0], kSolved * reduction);
    } else if (parts.name == "compound") {  // docs/derivations/kinematics.md eq. (19)
      EXPECT_NEAR(reduction, 1.0 + z[1] * z[3] / (z[0] * z[2]), kSolved * reduction);
    }
  });
}

}  // namespace
}  // namespace torquewright::gearbox
