// SPDX-License-Identifier: Apache-2.0
#include "tests/gearbox/verification/real_result.hpp"

#include <fstream>

#include "gearbox/problem_spec.hpp"
#include "gearbox/search/result_spec.hpp"
#include "gearbox/search/search.hpp"
#include "gearbox/strength/problem_strength.hpp"
#include "io/documents/document.hpp"
#include "io/documents/provenance.hpp"

namespace torquewright::gearbox::verification_test {
namespace {

DesignSearchOptions options_from(const Json& json) {
  DesignSearchOptions options;
  options.top = json.value("top", options.top);
  options.max_nodes = json.value("max_nodes", options.max_nodes);
  const std::string use = json.value("relaxation", "auto");
  if (use == "always") options.relaxation = optimization::RelaxationUse::kAlways;
  if (use == "never") options.relaxation = optimization::RelaxationUse::kNever;
  return options;
}

}  // namespace

Json problem_with(const std::string& name, const Json& changes) {
  std::ifstream file(std::string(TORQUEWRIGHT_SOURCE_DIR) + "/specs/gearbox/" + name + ".json");
  Json problem = Json::parse(file);
  problem.merge_patch(changes);
  return problem;
}

Json knee_with(const Json& changes) { return problem_with("d151_knee", changes); }

Json real_result(const test::ScratchFolder& folder, const Json& problem, const Json& options) {
  const auto file = folder.write("problem.json", problem.dump());
  const io::Document document = io::read_document(file, "gearbox_problem");
  const Problem read = read_problem(document);
  const DesignSearchResult found = optimize(read, options_from(options));
  nlohmann::ordered_json result = result_json(read, found);
  result["held_fixed"] = held_fixed(read);
  result["not_asked"] = not_asked(read, found.designs);
  result["problem"] = document.root;
  result["tool"] = io::tool_provenance();
  result["inputs"] = io::input_provenance({&document, 1});
  result["options"] = options;
  return Json::parse(result.dump());
}

Verification verified(const Json& result) {
  try {
    const io::Document document = io::check_document(result, "gearbox_result", "result", "");
    return verify(problem_of(document.root), document.root);
  } catch (const io::SpecError& error) {
    Verification refused;
    refused.faults = {error.what()};
    return refused;
  }
}

Problem problem_of(const Json& result) {
  return read_problem(
      io::check_document(result["problem"], "gearbox_problem", "result", "/problem"));
}

}  // namespace torquewright::gearbox::verification_test
