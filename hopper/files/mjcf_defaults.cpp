// SPDX-License-Identifier: Apache-2.0
#include "hopper/files/mjcf_defaults.hpp"

#include "hopper/files/xml.hpp"

namespace torquewright::hopper {

using tinyxml2::XMLElement;

JointDefaults::JointDefaults(const XMLElement& mujoco) {
  for (const XMLElement* element : children(mujoco, "default")) {
    gather(*element, classes_[""], true);
  }
}

void JointDefaults::gather(const XMLElement& element, Attributes inherited, bool is_main) {
  for (const XMLElement* joint : children(element, "joint")) {
    for (const auto* next = joint->FirstAttribute(); next != nullptr; next = next->Next()) {
      inherited[next->Name()] = next->Value();
    }
  }
  if (is_main) classes_[""] = inherited;
  classes_[attribute(element, "class")] = inherited;
  for (const XMLElement* nested : children(element, "default")) gather(*nested, inherited, false);
}

const XMLElement& JointDefaults::completed(const XMLElement& joint, const std::string& childclass) {
  const std::string own = attribute(joint, "class");
  const auto found = classes_.find(own.empty() ? childclass : own);
  // A copy of the element keeps the line for messages.
  XMLElement* copy = joint.ShallowClone(&completed_)->ToElement();
  completed_.InsertEndChild(copy);
  if (found == classes_.end()) return *copy;
  for (const auto& [name, value] : found->second) {
    if (copy->Attribute(name.c_str()) == nullptr) copy->SetAttribute(name.c_str(), value.c_str());
  }
  return *copy;
}

}  // namespace torquewright::hopper
