// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/hopper_check_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "hopper/candidates/candidates_spec.hpp"
#include "hopper/check/hopper_report_spec.hpp"
#include "src/commands/shared/fingerprint_json.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/commands/shared/stated_json.hpp"
#include "src/sweep/swept_json.hpp"

namespace torquewright::cli {
namespace {

std::vector<io::Document> read_documents(const HopperCheckInputs& inputs,
                                         const HopperCheckRequest& request,
                                         const std::string& motion_sha256) {
  std::vector<io::Document> read = inputs.robot.documents;
  read.push_back({request.trajectory_file, "", {}, motion_sha256});
  read.insert(read.end(), inputs.columns.begin(), inputs.columns.end());
  read.insert(read.end(), inputs.candidates.documents.begin(), inputs.candidates.documents.end());
  return read;
}

}  // namespace

std::string hopper_check_json(const HopperCheckRequest& request, const HopperCheckInputs& inputs,
                              const HopperCheckFound& found) {
  nlohmann::ordered_json document = hopper::hopper_report_json(found.report);
  document["candidates"] = hopper::candidates_json(inputs.robot.robot, found.candidates);
  document["options"] = stated_json(*request.declared);
  return result_text(std::move(document),
                     read_documents(inputs, request, found.report.check.sha256));
}

std::string hopper_check_fingerprint(const HopperCheckRequest& request,
                                     const HopperCheckInputs& inputs,
                                     const hopper::Motion& motion) {
  return fingerprint("hopper check", counted_json(*request.declared),
                     read_documents(inputs, request, motion.sha256));
}

std::string hopper_check_sweep_json(const HopperCheckRequest& request,
                                    const HopperCheckInputs& inputs, const hopper::Motion& motion,
                                    const sweep::Swept& swept) {
  nlohmann::ordered_json document = sweep::swept_json(swept);
  document["options"] = stated_json(*request.declared);
  return result_text(std::move(document), read_documents(inputs, request, motion.sha256));
}

}  // namespace torquewright::cli
