// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "robot/xml/xml.hpp"

namespace torquewright::hopper {

/// What MJCF's <default> classes say of each kind of element: an attribute that an element leaves
/// out is that of its class (its own, or the nearest childclass around it), or of a class around
/// that one.
class MjcfDefaults {
 public:
  MjcfDefaults(const Element& mujoco, Faults& faults);

  /// The element with every attribute that its classes give it. All kinds of actuators share
  /// theirs. A fault where the class is not known.
  Element completed(const Element& element, const std::string& childclass) const;

 private:
  using Attributes = std::map<std::string, std::string>;
  using Kinds = std::map<std::string, Attributes>;  ///< By the element's name.
  void gather(const Element& element, Kinds inherited, bool is_main);

  std::map<std::string, Kinds> classes_;  ///< "" is the main one.
  Faults* faults_;
};

/// Every kind that drives is "actuator", both kinds of tendons are "tendon"; else the element's own
/// name.
std::string kind_of_default(const std::string& element);

}  // namespace torquewright::hopper
