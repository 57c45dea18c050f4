// SPDX-License-Identifier: Apache-2.0
#include "robot/xml/element.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>

#include "io/faults/spec_error.hpp"
#include "io/files/file_bytes.hpp"
#include "robot/xml/xml_encoding.hpp"

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

/// Far more than any element has. The parser compares each attribute with all before it.
constexpr std::size_t kMostAttributes = 1000;

/// Past the next `end`, or at the end of the text.
std::size_t past(std::string_view text, std::string_view end, std::size_t from) {
  const std::size_t found = text.find(end, from);
  return found == std::string_view::npos ? text.size() : found + end.size();
}

/// Refuses an element of very many attributes before it is parsed.
void check_attribute_counts(std::string_view text, const std::string& file) {
  std::size_t at = 0;
  while ((at = text.find('<', at)) != std::string_view::npos) {
    if (text.substr(at, 4) == "<!--") {
      at = past(text, "-->", at);
      continue;
    }
    if (text.substr(at, 9) == "<![CDATA[") {
      at = past(text, "]]>", at);
      continue;
    }
    const std::size_t start = at++;
    std::size_t count = 0;
    while (at < text.size() && text[at] != '>') {
      const char character = text[at++];
      if (character == '=') ++count;
      if (character == '"' || character == '\'') at = past(text, {&character, 1}, at);
    }
    if (count <= kMostAttributes) continue;
    const auto line = std::count(text.begin(), text.begin() + static_cast<long>(start), '\n') + 1;
    refuse(file, fmt::format("line {}: an element with {} attributes; at most {} are read", line,
                             count, kMostAttributes));
  }
}

void check_encoding(const tinyxml2::XMLDocument& document, std::string_view text,
                    const std::string& file) {
  const tinyxml2::XMLNode* first = document.FirstChild();
  const bool declares = first != nullptr && first->ToDeclaration() != nullptr;
  const auto objection =
      encoding_objection(text, declares ? declared_encoding(first->Value()) : "");
  if (objection) refuse(file, *objection);
}

/// The one element of the file that is in no other.
const tinyxml2::XMLElement& only_root(const tinyxml2::XMLDocument& document,
                                      const std::string& file) {
  const tinyxml2::XMLElement* root = document.RootElement();
  if (root == nullptr) refuse(file, "holds no XML element");
  const tinyxml2::XMLElement* second = root->NextSiblingElement();
  if (second == nullptr) return *root;
  refuse(file, fmt::format("line {}: <{}> follows <{}> of line {}; a file holds one of them, "
                           "which all else is in",
                           second->GetLineNum(), second->Name(), root->Name(), root->GetLineNum()));
}

Element copied(const tinyxml2::XMLElement& element, const Name& file) {
  refuse_declarations(element, *file);
  Element copy{element.Name(), {}, {}, file, element.GetLineNum()};
  if (const char* text = element.GetText(); text != nullptr) copy.text = text;
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

bool is_blank(std::string_view name) {
  return name.find_first_not_of(" \t\r\n") == std::string_view::npos;
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
  check_attribute_counts(bytes, *name);
  tinyxml2::XMLDocument document;
  if (document.Parse(bytes.data(), bytes.size()) != tinyxml2::XML_SUCCESS) {
    refuse(*name, fmt::format("line {}: is no XML that can be read ({})", document.ErrorLineNum(),
                              document.ErrorName()));
  }
  refuse_declarations(document, *name);
  check_encoding(document, bytes, *name);
  return copied(only_root(document, *name), name);
}

}  // namespace torquewright::hopper
