// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/spec_error.hpp"

namespace torquewright::hopper {

/// An XML file as read, and the faults found in it. Entities that a DOCTYPE declares and files that
/// elements name are never followed; a DOCTYPE, an include and a macro are faults.
class Xml {
 public:
  /// io::SpecError if it cannot be read, is no XML, or its root is not called so.
  Xml(const std::filesystem::path& file, const std::string& root_name);

  const tinyxml2::XMLElement& root() const { return *document_->RootElement(); }
  void report(const tinyxml2::XMLElement& element, const std::string& message);
  /// io::SpecError with all faults reported, if there are any.
  void refuse_faults();

  /// The numbers of an attribute, which must be so many; a fault, and nothing, if it holds others.
  /// Nothing where it is absent.
  std::optional<std::vector<double>> numbers(const tinyxml2::XMLElement& element,
                                             const char* attribute, std::size_t count);
  double number(const tinyxml2::XMLElement& element, const char* attribute, double otherwise);
  Eigen::Vector3d vector(const tinyxml2::XMLElement& element, const char* attribute,
                         const Eigen::Vector3d& otherwise);
  /// A fault and "" where it is absent.
  std::string needed(const tinyxml2::XMLElement& element, const char* attribute);

 private:
  void look_for_references(const tinyxml2::XMLNode& node);

  std::string file_;
  std::unique_ptr<tinyxml2::XMLDocument> document_;
  std::vector<io::Fault> faults_;
};

/// Children of that name, in order.
std::vector<const tinyxml2::XMLElement*> children(const tinyxml2::XMLElement& element,
                                                  const char* name);
std::string attribute(const tinyxml2::XMLElement& element, const char* name);

}  // namespace torquewright::hopper
