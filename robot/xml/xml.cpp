// SPDX-License-Identifier: Apache-2.0
#include "robot/xml/xml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace torquewright::hopper {
namespace {

constexpr double kGreatest = 1e9;  // no number of a robot comes near

/// Numbers between spaces; nothing if anything else stands there. What is too small for a double is
/// zero.
std::optional<std::vector<double>> parsed(std::string_view text, double greatest = kGreatest) {
  std::vector<double> found;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (;;) {
    while (at != end && std::string_view(" \t\r\n").find(*at) != std::string_view::npos) ++at;
    if (at == end) return found;
    if (*at == '+') ++at;
    double value = 0;
    const auto [rest, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !(std::abs(value) <= greatest)) return std::nullopt;
    found.push_back(value);
    at = rest;
  }
}

std::string counted(std::size_t least, std::size_t most) {
  const std::string count =
      least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most);
  return fmt::format("{} number{}", count, most == 1 ? "" : "s");
}

}  // namespace

void Faults::report(const Element& element, const std::string& message) {
  const std::string name = attribute(element, "name");
  const std::string sentence =
      fmt::format("line {}, <{}{}>: {}", element.line, element.name,
                  name.empty() ? "" : fmt::format(" name=\"{}\"", name), message);
  if (known_.insert({*element.file, sentence}).second) {
    faults_.push_back({*element.file, "", sentence});
  }
}

void Faults::refuse() const {
  if (!faults_.empty()) throw io::SpecError(faults_);
}

std::optional<std::vector<double>> Faults::numbers(const Element& element, const char* name,
                                                   std::size_t least, std::size_t most) {
  const std::string* text = find_attribute(element, name);
  if (text == nullptr) return std::nullopt;
  auto found = parsed(*text);
  if (found && found->size() >= least && found->size() <= most) return found;
  report(element,
         fmt::format("{}=\"{}\" must be {} of at most 1e9", name, *text, counted(least, most)));
  return std::nullopt;
}

double Faults::number(const Element& element, const char* name, double otherwise) {
  const auto found = numbers(element, name, 1);
  return found ? found->front() : otherwise;
}

std::optional<double> Faults::limit(const Element& element, const char* name) {
  const std::string* text = find_attribute(element, name);
  if (text == nullptr) return std::nullopt;
  const auto found = parsed(*text, std::numeric_limits<double>::infinity());
  if (found && found->size() == 1) return found->front();
  report(element, fmt::format("{}=\"{}\" must be 1 number, or inf", name, *text));
  return std::nullopt;
}

Eigen::Vector3d Faults::vector(const Element& element, const char* name,
                               const Eigen::Vector3d& otherwise) {
  const auto found = numbers(element, name, 3);
  return found ? Eigen::Vector3d(found->data()) : otherwise;
}

const Element* Faults::only_child(const Element& element, const char* name) {
  const auto found = children(element, name);
  for (std::size_t i = 1; i < found.size(); ++i) {
    report(*found[i],
           fmt::format("stands in <{}> for the second time (first in line {}); one of them counts: "
                       "leave out the other",
                       element.name, found.front()->line));
  }
  return found.empty() ? nullptr : found.front();
}

std::string Faults::needed(const Element& element, const char* name) {
  const std::string found = attribute(element, name);
  if (found.empty()) report(element, fmt::format("{} is missing", name));
  return found;
}

std::string Faults::one_of(const Element& element, const char* name,
                           const std::vector<std::string>& allowed) {
  const std::string* found = find_attribute(element, name);
  if (found == nullptr) return allowed.front();
  if (std::find(allowed.begin(), allowed.end(), *found) != allowed.end()) return *found;
  report(element,
         fmt::format("{}=\"{}\" must be one of {}", name, *found, fmt::join(allowed, ", ")));
  return allowed.front();
}

Element read_root(const std::filesystem::path& file, const std::string& name) {
  Element root = read_element(file);
  if (root.name == name) return root;
  std::string advice;
  if (root.name == "robot") advice = ": URDF, which --format urdf reads";
  if (root.name == "mujoco") advice = ": MJCF, which --format mjcf reads";
  throw io::SpecError(
      {{file.string(), "", fmt::format("must hold <{}>, not <{}>{}", name, root.name, advice)}});
}

}  // namespace torquewright::hopper
