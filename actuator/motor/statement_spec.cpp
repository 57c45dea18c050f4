// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/statement_spec.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace torquewright::actuator {
namespace {

CurrentConvention convention_of_ampere(const std::string& word) {
  if (word == "peak") return CurrentConvention::kPeakPhase;
  return word == "rms" ? CurrentConvention::kRmsPhase : CurrentConvention::kDc;
}

}  // namespace

double read_stated(const nlohmann::json& value, std::string pointer,
                   std::vector<Statement>& statements) {
  if (value.is_number()) return value;
  Statement statement;
  statement.pointer = std::move(pointer);
  statement.printed = value["value"];
  if (value.contains("side")) statement.at_joint = value["side"] == "joint";
  if (value.contains("ampere")) statement.ampere = convention_of_ampere(value["ampere"]);
  if (value.contains("bound")) {
    statement.bound = value["bound"] == "at_least" ? Bound::kAtLeast : Bound::kAtMost;
  }
  if (value.contains("tolerance")) statement.tolerance = value["tolerance"].get<double>();
  if (value.contains("also")) {
    statement.also = value["also"].get<std::vector<double>>();
    double widest = statement.tolerance.value_or(0.0);
    for (const double other : statement.also) {
      widest = std::max(widest, std::abs(other / statement.printed - 1.0));
    }
    statement.tolerance = widest;
  }
  statements.push_back(std::move(statement));
  return statements.back().printed;
}

namespace {

void collect_bounds(const nlohmann::json& value, const std::string& pointer,
                    std::vector<std::string>& pointers) {
  if (!value.is_object()) return;
  if (value.contains("value") && value.contains("bound")) pointers.push_back(pointer);
  for (const auto& [key, child] : value.items()) {
    collect_bounds(child, pointer + "/" + key, pointers);
  }
}

}  // namespace

std::vector<std::string> taken_at_their_bounds(const nlohmann::json& root) {
  std::vector<std::string> pointers;
  for (const char* block : {"mass_kg", "motor", "drive", "envelope"}) {
    if (root.contains(block)) collect_bounds(root[block], std::string("/") + block, pointers);
  }
  return pointers;
}

}  // namespace torquewright::actuator
