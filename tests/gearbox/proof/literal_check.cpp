// SPDX-License-Identifier: Apache-2.0
#include "tests/gearbox/proof/literal_check.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::gearbox::proof_test {
namespace {

template <typename Judge>
bool everywhere(const PlainBox& box, Judge judge) {
  for (long s = box.lower[0]; s <= box.upper[0]; ++s) {
    for (long p = box.lower[1]; p <= box.upper[1]; ++p) {
      for (long d = box.lower[2]; d <= box.upper[2]; ++d) {
        if (!judge(PlainPoint{s, p, d})) return false;
      }
    }
  }
  return true;
}

class Walker {
 public:
  Walker(const PlainClaim& claim, const Choice& choice) : claim_(claim), choice_(choice) {}

  bool walk(const Json& nodes) {
    std::vector<PlainBox> pending{root_box(claim_, choice_)};
    if (pending.back().size() == 0) return nodes.empty();
    for (const Json& node : nodes) {
      if (pending.empty()) return false;
      PlainBox box = pending.back();
      pending.pop_back();
      for (const Json& cut : node.value("cuts", Json::array())) {
        if (!apply(cut, box)) return false;
      }
      if (node.contains("split")) {
        const std::size_t i = index(node["split"][0]);
        PlainBox first = box, second = box;
        first.upper[i] = node["split"][1];
        second.lower[i] = node["split"][1].get<long>() + 1;
        if (first.size() == 0 || second.size() == 0) return false;
        pending.push_back(second);
        pending.push_back(first);
      } else if (!closes(node, box)) {
        return false;
      }
    }
    return pending.empty();
  }

 private:
  std::size_t index(const std::string& name) const {
    const auto names = variables(*claim_.problem);
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  }

  bool apply(const Json& cut, PlainBox& box) const {
    const std::size_t i = index(cut[1]);
    PlainBox slab = box;
    if (cut[2] == "max") {
      slab.lower[i] = cut[3].get<long>() + 1;
      box.upper[i] = cut[3];
    } else {
      slab.upper[i] = cut[3].get<long>() - 1;
      box.lower[i] = cut[3];
    }
    return slab.size() > 0 && fails(cut[0], slab);
  }

  bool fails(const std::string& condition, const PlainBox& box) const {
    return everywhere(box, [&](const PlainPoint& point) { return fails(condition, point); });
  }

  bool fails(const std::string& condition, const PlainPoint& point) const {
    const Gears g = gears_at(point);
    if (g.second < 1) return true;  // no design
    const Problem& problem = *claim_.problem;
    const double target = number(problem.target_ratio), t = number(problem.ratio_tolerance);
    if (condition == "positive_teeth") return false;
    if (condition == "ratio_max") return ratio(choice_, g) > target * (1 + t) * (1 + 1e-13);
    if (condition == "ratio_min") return ratio(choice_, g) < target * (1 - t) * (1 - 1e-13);
    if (condition == "quantity") {
      // Efficiencies and inertia are bounded for designs within the ratio's range.
      return against_reference(claim_, choice_, g) < 0 || !holds("ratio", choice_, g);
    }
    if (condition == "rotor_bore" && claim_.ring_limit > 0) {
      return g.sun + 2 * g.first > claim_.ring_limit;
    }
    return !holds(condition, choice_, g);
  }

  bool respects_bound(const PlainPoint& point) const {
    PlainClaim unbeaten = claim_;
    unbeaten.reference.reset();
    unbeaten.listed.clear();
    if (!claim_.bound || allowed(unbeaten, choice_, point)) return claim_.bound.has_value();
    const double value = quantity(claim_.quantity, choice_, gears_at(point));
    const double margin = 1e-11 * std::abs(*claim_.bound);
    return greater_is_better(claim_.quantity) ? value <= *claim_.bound + margin
                                              : value >= *claim_.bound - margin;
  }

  bool closes(const Json& node, const PlainBox& box) const {
    const std::string how = node["closed"];
    if (how == "empty") return box.size() == 0 || fails(node["by"], box);
    if (how == "enumerated") {
      return everywhere(box,
                        [&](const PlainPoint& point) { return allowed(claim_, choice_, point); });
    }
    if (how == "open") {
      return everywhere(box, [&](const PlainPoint& point) { return respects_bound(point); });
    }
    // Whatever the multipliers are, the conditions that have one exclude each point together.
    return how == "relaxation" && everywhere(box, [&](const PlainPoint& point) {
             for (const auto& [condition, weight] : node["multipliers"].items()) {
               if (weight > 0 && fails(condition, point)) return true;
             }
             return false;
           });
  }

  const PlainClaim& claim_;
  const Choice& choice_;
};

}  // namespace

bool is_literally_proved(const PlainClaim& claim, const Choice& choice, const Json& nodes) {
  return Walker(claim, choice).walk(nodes);
}

}  // namespace torquewright::gearbox::proof_test
