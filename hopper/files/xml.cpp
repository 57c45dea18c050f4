// SPDX-License-Identifier: Apache-2.0
#include "hopper/files/xml.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "io/file_bytes.hpp"

namespace torquewright::hopper {
namespace {

using tinyxml2::XMLElement;

constexpr double kGreatest = 1e9;  // no number of a robot comes near

/// Numbers between spaces; nothing if anything else stands there.
std::optional<std::vector<double>> parsed(std::string_view text) {
  std::vector<double> found;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (;;) {
    while (at != end && std::string_view(" \t\r\n").find(*at) != std::string_view::npos) ++at;
    if (at == end) return found;
    if (*at == '+') ++at;
    double value = 0;
    const auto [rest, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !(std::abs(value) <= kGreatest)) return std::nullopt;
    found.push_back(value);
    at = rest;
  }
}

}  // namespace

Xml::Xml(const std::filesystem::path& file, const std::string& root_name)
    : file_(file.string()), document_(std::make_unique<tinyxml2::XMLDocument>()) {
  const std::string bytes = io::read_file_bytes(file);
  if (document_->Parse(bytes.data(), bytes.size()) != tinyxml2::XML_SUCCESS) {
    throw io::SpecError({{file_, "",
                          fmt::format("line {}: is no XML that can be read ({})",
                                      document_->ErrorLineNum(), document_->ErrorName())}});
  }
  const XMLElement* found = document_->RootElement();
  if (found == nullptr || found->Name() != root_name) {
    throw io::SpecError({{file_, "",
                          fmt::format("must hold <{}>, not <{}>", root_name,
                                      found == nullptr ? "" : found->Name())}});
  }
  look_for_references(*document_);
}

void Xml::look_for_references(const tinyxml2::XMLNode& node) {
  for (const auto* child = node.FirstChild(); child != nullptr; child = child->NextSibling()) {
    if (child->ToUnknown() != nullptr) {
      faults_.push_back({file_, "",
                         fmt::format("line {}: a DOCTYPE or another declaration is not "
                                     "read, nor are entities; expand them first",
                                     child->GetLineNum())});
    }
    const XMLElement* element = child->ToElement();
    if (element == nullptr) continue;
    const std::string_view name = element->Name();
    if (name == "include") report(*element, "other files are not followed; put its content here");
    if (name.starts_with("xacro:")) report(*element, "macros are not expanded; run xacro first");
    look_for_references(*element);
  }
}

void Xml::report(const XMLElement& element, const std::string& message) {
  const std::string name = attribute(element, "name");
  faults_.push_back({file_, "",
                     fmt::format("line {}, <{}{}>: {}", element.GetLineNum(), element.Name(),
                                 name.empty() ? "" : fmt::format(" name=\"{}\"", name), message)});
}

void Xml::refuse_faults() {
  if (!faults_.empty()) throw io::SpecError(faults_);
}

std::optional<std::vector<double>> Xml::numbers(const XMLElement& element, const char* name,
                                                std::size_t count) {
  const char* text = element.Attribute(name);
  if (text == nullptr) return std::nullopt;
  auto found = parsed(text);
  if (found && found->size() == count) return found;
  report(element, fmt::format("{}=\"{}\" must be {} number{} of at most 1e9", name, text, count,
                              count == 1 ? "" : "s"));
  return std::nullopt;
}

double Xml::number(const XMLElement& element, const char* name, double otherwise) {
  const auto found = numbers(element, name, 1);
  return found ? found->front() : otherwise;
}

Eigen::Vector3d Xml::vector(const XMLElement& element, const char* name,
                            const Eigen::Vector3d& otherwise) {
  const auto found = numbers(element, name, 3);
  return found ? Eigen::Vector3d(found->data()) : otherwise;
}

std::string Xml::needed(const XMLElement& element, const char* name) {
  const std::string found = attribute(element, name);
  if (found.empty()) report(element, fmt::format("{} is missing", name));
  return found;
}

std::vector<const XMLElement*> children(const XMLElement& element, const char* name) {
  std::vector<const XMLElement*> found;
  for (const auto* child = element.FirstChildElement(name); child != nullptr;
       child = child->NextSiblingElement(name)) {
    found.push_back(child);
  }
  return found;
}

std::string attribute(const XMLElement& element, const char* name) {
  const char* text = element.Attribute(name);
  return text == nullptr ? "" : text;
}

}  // namespace torquewright::hopper
