// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/faults/spec_error.hpp"
#include "robot/xml/element.hpp"

namespace torquewright::hopper {

/// The faults found in an XML file, and its numbers.
class Faults {
 public:
  /// Once, however often what is wrong is read.
  void report(const Element& element, const std::string& message);
  /// io::SpecError with all faults reported, if there are any.
  void refuse() const;

  /// The numbers of an attribute, at least and at most so many; a fault, and nothing, if it holds
  /// others. Nothing where it is absent.
  std::optional<std::vector<double>> numbers(const Element& element, const char* attribute,
                                             std::size_t least, std::size_t most);
  std::optional<std::vector<double>> numbers(const Element& element, const char* attribute,
                                             std::size_t count) {
    return numbers(element, attribute, count, count);
  }
  double number(const Element& element, const char* attribute, double otherwise);
  /// A limit may be infinite, and greater than any other number of a robot.
  std::optional<double> limit(const Element& element, const char* attribute);
  Eigen::Vector3d vector(const Element& element, const char* attribute,
                         const Eigen::Vector3d& otherwise);
  /// The child of that name, null if there is none; a fault if there are several, of which all but
  /// one would not count.
  const Element* only_child(const Element& element, const char* name);
  /// A fault and "" where it is absent.
  std::string needed(const Element& element, const char* attribute);
  /// The attribute, which must be one of these; the first where it is absent.
  std::string one_of(const Element& element, const char* attribute,
                     const std::vector<std::string>& allowed);

 private:
  std::vector<io::Fault> faults_;
  std::set<std::pair<std::string, std::string>> known_;  ///< Files and sentences.
};

/// The file's root element; a fault if it is not called so.
Element read_root(const std::filesystem::path& file, const std::string& name);

}  // namespace torquewright::hopper
