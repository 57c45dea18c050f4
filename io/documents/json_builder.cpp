// SPDX-License-Identifier: Apache-2.0
#include "io/documents/json_builder.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/faults/syntax_fault.hpp"

namespace torquewright::io {
namespace {

/// Whole doubles below this are integers without doubt.
constexpr double kMaxWholeDouble = 9007199254740992.0;

bool has_nonzero_digit(std::string_view numeral) {
  const std::string_view mantissa = numeral.substr(0, numeral.find_first_of("eE"));
  return mantissa.find_first_of("123456789") != std::string_view::npos;
}

}  // namespace

bool JsonBuilder::number_unsigned(std::uint64_t value) {
  // Readers take whole numbers as std::int64_t; beyond it a number is a double like any larger one.
  if (std::in_range<std::int64_t>(value)) return add(static_cast<std::int64_t>(value));
  return add(static_cast<double>(value));
}

bool JsonBuilder::number_float(double value, const std::string& numeral) {
  if (value == 0 && has_nonzero_digit(numeral)) {
    report(path(), numeral.substr(0, 40) + " is too close to zero to be told from it");
  }
  if (std::trunc(value) == value && std::abs(value) <= kMaxWholeDouble) {
    return add(static_cast<std::int64_t>(value));
  }
  return add(value);
}

bool JsonBuilder::key(std::string& key) {
  keys_.back() = std::move(key);
  if (open_.back()->contains(keys_.back())) report(path(), "stands twice in its object; keep one");
  return true;
}

bool JsonBuilder::parse_error(std::size_t position, const std::string& last_token,
                              const nlohmann::json::exception& error) {
  const SyntaxFault fault = syntax_fault(text_, position, last_token, error);
  report(fault.is_at_value ? path() : "", fault.message);
  return false;
}

JsonText JsonBuilder::finish(bool complete) {
  return {std::move(root_), complete, std::move(faults_)};
}

bool JsonBuilder::add(nlohmann::json value) {
  place(std::move(value));
  return true;
}

bool JsonBuilder::open(nlohmann::json container) {
  if (open_.size() == kMaxDepth) {
    report("", "is nested deeper than " + std::to_string(kMaxDepth) + " levels");
    return false;
  }
  open_.push_back(place(std::move(container)));
  keys_.emplace_back();
  return true;
}

bool JsonBuilder::close() {
  open_.pop_back();
  keys_.pop_back();
  return true;
}

nlohmann::json* JsonBuilder::place(nlohmann::json value) {
  if (open_.empty()) {
    root_ = std::move(value);
    return &root_;
  }
  nlohmann::json& container = *open_.back();
  if (container.is_array()) {
    container.push_back(std::move(value));
    return &container.back();
  }
  nlohmann::json& member = container[keys_.back()];
  member = std::move(value);
  return &member;
}

std::string JsonBuilder::path() const {
  std::string path;
  for (std::size_t i = 0; i < open_.size(); ++i) {
    if (open_[i]->is_object()) {
      path = child_path(path, keys_[i]);
    } else {
      // A container in the list is already in it; a plain value has yet to be added.
      const bool holds_next = i + 1 < open_.size();
      path = child_path(path, std::to_string(open_[i]->size() - (holds_next ? 1 : 0)));
    }
  }
  return path;
}

void JsonBuilder::report(std::string path, std::string message) {
  faults_.push_back({file_, std::move(path), std::move(message)});
}

}  // namespace torquewright::io
