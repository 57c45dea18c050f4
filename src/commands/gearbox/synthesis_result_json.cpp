// SPDX-License-Identifier: Apache-2.0
#include "src/commands/gearbox/synthesis_result_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "gearbox/any_topology.hpp"
#include "gearbox/problem_spec.hpp"
#include "gearbox/synthesis/synthesis_spec.hpp"
#include "src/commands/shared/result_json.hpp"

namespace torquewright::cli {

std::string synthesis_result_json(const OptimizeRequest& request, const ReadProblem& read,
                                  const gearbox::SynthesisResult& found, double seconds) {
  nlohmann::ordered_json result = gearbox::synthesis_json(read.problem, found);
  if (request.timing) result["search"]["seconds"] = seconds;
  const bool is_chosen = gearbox::is_topology_open(read.problem) && found.best;
  // As the topology that was chosen has it, for whoever reads the design; claims are about the
  // problem as it was asked.
  if (is_chosen) result["certificate"]["asked"] = read.document.root;
  result["problem"] = is_chosen
                          ? gearbox::as_topology(read.document.root,
                                                 gearbox::train_parts(found.best->problem.topology))
                          : read.document.root;
  return result_text(std::move(result), {&read.document, 1});
}

}  // namespace torquewright::cli
