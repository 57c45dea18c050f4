// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/xml/xml.hpp"

namespace torquewright::hopper {

/// What a word of a format is to us.
enum class Meaning {
  kRead,     ///< It is understood.
  kNeutral,  ///< It changes neither mass nor kinematics nor forces: left behind.
  kForce,    ///< A force that no robot document holds: left behind, and said where.
  kRefused,  ///< It changes mass or kinematics, and is not read.
};

/// What becomes of a word that no list names.
enum class Unlisted {
  kRefused,  ///< The format has a strict schema: it might mean anything.
  kIgnored,  ///< The format's readers skip what it does not define: left behind, counted and said.
};

/// Words of one meaning: attributes that elements may have or children that they may hold, all
/// names between spaces.
struct Words {
  std::string_view elements;
  enum class Kind { kAttributes, kChildren } kind;
  Meaning meaning;
  std::string_view names;
  std::string_view advice = {};  ///< For what is refused.
};

/// Lists places in one line; long lists say how many more there are.
std::string listed(std::vector<std::string> places);

/// Compares elements with a list of words, and keeps what was left behind.
class Vocabulary {
 public:
  /// `left`: names of elements and attributes that are left behind even where they are refused.
  Vocabulary(std::span<const Words> words, Unlisted unlisted, const std::vector<std::string>& left,
             Faults& faults)
      : words_(words), unlisted_(unlisted), left_(left.begin(), left.end()), faults_(&faults) {}

  /// Attributes and children of the element, not what is inside these. Attributes that say nothing
  /// ("0", "false") are neutral.
  void check(const Element& element);
  /// The same of a part of them.
  void check_attributes(const Element& element);

  /// What was left behind, each once, in sentences.
  std::vector<std::string> notes() const;

 private:
  void check_word(const Element& element, Words::Kind kind, const std::string& name,
                  const Element& place);
  const Words* find(std::string_view element, Words::Kind kind, std::string_view name) const;

  void refuse(const Element& place, const std::string& name, const std::string& word,
              const std::string& why);
  std::vector<std::string> notes_of_left() const;

  std::span<const Words> words_;
  Unlisted unlisted_;
  std::set<std::string> left_;  ///< Asked for.
  Faults* faults_;
  std::set<std::string> neutral_;
  std::map<std::string, std::map<std::string, int>> found_left_;  ///< How often, by name and word.
  std::map<std::string, int> ignored_;                            ///< How often, by what.
  std::map<std::string, std::vector<std::string>> forces_;        ///< Where, by what.
  std::set<std::pair<std::string, std::string>> places_;          ///< What and where, of these.
};

}  // namespace torquewright::hopper
