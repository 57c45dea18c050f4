// SPDX-License-Identifier: Apache-2.0
#include "src/commands/planning/hopper_flip_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "hopper/planning/search/plan_report_spec.hpp"
#include "src/commands/actuator/check_options_json.hpp"
#include "src/commands/shared/fingerprint_json.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/options/hopper_flip_options.hpp"
#include "src/sweep/swept_json.hpp"

namespace torquewright::cli {
namespace {

using nlohmann::ordered_json;

/// What was asked for beyond the files and what the report states itself, where it is not the
/// default.
ordered_json request_json(const HopperFlipRequest& request) {
  ordered_json json =
      check_options_json(request.warm.columns, request.warm.window, request.warm.operating);
  for (const HopperFlipOption& option : hopper_flip_options()) {
    const std::optional<StatedValue> stated = option.stated(request);
    if (option.key.empty() || !stated) continue;
    std::visit([&](const auto& value) { json[option.key] = value; }, *stated);
  }
  return json;
}

/// The same of a sweep, whose document states nothing of it elsewhere.
ordered_json sweep_request_json(const HopperFlipRequest& request) {
  ordered_json json{{"task", request.task}, {"limits", request.limits}};
  json.update(request_json(request));
  return json;
}

std::vector<io::Document> read_documents(const HopperFlipInputs& inputs) {
  std::vector<io::Document> read = inputs.robot.documents;
  if (inputs.warm) read.push_back({inputs.warm->file, "", {}, inputs.warm->sha256});
  read.insert(read.end(), inputs.columns.begin(), inputs.columns.end());
  return read;
}

}  // namespace

std::string hopper_flip_json(const HopperFlipRequest& request, const HopperFlipInputs& inputs,
                             const hopper::PlanResult& result) {
  const auto seconds =
      request.timing ? hopper::PlanSeconds::kStated : hopper::PlanSeconds::kLeftOut;
  ordered_json document = hopper::plan_report_json(inputs.plan, result, seconds);
  document["options"] = request_json(request);
  return result_text(std::move(document), read_documents(inputs));
}

std::string hopper_flip_fingerprint(const HopperFlipRequest& request,
                                    const HopperFlipInputs& inputs) {
  return fingerprint("hopper flip", sweep_request_json(request), read_documents(inputs));
}

std::string hopper_flip_sweep_json(const HopperFlipRequest& request, const HopperFlipInputs& inputs,
                                   const sweep::Swept& swept) {
  ordered_json document = sweep::swept_json(swept);
  document["options"] = sweep_request_json(request);
  return result_text(std::move(document), read_documents(inputs));
}

}  // namespace torquewright::cli
