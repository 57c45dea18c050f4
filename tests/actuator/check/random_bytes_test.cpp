// SPDX-License-Identifier: Apache-2.0
// Mutated tables: every one is read or refused with one sentence a fault, nothing else happens.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "actuator/trajectory/trajectory_reader.hpp"
#include "io/faults/spec_error.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

constexpr int kMutants = 3000;

std::string mutant(std::mt19937& random) {
  static const std::string kGood =
      "# x\ntime_s,k_position_rad,\"k_velocity_rad_s\",k_torque_Nm\r\n0,1,2,3\r\n0.1,1.5,-2e1,4\n";
  static const std::string kBytes = std::string(
      ",\"\n\r;#.0e-+\0 \xFF\xEF"
      "nan",
      18);
  std::string text = kGood;
  const auto below = [&random](std::size_t count) { return random() % count; };
  for (std::size_t i = 0, edits = 1 + below(4); i < edits; ++i) {
    const std::size_t place = below(text.size() + 1);
    const std::size_t kind = below(3);
    if (kind == 0) text.insert(place, 1, kBytes[below(kBytes.size())]);
    if (kind == 1) text.erase(place, 1 + below(5));
    if (kind == 2) text.insert(place, text.substr(below(text.size() + 1), below(40)));
    if (text.empty()) text = kGood;
  }
  return text;
}

TEST(RandomBytes, AreReadOrRefused) {
  const test::ScratchFolder folder;
  std::mt19937 random(11);
  int refused = 0;
  for (int i = 0; i < kMutants; ++i) {
    const std::string text = mutant(random);
    const auto file = folder.write("m.csv", text);
    try {
      TrajectoryReader reader(file, {}, {"k"}, {});
      Row row;
      double last_s = -1e308;
      while (reader.next(row)) {
        ASSERT_GT(row.time_s, last_s);
        last_s = row.time_s;
        ASSERT_EQ(row.values.size(), static_cast<std::size_t>(kPlaces));
      }
    } catch (const io::SpecError& error) {
      ++refused;
      ASSERT_EQ(error.faults().size(), 1u);
      ASSERT_FALSE(error.faults()[0].message.empty());
      ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << text;
    }
  }
  EXPECT_GT(refused, kMutants / 4);
  EXPECT_LT(refused, kMutants);
}

}  // namespace
}  // namespace torquewright::actuator
