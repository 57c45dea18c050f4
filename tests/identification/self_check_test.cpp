// SPDX-License-Identifier: Apache-2.0
// What a refined document promises is kept, or it is not written. Oracle: the same log, read with
// a document that is what was found, and with one that was changed behind the search's back.
#include "identification/answer/self_check.hpp"

#include <gtest/gtest.h>

#include "identification/answer/refined_json.hpp"
#include "io/faults/json_text.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::identification {
namespace {

class KeptPromise : public testing::Test {
 protected:
  KeptPromise()
      : logs({specs / "bench_as_built.csv"}),
        rig(read_rig(io::read_document(specs / "bench_rig.json", "rig"))),
        nominal({"", actuator::read_actuator(specs / "bench_actuator.json")}),
        found(identify(logs, rig, {nominal})) {}

  std::string broken(actuator::Actuator changed) const {
    JointActuator refined = nominal;
    refined.nominal.actuator = std::move(changed);
    return broken_promise(found, as_written(logs, rig, {refined}, found));
  }

  const std::filesystem::path specs =
      std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "specs" / "log";
  test::ScratchFolder folder;
  std::vector<std::filesystem::path> logs;
  Rig rig;
  JointActuator nominal;
  Identification found;
};

TEST_F(KeptPromise, WhatWasFoundKeepsItAndWhatWasStatedDoesNot) {
  ASSERT_FALSE(found.equations.front().added.empty());
  const std::string text = io::json_text(refined_actuator(found, nominal));
  const auto file = folder.write("refined.json", text);
  EXPECT_EQ(broken(actuator::read_actuator(file).actuator), "");
  const std::string said = broken(nominal.nominal.actuator);
  EXPECT_NE(said.find("were promised: it is not written"), std::string::npos) << said;
}

TEST_F(KeptPromise, TheDocumentStatesWhatItLeavesItself) {
  const auto first = folder.write("refined.json", io::json_text(refined_actuator(found, nominal)));
  const Identification judged =
      as_written(logs, rig, {{"", actuator::read_actuator(first)}}, found);
  const auto document = refined_actuator(found, nominal, &judged);
  const auto& provenance = document["effects"].back()["provenance"];
  EXPECT_EQ(provenance["holdout_rms_after"], judged.equations.front().before.holdout_rms);
  EXPECT_EQ(provenance["holdout_rms_before"], found.equations.front().before.holdout_rms);
}

TEST(AskedEffects, AreThoseOfTheListWithoutTheOthers) {
  AnalysisOptions options;
  EXPECT_TRUE(options.asks("coulomb_friction"));
  options.without = {"coulomb_friction"};
  EXPECT_FALSE(options.asks("coulomb_friction"));
  EXPECT_TRUE(options.asks("gear_ripple"));
  options.only = {"gear_ripple", "coulomb_friction"};
  EXPECT_FALSE(options.asks("coulomb_friction"));
  EXPECT_TRUE(options.asks("gear_ripple"));
  EXPECT_FALSE(options.asks("viscous_friction"));
}

}  // namespace
}  // namespace torquewright::identification
