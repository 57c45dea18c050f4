// SPDX-License-Identifier: Apache-2.0
#include "src/commands/actuator/actuator_lint_json.hpp"

#include <nlohmann/json.hpp>

#include "actuator/lint/report_spec.hpp"
#include "actuator/winding/winding_estimate_json.hpp"
#include "src/commands/shared/result_json.hpp"

namespace torquewright::cli {

std::string lint_document(const actuator::lint::Report& report,
                          const std::optional<actuator::WindingEstimate>& winding,
                          std::span<const io::Document> documents) {
  nlohmann::ordered_json json = actuator::lint::report_json(report);
  if (winding) json["winding"] = actuator::winding_json(*winding);
  return result_text(std::move(json), documents);
}

}  // namespace torquewright::cli
