// SPDX-License-Identifier: Apache-2.0
#include "gearbox/verification/sized_verification_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "gearbox/any_topology.hpp"
#include "gearbox/problem_spec.hpp"
#include "gearbox/synthesis/floor_conflict.hpp"
#include "gearbox/synthesis/synthesis_spec.hpp"
#include "gearbox/verification/difference_json.hpp"
#include "gearbox/verification/input_check_json.hpp"
#include "gearbox/verification/sized_claims_json.hpp"
#include "gearbox/verification/sized_design_json.hpp"
#include "io/documents/document.hpp"
#include "io/documents/provenance.hpp"

namespace torquewright::gearbox {
namespace {

using Json = nlohmann::json;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

class SynthesisCheck {
 public:
  SynthesisCheck(const Problem& problem, const Json& result,
                 const std::function<bool()>& should_stop)
      : result_(result), chosen_(problem), asked_(problem), should_stop_(should_stop) {}

  Verification run() {
    read_asked();
    if (faults_.count() == 0) read_best();
    if (faults_.count() == 0) read_conflict();
    if (faults_.count() == 0) check_ = check_sized_claims(asked_, result_, should_stop_, faults_);
    Verification found;
    found.counts.nodes = check_.boxes;
    found.choices = 0;
    for (const auto& [topology, count] : check_.choices) *found.choices += count;
    found.is_ended = check_.is_ended;
    found.is_undecided = result_["status"] == "limit";
    found.is_proved = faults_.count() == 0 && !check_.is_ended;
    if (found.is_proved) judge_statements(found);
    found.faults = faults_.take();
    found.is_accepted = found.is_proved && found.faults.empty();
    if (!found.is_accepted) return found;
    found.claim = claim();
    found.checked.insert(found.checked.begin(),
                         "numbers and sentences are those of a fresh evaluation");
    return found;
  }

 private:
  /// What was asked where the result's problem is that of the topology that was chosen.
  void read_asked() {
    const Json& certificate = result_["certificate"];
    if (!certificate.contains("asked")) return;
    try {
      asked_root_ = certificate["asked"];
      asked_ = read_open_problem(
          io::check_document(asked_root_, "gearbox_problem", "the result", "/certificate/asked"));
    } catch (const io::SpecError& error) {
      faults_.add("/certificate/asked", error.what());
      return;
    }
    if (!asked_.synthesis || !is_topology_open(asked_) ||
        as_topology(asked_root_, train_parts(chosen_.topology)) != result_["problem"]) {
      faults_.add("/certificate/asked", "is not the problem of which /problem is a topology");
    }
  }

  const Json& asked_root() const {
    return asked_root_.is_null() ? result_["problem"] : asked_root_;
  }

  static std::array<double, 2> widths_of(const Problem& problem, const Json& design) {
    std::array<double, 2> widths{};
    const std::vector<std::string> layers = train_parts(problem.topology).layer_names();
    const Json stated = design.value("face_width_mm", Json::object());
    for (std::size_t i = 0; i < layers.size(); ++i) widths[i] = stated.value(layers[i], 0.0);
    return widths;
  }

  void read_best() {
    const Json& designs = result_["designs"];
    if (designs.empty()) return;
    if (designs.size() > 1 || is_topology_open(chosen_)) {
      faults_.add("/designs", "is not the one design of a topology");
      return;
    }
    const auto design = shifted_design(chosen_, designs[0], "/designs/0", faults_);
    if (!design) return;
    check_sized_design(chosen_, *design, widths_of(chosen_, designs[0]), "/designs/0", faults_);
    if (faults_.count() == 0) found_.best = sized_design(chosen_, *design);
  }

  /// Every member's design meets all that is in the conflict, but the member.
  void read_conflict() {
    const Json conflict = result_.value("conflict", Json::array());
    if (conflict.empty()) return;
    std::vector<std::string> others = demands_of(asked_);
    for (const Json& member : conflict) std::erase(others, member["constraint"]);
    Problem kept = asked_;
    for (const std::string& name : others) kept = without_demand(kept, name);
    found_.conflict.emplace();
    for (std::size_t i = 0; i < conflict.size(); ++i) read_member(kept, conflict[i], i);
  }

  void read_member(const Problem& kept, const Json& member, std::size_t number) {
    const std::string place = fmt::format("/conflict/{}/without_it", number);
    const std::string name = member["constraint"];
    const auto demands = demands_of(kept);
    if (std::count(demands.begin(), demands.end(), name) == 0) {
      faults_.add(fmt::format("/conflict/{}/constraint", number),
                  "is nothing that the problem demands");
      return;
    }
    const bool is_open = is_topology_open(asked_);
    const std::string topology = is_open ? member.value("topology", "") : asked_.topology;
    const TrainParts* parts = find_train_parts(topology);
    if (parts == nullptr || member["without_it"].is_null()) {
      faults_.add(place, "is no design of a topology");
      return;
    }
    const Problem own = as_topology(without_demand(kept, name), *parts);
    const auto design = shifted_design(own, member["without_it"], place, faults_);
    if (!design) return;
    const SizedDesign sized = sized_design(own, *design);
    check_sized_design(own, *design, sized.face_width_mm, place, faults_);
    if (faults_.count() == 0) {
      found_.conflict->push_back(conflict_member(asked_, name, sized));
    }
  }

  void judge_statements(Verification& found) {
    set_status();
    set_search();
    set_topologies();
    if (faults_.count() == 0) compare();
    const InputCheck input = check_input(result_, asked_root(), faults_);
    if (input.is_compared) found.checked.push_back(input.sentence);
    if (!input.is_compared && !input.sentence.empty()) found.unchecked.push_back(input.sentence);
    const std::string version = result_["tool"]["version"];
    if (version != io::tool_version()) {
      found.unchecked.push_back(
          fmt::format("the result is of version {}, this is {}", version, io::tool_version()));
    }
    found.unchecked.emplace_back(
        "how many boxes the search took, and why it closed choices without one: its claims are "
        "proved without them");
    if (!found_.topologies.empty()) {
      found.unchecked.emplace_back(
          "masses of other topologies than the best: their designs are not in the result");
    }
  }

  /// What bound and design together are.
  void set_status() {
    const Json& bound = result_["bound"];
    found_.bound_kg = bound.is_number() ? bound.get<double>() : 0.0;
    const double gap = io::nearest(asked_.synthesis->gap);
    if (result_["status"] == "infeasible") {
      found_.status = SynthesisStatus::kInfeasible;
      found_.bound_kg = kInfinite;
    } else if (found_.best &&
               found_.bound_kg >= found_.best->mass_kg * (1.0 - gap) * (1.0 - 1e-12)) {
      found_.status = SynthesisStatus::kOptimal;
    }
    if (found_.best && found_.bound_kg > found_.best->mass_kg * (1.0 + 1e-9)) {
      faults_.add("/bound", "is above what the design has");
    }
  }

  void set_search() {
    const Json& search = result_["search"];
    found_.boxes = search["nodes"];
    found_.opened = search.value("choices_opened", std::int64_t{0});
    for (const auto& [topology, count] : check_.choices) found_.choices += count;
    const Json excluded = search.value("excluded_by", Json::object());
    for (const auto& [name, count] : excluded.items()) found_.excluded_by[name] = count;
    std::int64_t sum = 0;
    for (const auto& [name, count] : found_.excluded_by) sum += count;
    const bool is_claimed = !result_["certificate"].value("sized_claims", Json::array()).empty();
    if (!is_claimed) found_.choices = search.value("choices", std::int64_t{0});
    if (found_.opened > found_.choices || sum > found_.opened) {
      faults_.add("/search", "counts more choices than there are");
    }
  }

  void set_topologies() {
    if (!is_topology_open(asked_)) return;
    for (const Json& each : result_.value("topologies", Json::array())) {
      found_.topologies.push_back(answer_of(each));
    }
  }

  TopologyAnswer answer_of(const Json& stated) const {
    TopologyAnswer answer;
    answer.topology = stated["topology"];
    answer.choices = stated["choices"];
    for (const Json& claim : result_["certificate"].value("sized_claims", Json::array())) {
      if (claim["topology"] != answer.topology) continue;
      answer.choices = claim["choices"];
      answer.bound_kg = claim["bound"].is_number() ? claim["bound"].get<double>() : kInfinite;
      if (claim["bound"].is_null()) answer.status = SynthesisStatus::kInfeasible;
    }
    const double gap = io::nearest(asked_.synthesis->gap);
    if (stated["objective"].is_number() && answer.status != SynthesisStatus::kInfeasible) {
      answer.mass_kg = stated["objective"].get<double>();
      if (answer.topology == chosen_.topology) answer.mass_kg = found_.best->mass_kg;
      if (answer.bound_kg >= *answer.mass_kg * (1.0 - gap) * (1.0 - 1e-12)) {
        answer.status = SynthesisStatus::kOptimal;
      }
    }
    return answer;
  }

  /// All that is said, from what is known.
  void compare() {
    Json expected = synthesis_json(asked_, found_);
    expected["certificate"] = result_["certificate"];
    for (const char* key : {"problem", "inputs"}) expected[key] = result_[key];
    expected["tool"] = io::tool_provenance();
    expected["tool"]["version"] = result_["tool"]["version"];
    if (result_.contains("options")) expected["options"] = result_["options"];
    if (result_["search"].contains("seconds")) {
      expected["search"]["seconds"] = result_["search"]["seconds"];
    }
    for (const char* key : {"held_fixed", "not_asked"}) {
      if (!result_.contains(key)) expected.erase(key);
    }
    keep_exclusions(expected);
    if (const auto difference = first_difference(result_, expected)) {
      faults_.add(difference->pointer, difference->sentence);
    }
  }

  /// A sentence may go on with why choices were closed, which is not checked.
  void keep_exclusions(Json& expected) const {
    if (!expected.contains("topologies")) return;
    const Json stated = result_.value("topologies", Json::array());
    for (std::size_t i = 0; i < std::min(stated.size(), expected["topologies"].size()); ++i) {
      Json& sentence = expected["topologies"][i]["sentence"];
      const std::string own = stated[i]["sentence"], start = sentence;
      if (own.starts_with(start + "; ")) sentence = own;
    }
  }

  std::string design_text() const {
    const Design& design = found_.best->design;
    return fmt::format("{} with {} planets, module {:g} mm", fmt::join(design.teeth, "/"),
                       design.planet_count, io::nearest(design.module_mm));
  }

  std::string claim() const {
    if (found_.status == SynthesisStatus::kInfeasible) {
      return "No design satisfies all constraints, whatever its shifts.";
    }
    const std::string bound =
        found_.bound_kg > 0.0
            ? fmt::format("nothing is lighter than {:.6g} g", 1e3 * found_.bound_kg)
            : "of a bound nothing is said";
    if (!found_.best) return fmt::format("No design is given; {}.", bound);
    return fmt::format("{} satisfies all constraints, bears the load and weighs {:.6g} g; {}.",
                       design_text(), 1e3 * found_.best->mass_kg, bound);
  }

  const Json& result_;
  const Problem& chosen_;  ///< The result's problem.
  Problem asked_;
  Json asked_root_;
  const std::function<bool()>& should_stop_;
  proof::Faults faults_;
  SizedCheck check_;
  SynthesisResult found_;
};

}  // namespace

Verification verify_synthesis(const Problem& problem, const Json& result,
                              const std::function<bool()>& should_stop) {
  return SynthesisCheck(problem, result, should_stop).run();
}

}  // namespace torquewright::gearbox
