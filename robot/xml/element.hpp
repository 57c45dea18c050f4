// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace torquewright::hopper {

/// An XML element as read, and where it stands.
struct Element {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<Element> children;
  std::shared_ptr<const std::string> file;
  int line = 0;
  std::string text = {};  ///< Before its first child.
};

/// Null where it is absent.
const std::string* find_attribute(const Element& element, std::string_view name);
/// "" where it is absent.
std::string attribute(const Element& element, std::string_view name);

/// Whether a name has no letter that one sees.
bool is_blank(std::string_view name);

/// Children of that name, in order.
std::vector<const Element*> children(const Element& element, std::string_view name);
/// The first of them; null if there is none.
const Element* child(const Element& element, std::string_view name);

/// The file's root element. Entities that a DOCTYPE declares are never followed: a DOCTYPE is an
/// error. Throws io::SpecError if it cannot be read or is no XML.
Element read_element(const std::filesystem::path& file);

}  // namespace torquewright::hopper
