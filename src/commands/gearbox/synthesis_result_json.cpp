// SPDX-License-Identifier: Apache-2.0
#include "src/commands/gearbox/synthesis_result_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "gearbox/synthesis/synthesis_spec.hpp"
#include "src/commands/shared/result_json.hpp"

namespace torquewright::cli {

std::string synthesis_result_json(const OptimizeRequest& request, const ReadProblem& read,
                                  const gearbox::SynthesisResult& found, double seconds) {
  nlohmann::ordered_json result = gearbox::synthesis_json(read.problem, found);
  if (request.timing) result["search"]["seconds"] = seconds;
  result["problem"] = read.document.root;
  return result_text(std::move(result), {&read.document, 1});
}

}  // namespace torquewright::cli
