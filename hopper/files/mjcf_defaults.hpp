// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include <map>
#include <string>

namespace torquewright::hopper {

/// What MJCF's <default> classes say of joints: an attribute that a joint leaves out is that of its
/// class (its own, or the nearest childclass around it), or of a class around that one.
class JointDefaults {
 public:
  explicit JointDefaults(const tinyxml2::XMLElement& mujoco);

  /// The joint with every attribute that its classes give it; owned by this object.
  const tinyxml2::XMLElement& completed(const tinyxml2::XMLElement& joint,
                                        const std::string& childclass);

 private:
  using Attributes = std::map<std::string, std::string>;
  void gather(const tinyxml2::XMLElement& element, Attributes inherited, bool is_main);

  std::map<std::string, Attributes> classes_;  // "" is the main one
  tinyxml2::XMLDocument completed_;
};

}  // namespace torquewright::hopper
