// SPDX-License-Identifier: Apache-2.0
#include "gearbox/verification/sized_claims_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "gearbox/any_topology.hpp"
#include "gearbox/sized_proof/sized_proof.hpp"
#include "gearbox/sized_proof/whole_choices.hpp"
#include "gearbox/synthesis/floor_conflict.hpp"

namespace torquewright::gearbox {
namespace {

using Json = nlohmann::json;

std::vector<std::string> topologies_of(const Problem& asked) {
  if (!is_topology_open(asked)) return {asked.topology};
  std::vector<std::string> names;
  for (const TrainParts& parts : all_train_parts()) names.emplace_back(parts.name);
  return names;
}

std::string choice_text(const Problem& problem, const sized::WholeNumbers& whole) {
  return fmt::format("{} with {} planets, module {:g} mm",
                     fmt::join(sized::teeth_in_order(train_parts(problem.topology), whole), "/"),
                     whole.planets, io::nearest(whole.module_mm[0]));
}

class ClaimsCheck {
 public:
  ClaimsCheck(const Problem& asked, const Json& result, const std::function<bool()>& should_stop,
              proof::Faults& faults)
      : asked_(asked), result_(result), faults_(faults) {
    effort_.should_stop = should_stop;
  }

  SizedCheck run() {
    const std::size_t before = faults_.count();
    for (std::size_t i = 0; i < claims().size(); ++i) check_form(claims()[i], place(i));
    check_support();
    if (faults_.count() != before) return std::move(check_);
    for (std::size_t i = 0; i < claims().size() && !effort_.is_ended; ++i) {
      prove(claims()[i], place(i));
    }
    check_.boxes = effort_.boxes;
    check_.is_ended = effort_.is_ended;
    return std::move(check_);
  }

 private:
  const Json& claims() const {
    static const Json kNone = Json::array();
    const Json& certificate = result_["certificate"];
    const auto found = certificate.find("sized_claims");
    return found == certificate.end() ? kNone : *found;
  }
  static std::string place(std::size_t claim) {
    return fmt::format("/certificate/sized_claims/{}", claim);
  }

  void check_form(const Json& claim, const std::string& where) {
    const auto known = topologies_of(asked_);
    if (std::count(known.begin(), known.end(), claim["topology"]) == 0) {
      faults_.add(where + "/topology", "is none that the problem asks for");
    }
    if (claim["quantity"] != objective_name(asked_.objective)) {
      faults_.add(where + "/quantity", "is not the problem's objective");
    }
    if (claim["bound"].is_number() && claim.contains("left_out")) {
      faults_.add(where + "/left_out", "goes with a claim that there is no design only");
    }
    const auto demands = demands_of(asked_);
    for (const Json& name : claim.value("left_out", Json::array())) {
      if (std::count(demands.begin(), demands.end(), name) == 0) {
        faults_.add(where + "/left_out", "names what the problem does not demand");
      }
    }
  }

  /// The claim about a topology; null where there is none, or more than one.
  const Json* claim_about(const std::string& topology) const {
    const Json* found = nullptr;
    for (const Json& claim : claims()) {
      if (claim["topology"] != topology) continue;
      if (found != nullptr) return nullptr;
      found = &claim;
    }
    return found;
  }

  /// One claim about each topology, as strong as what is said.
  void check_support() {
    const bool is_none = result_["status"] == "infeasible";
    const Json& bound = result_["bound"];
    if (!is_none && !bound.is_number()) {
      if (result_["status"] == "optimal") faults_.add("/bound", "is missing");
      return;
    }
    for (const std::string& topology : topologies_of(asked_)) {
      const Json* claim = claim_about(topology);
      if (claim == nullptr) {
        faults_.add("/certificate/sized_claims",
                    fmt::format("holds not one claim about the topology {}", topology));
        continue;
      }
      const Json& own = (*claim)["bound"];
      if (is_none && !own.is_null()) {
        faults_.add("/status", fmt::format("is not what is claimed of the topology {}", topology));
      }
      if (is_none) check_conflict(*claim);
      if (!is_none && own.is_number() && bound.get<double>() > own.get<double>()) {
        faults_.add("/bound", fmt::format("is above that of the topology {}", topology));
      }
    }
  }

  /// What is in the conflict is not left out, and all else is.
  void check_conflict(const Json& claim) {
    const Json conflict = result_.value("conflict", Json::array());
    const Json left_out = claim.value("left_out", Json::array());
    for (const std::string& demand : demands_of(asked_)) {
      const bool is_member = std::any_of(conflict.begin(), conflict.end(), [&](const Json& each) {
        return each["constraint"] == demand;
      });
      const bool is_left_out = std::count(left_out.begin(), left_out.end(), demand) > 0;
      if (is_member ? is_left_out : !is_left_out && !conflict.empty()) {
        faults_.add("/conflict", fmt::format("is not what is claimed: {} is {}", demand,
                                             is_left_out ? "left out" : "not left out"));
      }
    }
  }

  Problem problem_of(const Json& claim) const {
    Problem problem = asked_;
    for (const Json& name : claim.value("left_out", Json::array())) {
      problem = without_demand(problem, name);
    }
    return as_topology(problem, train_parts(claim["topology"].get<std::string>()));
  }

  void prove(const Json& claim, const std::string& where) {
    const Problem problem = problem_of(claim);
    const Json& bound = claim["bound"];
    const sized::SizedProof proof = sized::prove_lightest(
        problem, bound.is_number() ? bound.get<double>() : std::numeric_limits<double>::infinity(),
        effort_);
    if (effort_.is_ended) return;
    if (!proof.holds) {
      faults_.add(where + "/bound", fmt::format("is not proved: of {} it cannot be shown",
                                                choice_text(problem, *proof.open)));
      return;
    }
    const std::int64_t choices =
        claim.value("left_out", Json::array()).empty() ? proof.choices : count(problem.topology);
    check_.choices[problem.topology] = choices;
    if (claim["choices"] != choices) {
      faults_.add(where + "/choices", fmt::format("is not {}", choices));
    }
  }

  /// With all that is demanded: what a claim leaves out may admit more.
  std::int64_t count(const std::string& topology) const {
    std::int64_t number = 0;
    sized::for_each_choice(as_topology(asked_, train_parts(topology)),
                           [&](const sized::WholeNumbers&) {
                             ++number;
                             return true;
                           });
    return number;
  }

  const Problem& asked_;
  const Json& result_;
  proof::Faults& faults_;
  sized::ProofEffort effort_;
  SizedCheck check_;
};

}  // namespace

SizedCheck check_sized_claims(const Problem& asked, const Json& result,
                              const std::function<bool()>& should_stop, proof::Faults& faults) {
  return ClaimsCheck(asked, result, should_stop, faults).run();
}

}  // namespace torquewright::gearbox
