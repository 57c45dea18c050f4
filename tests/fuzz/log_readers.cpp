// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/log_readers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "actuator/motor/actuator_spec.hpp"
#include "identification/log/log.hpp"
#include "identification/reading/against_actuator.hpp"
#include "identification/reading/read_log.hpp"
#include "io/documents/document.hpp"
#include "tests/fuzz/readers.hpp"

namespace torquewright::fuzz {
namespace {

namespace fs = std::filesystem;

const identification::Rig& corpus_rig() {
  static const identification::Rig rig = identification::read_rig(io::read_document(
      fs::path(TORQUEWRIGHT_SOURCE_DIR) / "tests/fuzz/corpus/measured_rig.json", "rig"));
  return rig;
}

const std::vector<actuator::Actuator>& corpus_actuators() {
  static const std::vector<actuator::Actuator> actuators = {
      actuator::read_actuator(fs::path(TORQUEWRIGHT_SOURCE_DIR) / "specs/actuator/d151_knee.json")
          .actuator};
  return actuators;
}

void check_run(const identification::Run& run) {
  const std::size_t count = run.masked.size();
  if (count == 0) throw Misbehaviour("a stretch without samples");
  if (run.time_s.size() != count) throw Misbehaviour("time of another length");
  if (std::adjacent_find(run.time_s.begin(), run.time_s.end(), std::greater_equal<>()) !=
      run.time_s.end()) {
    throw Misbehaviour("time that does not ascend");
  }
  for (const identification::Channels& joint : run.joints) {
    for (const std::vector<double>& values : joint.of) {
      if (!values.empty() && values.size() != count)
        throw Misbehaviour("a channel of another length");
      const bool finite = std::all_of(values.begin(), values.end(),
                                      [](double value) { return std::isfinite(value); });
      if (!finite) throw Misbehaviour("a value that is not finite");
    }
  }
}

}  // namespace

void read_rig_document(const fs::path& file) {
  const identification::Rig rig = identification::read_rig(io::read_document(file, "rig"));
  if (rig.columns.empty() || rig.joints.empty()) throw Misbehaviour("a rig of nothing");
}

void read_measured_log(const fs::path& file) {
  identification::Log log = identification::read_log({file}, corpus_rig());
  identification::check_against(log, corpus_rig(), corpus_actuators());
  for (const identification::Run& run : log.runs) {
    check_run(run);
    const auto uses = std::count(log.train_runs.begin(), log.train_runs.end(), run.name) +
                      std::count(log.holdout_runs.begin(), log.holdout_runs.end(), run.name);
    if (uses != 1) throw Misbehaviour("a run that is neither fitted nor held out, or both");
  }
}

}  // namespace torquewright::fuzz
