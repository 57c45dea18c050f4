// SPDX-License-Identifier: Apache-2.0
// A search for effects can be left on the way. Oracle: the exception that the test throws.
#include <gtest/gtest.h>

#include "identification/answer/identify.hpp"

namespace torquewright::identification {
namespace {

struct Left {};

TEST(LeftSearch, EndsBeforeTheNextFit) {
  const auto specs = std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "specs" / "log";
  const Rig rig = read_rig(io::read_document(specs / "bench_rig.json", "rig"));
  const JointActuator nominal{"", actuator::read_actuator(specs / "bench_actuator.json")};
  int fits = 0;
  IdentifyOptions options;
  options.analysis.before_each_fit = [&fits] {
    if (++fits == 3) throw Left();
  };
  EXPECT_THROW((void)identify({specs / "bench_as_built.csv"}, rig, {nominal}, options), Left);
  EXPECT_EQ(fits, 3);
}

}  // namespace
}  // namespace torquewright::identification
