// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/hopper_replay_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "hopper/replay_report/replay_report_spec.hpp"
#include "src/commands/shared/fingerprint_json.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/commands/shared/stated_json.hpp"

namespace torquewright::cli {
namespace {

std::vector<io::Document> read_documents(const HopperCheckInputs& inputs,
                                         const hopper::Motion& motion) {
  std::vector<io::Document> read = inputs.robot.documents;
  read.push_back({motion.file, "", {}, motion.sha256});
  read.insert(read.end(), inputs.columns.begin(), inputs.columns.end());
  return read;
}

}  // namespace

std::string hopper_replay_json(const HopperReplayRequest& request, const HopperCheckInputs& inputs,
                               const hopper::Motion& motion, const hopper::ReplayReport& report) {
  nlohmann::ordered_json document = hopper::replay_report_json(report);
  document["options"] = stated_json(*request.declared);
  return result_text(std::move(document), read_documents(inputs, motion));
}

std::string hopper_trials_fingerprint(const HopperReplayRequest& request,
                                      const HopperCheckInputs& inputs,
                                      const hopper::Motion& motion) {
  nlohmann::ordered_json options = counted_json(*request.declared);
  // A journal serves any number of its trials.
  for (const char* key : {"trials", "trial"}) options.erase(key);
  return fingerprint("hopper replay", options, read_documents(inputs, motion));
}

}  // namespace torquewright::cli
