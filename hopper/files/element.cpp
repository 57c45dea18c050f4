// SPDX-License-Identifier: Apache-2.0
#include "hopper/files/element.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include "io/file_bytes.hpp"
#include "io/spec_error.hpp"

namespace torquewright::hopper {
namespace {

using Name = std::shared_ptr<const std::string>;

[[noreturn]] void refuse(const std::string& file, const std::string& message) {
  throw io::SpecError({{file, "", message}});
}

void refuse_declarations(const tinyxml2::XMLNode& node, const std::string& file) {
  for (const auto* next = node.FirstChild(); next != nullptr; next = next->NextSibling()) {
    if (next->ToUnknown() == nullptr) continue;
    refuse(file, fmt::format("line {}: a DOCTYPE or another declaration is not read, nor are "
                             "entities; expand them first",
                             next->GetLineNum()));
  }
}

Element copied(const tinyxml2::XMLElement& element, const Name& file) {
  refuse_declarations(element, *file);
  Element copy{element.Name(), {}, {}, file, element.GetLineNum()};
  for (const auto* next = element.FirstAttribute(); next != nullptr; next = next->Next()) {
    copy.attributes.emplace_back(next->Name(), next->Value());
  }
  for (const auto* next = element.FirstChildElement(); next != nullptr;
       next = next->NextSiblingElement()) {
    copy.children.push_back(copied(*next, file));
  }
  return copy;
}

}  // namespace

const std::string* find_attribute(const Element& element, std::string_view name) {
  for (const auto& [key, value] : element.attributes) {
    if (key == name) return &value;
  }
  return nullptr;
}

std::string attribute(const Element& element, std::string_view name) {
  const std::string* found = find_attribute(element, name);
  return found == nullptr ? "" : *found;
}

std::vector<const Element*> children(const Element& element, std::string_view name) {
  std::vector<const Element*> found;
  for (const Element& next : element.children) {
    if (next.name == name) found.push_back(&next);
  }
  return found;
}

const Element* child(const Element& element, std::string_view name) {
  for (const Element& next : element.children) {
    if (next.name == name) return &next;
  }
  return nullptr;
}

Element read_element(const std::filesystem::path& file) {
  const auto name = std::make_shared<const std::string>(file.string());
  const std::string bytes = io::read_file_bytes(file);
  tinyxml2::XMLDocument document;
  if (document.Parse(bytes.data(), bytes.size()) != tinyxml2::XML_SUCCESS) {
    refuse(*name, fmt::format("line {}: is no XML that can be read ({})", document.ErrorLineNum(),
                              document.ErrorName()));
  }
  refuse_declarations(document, *name);
  if (document.RootElement() == nullptr) refuse(*name, "holds no XML element");
  return copied(*document.RootElement(), name);
}

}  // namespace torquewright::hopper
