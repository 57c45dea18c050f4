// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::hopper {

/// An attribute where it stands in a file's text.
struct SourceAttribute {
  std::string name;
  std::string value;      ///< As written, entities and all.
  std::size_t begin = 0;  ///< Of the value, behind its quotation mark.
  std::size_t end = 0;
};

/// A start tag where it stands in a file's text.
struct SourceElement {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::string name;
  std::vector<SourceAttribute> attributes;
  std::size_t parent = kNone;  ///< Its place among the elements.
  std::size_t begin = 0;       ///< Of its "<".
  std::size_t tag_end = 0;     ///< Behind its ">".
  bool is_empty = false;       ///< It ends in "/>".

  const SourceAttribute* find(std::string_view attribute) const;
  /// "" where it is absent.
  std::string value(std::string_view attribute) const;
  /// Where a further attribute would stand: behind the last, or behind the name.
  std::size_t attributes_end() const;
};

/// All elements of a text in its order: what stands in comments, CDATA and declarations is none.
/// Requires well-formed XML, as read_element() lets pass.
std::vector<SourceElement> elements_of(const std::string& text);

/// What takes the place of a part of a text.
struct TextEdit {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string text;
};

/// The text with the edits in it, which lie apart; every other byte stays.
std::string edited(const std::string& text, std::vector<TextEdit> edits);

/// Sets an attribute of an element: in the place of its value, or behind its last attribute.
TextEdit set_attribute(const SourceElement& element, const std::string& name,
                       const std::string& value);

}  // namespace torquewright::hopper
