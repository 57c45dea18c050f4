// SPDX-License-Identifier: Apache-2.0
#include "gearbox/verification/claim_sentence_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "gearbox/topologies/topology.hpp"

namespace torquewright::gearbox {
namespace {

using Json = nlohmann::json;

std::string design_text(const Problem& problem, const Json& design) {
  std::vector<std::int64_t> teeth;
  for (const std::string_view gear : find_topology(problem.topology)->gears) {
    teeth.push_back(design["teeth"][std::string(gear)]);
  }
  return fmt::format("{} with {} planets, module {:g} mm", fmt::join(teeth, "/"),
                     design["planet_count"].get<std::int64_t>(), design["module_mm"].get<double>());
}

std::string objective_text(const Json& result) {
  const Json& claim = result["certificate"]["claims"][0];
  return fmt::format("{} {:.8g}", claim["quantity"].get<std::string>(),
                     result["designs"].back()["objective"].get<double>());
}

std::string optimum_sentence(const Problem& problem, const Json& result) {
  const Json& designs = result["designs"];
  const std::string first = design_text(problem, designs.front());
  if (result["certificate"]["claims"][0]["reference"].is_null()) {
    if (designs.size() == 1) return fmt::format("{} alone satisfies all constraints.", first);
    return fmt::format("No other design than these {} satisfies all constraints; {} is the best.",
                       designs.size(), first);
  }
  const std::string equals =
      result["ties"].empty()
          ? ""
          : fmt::format(" but the {} listed as equally good", result["ties"].size());
  if (designs.size() == 1) {
    return fmt::format(
        "{} is the best: no other design{} that satisfies all constraints reaches "
        "its {}.",
        first, equals, objective_text(result));
  }
  return fmt::format(
      "These {} designs are the best, {} first: no other{} that satisfies all "
      "constraints reaches the {} of the last of them.",
      designs.size(), first, equals, objective_text(result));
}

std::string infeasible_sentence(const Problem& problem, const Json& result) {
  std::vector<std::string> names;
  bool is_irreducible = true;
  for (const Json& member : result["conflict"]) {
    names.push_back(member["constraint"]);
    is_irreducible = is_irreducible && !member["without_it"].is_null();
  }
  const Json& limit = result["certificate"]["claims"][0]["ring_limit"];
  std::string sentence = "No design";
  if (limit.is_number()) {
    sentence += fmt::format(" with rings of up to {} teeth", limit.get<std::int64_t>());
  }
  sentence += fmt::format(" satisfies all of {}", fmt::join(names, ", "));
  sentence += is_irreducible ? "; without any one of them there is one." : ".";
  for (const Json& bound : result["would_be_feasible_with"]) {
    sentence += fmt::format(" {} = {} would do, and nothing tighter ({}).",
                            bound["key"].get<std::string>().substr(1), bound["needed"].dump(),
                            design_text(problem, bound["design"]));
  }
  return sentence;
}

std::string limit_sentence(const Problem& problem, const Json& result) {
  const Json& quantity = result["certificate"]["claims"][0]["quantity"];
  std::string sentence =
      "The search was ended: boxes are left open, so nothing is proved the best.";
  if (result["bound"].is_number()) {
    sentence += fmt::format(" No design that satisfies all constraints beats {} {:.8g}.",
                            quantity.get<std::string>(), result["bound"].get<double>());
  }
  if (!result["designs"].empty()) {
    sentence += fmt::format(" {} satisfies all constraints.",
                            design_text(problem, result["designs"].front()));
  }
  return sentence;
}

}  // namespace

std::string claim_sentence(const Problem& problem, const Json& result) {
  if (result["status"] == "optimal") return optimum_sentence(problem, result);
  if (result["status"] == "infeasible") return infeasible_sentence(problem, result);
  return limit_sentence(problem, result);
}

}  // namespace torquewright::gearbox
