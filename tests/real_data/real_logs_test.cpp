// SPDX-License-Identifier: Apache-2.0
// The published logs with their rigs and nominal actuators: read without a fault, nothing lost.
// Oracles: lines of the files (wc -l less the header); names of runs in the source's notes; samples
// at the extremes of the current counted with sort and uniq. The logs are no part of the
// repository.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "actuator/motor/actuator_spec.hpp"
#include "identification/log/log.hpp"
#include "identification/reading/against_actuator.hpp"
#include "identification/reading/read_log.hpp"
#include "io/documents/document.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::identification {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = TORQUEWRIGHT_SOURCE_DIR;
const fs::path kRigs = kSource / "tests/real_data/rigs";

/// The folder of the measured logs, or nothing where it is absent.
fs::path logs() {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const fs::path data = variable != nullptr ? fs::path(variable) : kSource / "../shared/data";
  return fs::is_directory(data / "logs") ? data / "logs" : fs::path();
}

struct RealLog {
  Rig rig;
  Log log;
};

RealLog read_real(const char* rig, const char* actuator, const std::vector<std::string>& files) {
  RealLog result{read_rig(io::read_document(kRigs / rig, "rig")), Log()};
  std::vector<fs::path> paths;
  for (const std::string& file : files) paths.push_back(logs() / file);
  result.log = read_log(paths, result.rig);
  const actuator::Actuator nominal = actuator::read_actuator(kRigs / actuator).actuator;
  check_against(result.log, result.rig, {result.rig.joints.size(), nominal});
  return result;
}

/// Samples by the run's name.
std::map<std::string, std::size_t> samples(const Log& log) {
  std::map<std::string, std::size_t> counts;
  for (const auto& run : log.runs) counts[run.name] += run.masked.size();
  return counts;
}

std::size_t masked(const Log& log) {
  std::size_t count = 0;
  for (const auto& run : log.runs) {
    count += static_cast<std::size_t>(std::count(run.masked.begin(), run.masked.end(), 1));
  }
  return count;
}

std::string sentences(const Log& log, Weight least) {
  std::string text;
  for (const DataFinding& finding : log.findings) {
    if (finding.weight >= least) text += finding.sentence + "\n";
  }
  return text;
}

using Counts = std::map<std::string, std::size_t>;

class RealLogs : public testing::Test {
  void SetUp() override {
    if (logs().empty()) GTEST_SKIP() << "the measured logs (../shared/data) are not here";
  }
};

TEST(RealRigs, AreReadWhereTheLogsAreAbsent) {
  int rigs = 0;
  int actuators = 0;
  for (const auto& entry : fs::directory_iterator(kRigs)) {
    if (entry.path().stem().string().ends_with("_actuator")) {
      EXPECT_NO_THROW(actuator::read_actuator(entry.path())) << entry.path();
      ++actuators;
    } else {
      EXPECT_NO_THROW(read_rig(io::read_document(entry.path(), "rig"))) << entry.path();
      ++rigs;
    }
  }
  EXPECT_EQ(rigs, 7);
  EXPECT_EQ(actuators, 4);
}

TEST_F(RealLogs, BamServos) {
  const RealLog real =
      read_real("bam_servos.json", "bam_servos_actuator.json",
                {"bam_servos/xl330_train.csv", "bam_servos/xl330_heldout_kp200.csv"});
  const Counts counts = samples(real.log);
  EXPECT_EQ(counts.size(), 16u);
  std::size_t total = 0;
  for (const auto& [name, count] : counts) total += count;
  EXPECT_EQ(total, 14593u + 4859u);
  // Both files have runs 0...3; those of the second were taken with the gain of 200.
  EXPECT_EQ(counts.at("xl330_heldout_kp200/1"), 1513u);
  EXPECT_EQ(counts.at("11"), 1110u);
  EXPECT_EQ(real.log.holdout_runs.size(), 4u);
  EXPECT_EQ(real.log.train_runs.size(), 12u);
  EXPECT_EQ(sentences(real.log, Weight::kWarning), "");
  EXPECT_EQ(masked(real.log), 0u);
}

TEST_F(RealLogs, OdriveCogging) {
  for (const auto& [file, expected] : std::vector<std::pair<std::string, Counts>>{
           {"slow_velocity_comp", {{"0", 4377}, {"1", 4367}, {"2", 4349}}},
           {"slow_velocity_nocomp", {{"0", 4306}, {"1", 4267}, {"2", 4342}}}}) {
    const RealLog real = read_real("odrive_cogging.json", "odrive_actuator.json",
                                   {"odrive_cogging/" + file + ".csv"});
    EXPECT_EQ(samples(real.log), expected);
    EXPECT_EQ(sentences(real.log, Weight::kWarning), "");
    EXPECT_EQ(masked(real.log), 0u);
  }
}

TEST_F(RealLogs, OdriveStaticMapHasNoTime) {
  const RealLog real = read_real("odrive_static_map.json", "odrive_actuator.json",
                                 {"odrive_cogging/static_map.csv"});
  EXPECT_EQ(samples(real.log),
            (Counts{{"a_16", 512}, {"b_16", 512}, {"d_16", 512}, {"e_16r", 512}}));
  for (const auto& run : real.log.runs) EXPECT_TRUE(run.time_s.empty());
  EXPECT_EQ(sentences(real.log, Weight::kWarning), "");
}

struct RomelaFile {
  const char* name;
  std::size_t samples;
  std::size_t at_limit;  ///< |i| = 23.6 A, of the driver's scale.
};

TEST_F(RealLogs, RomelaCycloidal) {
  for (const RomelaFile& file : std::vector<RomelaFile>{{"contact2", 11862, 572},
                                                        {"contact3", 23751, 898},
                                                        {"normal1", 11885, 185},
                                                        {"normal2", 15838, 105},
                                                        {"torqueripple1", 11860, 143},
                                                        {"torqueripple2", 11906, 0},
                                                        {"torqueripple3", 11831, 0},
                                                        {"torqueripple4", 15850, 175}}) {
    const RealLog real = read_real("romela_cycloidal.json", "romela_actuator.json",
                                   {std::string("romela_cycloidal/") + file.name + ".csv"});
    const std::string name = file.name;
    const Counts counts = samples(real.log);
    ASSERT_EQ(counts.size(), 2u) << name;
    EXPECT_EQ(counts.at(name + " (last third)"), file.samples / 3) << name;
    EXPECT_EQ(counts.at(name + " (first two thirds)"), file.samples - file.samples / 3) << name;
    EXPECT_EQ(masked(real.log), file.at_limit) << name;
    const std::string said = sentences(real.log, Weight::kWarning);
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), file.at_limit > 0 ? 1 : 0) << said;
  }
}

TEST_F(RealLogs, DfkiDoublePendulum) {
  const RealLog real =
      read_real("dfki_double_pendulum.json", "ak80_6_actuator.json",
                {"dfki_double_pendulum/train_a.csv", "dfki_double_pendulum/train_b.csv",
                 "dfki_double_pendulum/heldout.csv"});
  EXPECT_EQ(samples(real.log), (Counts{{"0", 4998},
                                       {"1", 4997},
                                       {"2", 5000},
                                       {"3", 4999},
                                       {"4", 4998},
                                       {"5", 4995},
                                       {"6", 4992},
                                       {"7", 4998},
                                       {"8", 2996},
                                       {"9", 2997}}));
  EXPECT_EQ(real.rig.joints, (std::vector<std::string>{"shoulder", "elbow"}));
  EXPECT_EQ(sentences(real.log, Weight::kWarning), "");
  EXPECT_EQ(masked(real.log), 0u);
}

TEST_F(RealLogs, DfkiSimplePendulum) {
  const RealLog real =
      read_real("dfki_simple_pendulum.json", "ak80_6_actuator.json",
                {"dfki_simple_pendulum/ddp.csv", "dfki_simple_pendulum/direct_collocation.csv"});
  EXPECT_EQ(samples(real.log), (Counts{{"ddp", 3000}, {"direct_collocation", 1170}}));
  EXPECT_EQ(sentences(real.log, Weight::kWarning), "");
}

// 3.9 s with an unpublished mass: too little to fit and to hold out.
TEST_F(RealLogs, DfkiLightPendulumCannotTell) {
  const RealLog real = read_real("dfki_simple_pendulum_light.json", "ak80_6_actuator.json",
                                 {"dfki_simple_pendulum/pd_sysid.csv"});
  EXPECT_EQ(masked(real.log), 0u);
  EXPECT_NE(sentences(real.log, Weight::kError).find("the log cannot tell"), std::string::npos);
}

}  // namespace
}  // namespace torquewright::identification
