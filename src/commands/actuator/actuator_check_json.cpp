// SPDX-License-Identifier: Apache-2.0
#include "src/commands/actuator/actuator_check_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "actuator/drive_check/check_report_spec.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/commands/shared/stated_json.hpp"

namespace torquewright::cli {
std::string actuator_check_json(const CheckOptions& options, const ActuatorCheckInputs& inputs,
                                const actuator::CheckReport& report) {
  nlohmann::ordered_json document = actuator::check_report_json(report);
  document["options"] = stated_json(*options.declared);
  std::vector<io::Document> read{{options.trajectory_file, "", {}, report.sha256}};
  read.insert(read.end(), inputs.documents.begin(), inputs.documents.end());
  return result_text(std::move(document), read);
}

}  // namespace torquewright::cli
