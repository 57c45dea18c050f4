// SPDX-License-Identifier: Apache-2.0
#include "tests/gearbox/proof/naive_proof.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace torquewright::gearbox::proof_test {
namespace {

class Builder {
 public:
  Builder(const PlainClaim& claim, const Choice& choice, const ProofStyle& style)
      : claim_(claim), choice_(choice), style_(style), random_(1) {
    for (const std::string& name : claim.hypotheses) add_conditions(name);
    if (!is_planetary(*claim.problem)) conditions_.push_back("positive_teeth");
    if (claim.ring_limit > 0) conditions_.push_back("rotor_bore");
    if (claim.reference && has_form(claim.quantity)) conditions_.push_back("quantity");
  }

  Json nodes() {
    PlainBox box = root_box(claim_, choice_);
    if (box.size() == 0) return Json::array();
    Json cuts = Json::array();
    if (style_.root_cuts) cut(box, cuts);
    grow(box, cuts);
    return nodes_;
  }

 private:
  static bool has_form(const std::string& quantity) {
    return quantity == "paper_cost" || quantity == "hollow_shaft" ||
           quantity == "ring_pitch_diameter_mm" || quantity.rfind("teeth.", 0) == 0;
  }

  void add_conditions(const std::string& hypothesis) {
    if (hypothesis == "ratio") {
      conditions_.push_back("ratio_max");
      conditions_.push_back("ratio_min");
      return;
    }
    for (const char* prefix :
         {"equal_spacing", "identical_planets", "interference", "contact_ratio", "root_form"}) {
      if (hypothesis.rfind(prefix, 0) == 0) return;
    }
    conditions_.push_back(hypothesis);
  }

  /// d - phi and phi - d themselves for the ratio, which are monotone; else the concave forms.
  double slack(const std::string& condition, const PlainBox& box,
               const std::array<double, 3>& x) const {
    const bool upper = condition == "ratio_max";
    if ((!upper && condition != "ratio_min") || is_planetary(*claim_.problem)) {
      return concave_form(condition, claim_, choice_, box, x);
    }
    const double t = number(claim_.problem->ratio_tolerance);
    const double g = number(claim_.problem->target_ratio) * (upper ? 1 + t : 1 - t);
    const double phi = 2 * x[1] * (x[0] + 2 * x[1]) / (g * x[0] + 2 * x[1]);
    return upper ? x[2] - phi : phi - x[2];
  }

  /// Least cost over the ranges of its terms.
  bool costs_too_much(const PlainBox& box) const {
    const Choice own = choice_of(*claim_.reference, *claim_.problem);
    const double threshold = quantity("paper_cost", own, claim_.reference->gears);
    const auto real = [](long v) { return static_cast<double>(v); };
    const auto [s, p, d] = box.lower;
    const double second = std::max(1.0, real(p - box.upper[2]));
    const double output = real(s + p) + second;
    return real(p * p) + second * second + output * output > threshold * (1 + 1e-9);
  }

  bool refutes(const std::string& condition, const PlainBox& box) const {
    if (condition == "quantity" && claim_.quantity == "paper_cost") return costs_too_much(box);
    for (int corner = 0; corner < 8; ++corner) {
      std::array<double, 3> x;
      for (std::size_t i = 0; i < 3; ++i) {
        x[i] = static_cast<double>(((corner >> i) & 1) != 0 ? box.upper[i] : box.lower[i]);
      }
      if (slack(condition, box, x) > -1e-9) return false;
    }
    return true;
  }

  void cut(PlainBox& box, Json& cuts) const {
    const auto names = variables(*claim_.problem);
    for (const std::string& condition : conditions_) {
      for (std::size_t i = 0; i < names.size(); ++i) {
        cut_side(box, cuts, condition, names[i], i, true);
        cut_side(box, cuts, condition, names[i], i, false);
      }
    }
  }

  void cut_side(PlainBox& box, Json& cuts, const std::string& condition, const std::string& name,
                std::size_t variable, bool is_upper) const {
    long value = is_upper ? box.upper[variable] : box.lower[variable];
    const long start = value;
    while (box.lower[variable] < box.upper[variable]) {
      PlainBox slab = box;
      (is_upper ? slab.lower : slab.upper)[variable] = value;
      if (!refutes(condition, slab)) break;
      value += is_upper ? -1 : 1;
      (is_upper ? box.upper : box.lower)[variable] = value;
    }
    if (value != start) cuts.push_back({condition, name, is_upper ? "max" : "min", value});
  }

  void close(Json node, const Json& cuts) {
    if (!cuts.empty()) node["cuts"] = cuts;
    nodes_.push_back(std::move(node));
  }

  void grow(const PlainBox& box, const Json& cuts) {
    for (const std::string& condition : conditions_) {
      if (refutes(condition, box)) return close({{"closed", "empty"}, {"by", condition}}, cuts);
    }
    if (box.size() <= style_.leaf_points) return close({{"closed", "enumerated"}}, cuts);
    if (style_.relaxations && relax(box, cuts)) return;
    std::size_t widest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (box.upper[i] - box.lower[i] > box.upper[widest] - box.lower[widest]) widest = i;
    }
    const long middle = (box.lower[widest] + box.upper[widest]) / 2;
    close({{"split", {variables(*claim_.problem)[widest], middle}}}, cuts);
    PlainBox first = box, second = box;
    first.upper[widest] = middle;
    second.lower[widest] = middle + 1;
    grow(first, Json::array());
    grow(second, Json::array());
  }

  bool relax(const PlainBox& box, const Json& cuts) {
    std::array<double, 3> y;
    for (std::size_t i = 0; i < 3; ++i) {
      y[i] = static_cast<double>(box.lower[i] + box.upper[i]) / 2;
    }
    for (int trial = 0; trial < 300; ++trial) {
      std::map<std::string, double> multipliers;
      for (const std::string& condition : conditions_) {
        if (random_() % 3 == 0) multipliers[condition] = draw(condition);
      }
      if (greatest(box, y, multipliers) > -1e-3) continue;
      Json point;
      const auto names = variables(*claim_.problem);
      for (std::size_t i = 0; i < names.size(); ++i) point[names[i]] = y[i];
      close({{"closed", "relaxation"}, {"point", point}, {"multipliers", multipliers}}, cuts);
      return true;
    }
    return false;
  }

  double draw(const std::string& condition) {
    const double weight = 0.0625 * static_cast<double>(1 + random_() % 64);
    return condition == "quantity" && claim_.quantity == "paper_cost" ? weight / 64 : weight;
  }

  /// Of the linearisation over the box, by central differences.
  double greatest(const PlainBox& box, const std::array<double, 3>& y,
                  const std::map<std::string, double>& multipliers) const {
    const auto sum = [&](const std::array<double, 3>& x) {
      double value = 0;
      for (const auto& [name, weight] : multipliers) {
        value += weight * concave_form(name, claim_, choice_, box, x);
      }
      return value;
    };
    double result = sum(y);
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<double, 3> ahead = y, behind = y;
      ahead[i] += 1e-4;
      behind[i] -= 1e-4;
      const double slope = (sum(ahead) - sum(behind)) / 2e-4;
      result += std::max(slope * (static_cast<double>(box.lower[i]) - y[i]),
                         slope * (static_cast<double>(box.upper[i]) - y[i]));
    }
    return multipliers.empty() ? 0 : result;
  }

  const PlainClaim& claim_;
  const Choice& choice_;
  const ProofStyle& style_;
  std::mt19937 random_;
  std::vector<std::string> conditions_;
  Json nodes_ = Json::array();
};

}  // namespace

Json naive_alternatives(const PlainClaim& claim, const ProofStyle& style) {
  Json alternatives = Json::array();
  for (const std::int64_t count : claim.problem->planet_count) {
    for (const Rational& module_mm : claim.problem->module_mm) {
      const Choice choice{claim.problem, count, number(module_mm)};
      alternatives.push_back({{"planet_count", count},
                              {"module_mm", number(module_mm)},
                              {"nodes", Builder(claim, choice, style).nodes()}});
    }
  }
  return alternatives;
}

Json naive_claim(const PlainClaim& claim, const ProofStyle& style) {
  Json json{{"kind", claim.kind}, {"constraints", claim.hypotheses}};
  json["quantity"] = claim.quantity.empty() ? Json() : Json(claim.quantity);
  json["reference"] = claim.reference ? design_json(*claim.reference, *claim.problem) : Json();
  if (!claim.key.empty()) json["key"] = claim.key;
  json["ring_limit"] = claim.ring_limit > 0 ? Json(claim.ring_limit) : Json();
  json["alternatives"] = naive_alternatives(claim, style);
  return json;
}

}  // namespace torquewright::gearbox::proof_test
