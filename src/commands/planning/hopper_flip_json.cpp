// SPDX-License-Identifier: Apache-2.0
#include "src/commands/planning/hopper_flip_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "hopper/planning/search/plan_report_spec.hpp"
#include "src/commands/planning/hopper_flip_robust_json.hpp"
#include "src/commands/shared/fingerprint_json.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/commands/shared/stated_json.hpp"
#include "src/sweep/swept_json.hpp"

namespace torquewright::cli {
namespace {

using nlohmann::ordered_json;

std::vector<io::Document> read_documents(const HopperFlipInputs& inputs) {
  std::vector<io::Document> read = inputs.robot.documents;
  if (inputs.warm) read.push_back({inputs.warm->file, "", {}, inputs.warm->sha256});
  read.insert(read.end(), inputs.columns.begin(), inputs.columns.end());
  return read;
}

}  // namespace

std::string hopper_flip_json(const HopperFlipRequest& request, const HopperFlipInputs& inputs,
                             const hopper::PlanResult& result,
                             const std::optional<RobustChoice>& robust) {
  const auto seconds =
      request.timing ? hopper::PlanSeconds::kStated : hopper::PlanSeconds::kLeftOut;
  ordered_json document = hopper::plan_report_json(inputs.plan, result, seconds);
  if (robust) document["robust"] = robust_json(*robust);
  document["options"] = stated_json(*request.declared);
  return result_text(std::move(document), read_documents(inputs));
}

std::string hopper_flip_fingerprint(const HopperFlipRequest& request,
                                    const HopperFlipInputs& inputs) {
  return fingerprint("hopper flip", counted_json(*request.declared), read_documents(inputs));
}

std::string hopper_flip_sweep_json(const HopperFlipRequest& request, const HopperFlipInputs& inputs,
                                   const sweep::Swept& swept) {
  ordered_json document = sweep::swept_json(swept);
  document["options"] = counted_json(*request.declared);  // it states nothing elsewhere
  return result_text(std::move(document), read_documents(inputs));
}

}  // namespace torquewright::cli
