// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/tree/node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace torquewright::gearbox::proof {
namespace {

constexpr std::int64_t kMostPointsOfLeaf = 4096;

std::string written(const Point& point, const Problem& problem) {
  std::string text;
  for (std::size_t i = 0; i < train_of(problem).variables.size(); ++i) {
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", train_of(problem).variables[i], point[i]);
  }
  return text;
}

std::vector<Box> split(Node& node, const Json& json) {
  ++node.account.counts.splits;
  if (!json.is_array() || json.size() != 2) {
    node.fault("/split", "is not [variable, value]");
    return {};
  }
  const auto variable = read_variable(node, "/split/0", &json[0]);
  if (!variable) return {};
  const auto value = whole_number(&json[1]);
  if (!value || *value < node.box.lower[*variable] || *value >= node.box.upper[*variable]) {
    node.fault("/split/1", "leaves one side of the split empty");
    return {};
  }
  Box first = node.box;
  Box second = node.box;
  first.upper[*variable] = *value;
  second.lower[*variable] = *value + 1;
  return {second, first};
}

void close_empty(Node& node, const Json& json, const std::string& last_cut) {
  ++node.account.counts.empty_leaves;
  check_keys(json, {"cuts", "closed", "by"}, node.place, node.account.faults);
  const auto condition = read_condition(node, "/by", member(json, "by"));
  if (!condition) return;
  if (node.box.is_empty()) {
    if (text(member(json, "by")) != last_cut) {
      node.fault("/by", fmt::format("is not the condition of the last cut, {}", last_cut));
    }
    return;
  }
  if (!refutes(node.claim, node.alternative, *condition, node.box, node.account.budget)) {
    node.fault("/by", "does not refute the whole box");
  }
}

void enumerate(Node& node, const Json& json) {
  ++node.account.counts.enumerated_leaves;
  check_keys(json, {"cuts", "closed"}, node.place, node.account.faults);
  if (node.box.size_up_to(kMostPointsOfLeaf) > kMostPointsOfLeaf) {
    node.fault("/closed", fmt::format("has more than {} points", kMostPointsOfLeaf));
    return;
  }
  for_each_point(node.box, [&](const Point& point) {
    ++node.account.counts.enumerated_points;
    if (!node.account.budget.spend()) return false;
    if (allows(node.claim, node.alternative, point)) return true;
    node.fault("/closed", fmt::format("holds {}, which the claim denies",
                                      written(point, *node.alternative.problem)));
    return false;
  });
}

void leave_open(Node& node, const Json& json) {
  ++node.account.counts.open_leaves;
  check_keys(json, {"cuts", "closed"}, node.place, node.account.faults);
  if (!node.claim.may_be_open) {
    node.fault("/closed", "is open, which only a result of status limit may hold");
  } else if (node.claim.open_bound &&
             !respects_bound(node.claim, node.alternative, *node.claim.open_bound, node.box,
                             node.account.budget)) {
    node.fault("/closed", "is open, and the bound is not shown to hold in it");
  }
}

void close(Node& node, const Json& json, const std::string& last_cut) {
  const auto how = text(member(json, "closed"));
  if (how == "empty") {
    close_empty(node, json, last_cut);
  } else if (node.box.is_empty()) {
    node.fault("/closed", "is not \"empty\", but the cuts left nothing of the box");
  } else if (how == "enumerated") {
    enumerate(node, json);
  } else if (how == "relaxation") {
    check_relaxation_leaf(node, json);
  } else if (how == "open") {
    leave_open(node, json);
  } else {
    node.fault("/closed", "is not one of empty, enumerated, relaxation, open");
  }
}

}  // namespace

std::optional<Condition> read_condition(const Node& node, const std::string& key,
                                        const Json* name) {
  const auto named = text(name);
  auto condition = named ? find_condition(node.claim, *named) : std::nullopt;
  if (!condition) node.fault(key, "is no condition of this claim that is judged on boxes");
  return condition;
}

std::optional<std::size_t> read_variable(const Node& node, const std::string& key,
                                         const Json* name) {
  const auto& names = node.alternative.train->variables;
  const auto named = text(name);
  const auto found = named ? std::find(names.begin(), names.end(), *named) : names.end();
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  node.fault(key, "is no variable of this problem");
  return std::nullopt;
}

std::vector<Box> check_node(Node& node, const Json& json) {
  ++node.account.counts.nodes;
  const std::size_t faults_before = node.account.faults.count();
  std::string last_cut;
  if (const Json* cuts = member(json, "cuts")) last_cut = apply_cuts(node, *cuts);
  if (node.account.faults.count() != faults_before) return {};

  const Json* division = member(json, "split");
  const Json* closing = member(json, "closed");
  if ((division == nullptr) == (closing == nullptr)) {
    node.fault("", "is not exactly one of split and closed");
    return {};
  }
  std::vector<Box> children;
  if (division != nullptr) {
    check_keys(json, {"cuts", "split"}, node.place, node.account.faults);
    children = split(node, *division);
  } else {
    close(node, json, last_cut);
  }
  if (node.account.budget.is_exhausted()) {
    node.fault("", "comes after more work than a checker should do");
  }
  return children;
}

}  // namespace torquewright::gearbox::proof
