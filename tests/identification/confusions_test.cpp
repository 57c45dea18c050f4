// SPDX-License-Identifier: Apache-2.0
// Oracle: the columns' algebra, rig by rig, as docs/derivations/identification.md section 1 has the
// balance: what stands in it in the same place is the same column.
#include "identification/findings/confusions.hpp"

#include <gtest/gtest.h>

#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::confusions_test {
namespace {

using Names = std::vector<std::string>;

struct Case {
  made::MadeBench made;
  Log log = made.log([](const made::Made&) { return 0.0; });
  Bench bench() {
    Bench bench = made.bench(log);
    if (made.rig.load.type != LoadType::kDynamometer) bench.load_side = LoadSide::kModel;
    return bench;
  }
};

TEST(Confusions, AnOffsetIsOneWhereverItStands) {
  Case made;
  const Names group = {"torque_offset", "current_offset", "asymmetric_friction"};
  for (const std::string& effect : group) EXPECT_EQ(exact_identities(made.bench(), effect), group);
  EXPECT_NE(separated_by(made.bench(), group).find("tare"), std::string::npos);
  EXPECT_NE(consequence("torque_offset", group).find("nothing changes in the region"),
            std::string::npos);
  // 0.2 one way and 0.8 the other are 0.5 both ways and an offset of 0.3.
  EXPECT_NE(consequence("asymmetric_friction", group).find("in common remains"), std::string::npos);
}

// g+ and g- of either sensor: one is the inverse of the other, where friction is small beside them.
TEST(Confusions, AGainThatDiffersBySignMayBeEitherSensors) {
  Case made;
  const Names group = {"current_gain_error", "torque_gain_error"};
  EXPECT_EQ(exact_identities(made.bench(), "current_gain_error"), group);
  EXPECT_NE(separated_by(made.bench(), group).find("weights"), std::string::npos);
  made.made.rig.load.type = LoadType::kPendulum;
  EXPECT_EQ(exact_identities(made.bench(), "current_gain_error"), Names{"current_gain_error"});
}

// N k is an order of the output where N is whole; a ripple's order may be anything.
TEST(Confusions, CoggingIsARippleWhereTheRatioIsWhole) {
  Case made;
  EXPECT_EQ(exact_identities(made.bench(), "cogging_torque"),
            (Names{"cogging_torque", "gear_ripple"}));
  EXPECT_EQ(exact_identities(made.bench(), "gear_ripple"), Names{"gear_ripple"});
  made.made.actuator.transmission.ratio = 9.3;
  EXPECT_EQ(exact_identities(made.bench(), "cogging_torque"), Names{"cogging_torque"});
}

// On a free load all torque accelerates: (N Kt i) s = (J + dJ) a has one unknown. With a sensor the
// two sides are measured apart.
TEST(Confusions, TorqueConstantIsInertiaOnAFreeLoadOnly) {
  Case made;
  EXPECT_EQ(exact_identities(made.bench(), "torque_constant_error"),
            Names{"torque_constant_error"});
  EXPECT_EQ(exact_identities(made.bench(), "reflected_inertia"), Names{"reflected_inertia"});
  made.made.rig.load.type = LoadType::kFree;
  const Names group = {"torque_constant_error", "reflected_inertia", "load_inertia_error"};
  EXPECT_EQ(exact_identities(made.bench(), "torque_constant_error"), group);
  EXPECT_EQ(exact_identities(made.bench(), "reflected_inertia"), group);
}

// A value that the rig does not call uncertain may be wrong all the same.
TEST(Confusions, AnErrorOfTheRigNeedsNoLeaveOfTheRig) {
  Case made;
  made.made.rig.load.type = LoadType::kPendulum;
  for (const std::vector<std::string>& uncertain :
       {std::vector<std::string>{}, {"/load/inertia_kg_m2", "/load/mass_kg"}}) {
    made.made.rig.uncertain = uncertain;
    EXPECT_EQ(exact_identities(made.bench(), "reflected_inertia"),
              (Names{"reflected_inertia", "load_inertia_error"}));
    EXPECT_EQ(exact_identities(made.bench(), "torque_constant_error"),
              (Names{"torque_constant_error", "load_mass_error"}));
  }
}

// m a = N Kt g i - J a: on a linear axis mass and inertia are one as well.
TEST(Confusions, MassIsInertiaOnALinearAxis) {
  Case made;
  made.made.rig.load.type = LoadType::kLinearAxis;
  EXPECT_EQ(exact_identities(made.bench(), "reflected_inertia"),
            (Names{"torque_constant_error", "reflected_inertia", "load_mass_error"}));
}

// s_sensor tau and s_actuator tau are the same low pass of the same torque.
TEST(Confusions, ALagIsTheSensorsOrTheActuatorsWhereASensorMeasuresTorque) {
  Case made;
  EXPECT_EQ(exact_identities(made.bench(), "torque_lag"), (Names{"torque_lag", "channel_lag"}));
  EXPECT_NE(separated_by(made.bench(), {"torque_lag", "channel_lag"}).find("own response"),
            std::string::npos);
  made.made.rig.load.type = LoadType::kFree;
  EXPECT_EQ(exact_identities(made.bench(), "torque_lag"), Names{"torque_lag"});
}

TEST(Confusions, FrictionHasNoIdentity) {
  Case made;
  for (const char* effect : {"coulomb_friction", "viscous_friction", "stribeck_friction"}) {
    EXPECT_EQ(exact_identities(made.bench(), effect), Names{effect});
  }
}

}  // namespace
}  // namespace torquewright::identification::confusions_test
