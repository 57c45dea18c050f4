// SPDX-License-Identifier: Apache-2.0
#include "robot/xml/xml_source.hpp"

#include <algorithm>

namespace torquewright::hopper {
namespace {

constexpr const char* kBlanks = " \t\r\n";
constexpr const char* kNameEnds = " \t\r\n/>=";

/// What is no element, and how it ends.
struct Skipped {
  std::string_view begin, end;
};
constexpr Skipped kSkipped[] = {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}};

/// Reads start tags one after another.
class Scanner {
 public:
  explicit Scanner(const std::string& text) : text_(text) {}

  std::vector<SourceElement> run() {
    for (std::size_t at = text_.find('<'); at != std::string::npos; at = text_.find('<', at)) {
      at = read_at(at);
      if (at == std::string::npos) break;
    }
    return std::move(elements_);
  }

 private:
  /// Returns where it goes on.
  std::size_t read_at(std::size_t at) {
    for (const Skipped& skipped : kSkipped) {
      if (text_.compare(at, skipped.begin.size(), skipped.begin) != 0) continue;
      const std::size_t end = text_.find(skipped.end, at + skipped.begin.size());
      return end == std::string::npos ? end : end + skipped.end.size();
    }
    if (text_.compare(at, 2, "</") == 0) {
      if (!open_.empty()) open_.pop_back();
      return text_.find('>', at);
    }
    return read_tag(at);
  }

  std::size_t read_tag(std::size_t at) {
    SourceElement element;
    element.begin = at;
    std::size_t end = std::min(text_.find_first_of(kNameEnds, at), text_.size());
    element.name = text_.substr(at + 1, end - at - 1);
    while (true) {
      const std::size_t next = text_.find_first_not_of(kBlanks, end);
      if (next == std::string::npos) return next;
      if (text_[next] == '>' || text_[next] == '/') {
        element.is_empty = text_[next] == '/';
        element.tag_end = text_.find('>', next) + 1;
        break;
      }
      end = read_attribute(next, element);
      if (end == std::string::npos) return end;
    }
    if (!open_.empty()) element.parent = open_.back();
    if (!element.is_empty) open_.push_back(elements_.size());
    elements_.push_back(std::move(element));
    return elements_.back().tag_end;
  }

  /// Returns where it ends, behind its quotation mark.
  std::size_t read_attribute(std::size_t at, SourceElement& element) {
    const std::size_t open = text_.find_first_of("\"'", at);
    if (open == std::string::npos) return open;
    const std::size_t close = text_.find(text_[open], open + 1);
    if (close == std::string::npos) return close;
    const std::size_t name_end = text_.find_first_of(kNameEnds, at);
    element.attributes.push_back({text_.substr(at, name_end - at),
                                  text_.substr(open + 1, close - open - 1), open + 1, close});
    return close + 1;
  }

  const std::string& text_;
  std::vector<SourceElement> elements_;
  std::vector<std::size_t> open_;
};

}  // namespace

const SourceAttribute* SourceElement::find(std::string_view attribute) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const auto& each) { return each.name == attribute; });
  return found == attributes.end() ? nullptr : &*found;
}

std::string SourceElement::value(std::string_view attribute) const {
  const SourceAttribute* found = find(attribute);
  return found == nullptr ? "" : found->value;
}

std::size_t SourceElement::attributes_end() const {
  return attributes.empty() ? begin + 1 + name.size() : attributes.back().end + 1;
}

std::vector<SourceElement> elements_of(const std::string& text) { return Scanner(text).run(); }

std::string edited(const std::string& text, std::vector<TextEdit> edits) {
  std::stable_sort(edits.begin(), edits.end(), [](const TextEdit& one, const TextEdit& other) {
    return one.begin < other.begin;
  });
  std::string result;
  std::size_t at = 0;
  for (const TextEdit& edit : edits) {
    result += text.substr(at, edit.begin - at) + edit.text;
    at = edit.end;
  }
  return result + text.substr(at);
}

TextEdit set_attribute(const SourceElement& element, const std::string& name,
                       const std::string& value) {
  if (const SourceAttribute* there = element.find(name)) return {there->begin, there->end, value};
  const std::size_t place = element.attributes_end();
  return {place, place, " " + name + "=\"" + value + "\""};
}

}  // namespace torquewright::hopper
