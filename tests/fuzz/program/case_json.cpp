// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/case_json.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "io/files/file_bytes.hpp"

namespace torquewright::fuzz {
namespace {

using nlohmann::json;

const std::array<std::pair<Thing::Kind, const char*>, 6> kNames{{
    {Thing::Kind::kFile, "file"},
    {Thing::Kind::kReadOnlyFile, "read_only_file"},
    {Thing::Kind::kFolder, "folder"},
    {Thing::Kind::kPipe, "pipe"},
    {Thing::Kind::kLink, "link"},
    {Thing::Kind::kHardLink, "hard_link"},
}};

/// JSON holds text, and arguments hold bytes: each stands for the character of its number.
std::string as_text(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xC0 | (byte >> 6));
      text += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return text;
}

std::string as_bytes(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x80) {
      bytes += text[i];
      continue;
    }
    if (++i == text.size()) throw std::runtime_error("a character is cut off");
    bytes += static_cast<char>((byte << 6) | (static_cast<unsigned char>(text[i]) & 0x3F));
  }
  return bytes;
}

Thing::Kind kind_named(const std::string& name) {
  for (const auto& [kind, its_name] : kNames) {
    if (name == its_name) return kind;
  }
  throw std::runtime_error("no such thing: " + name);
}

std::string name_of(Thing::Kind kind) {
  for (const auto& [its_kind, name] : kNames) {
    if (kind == its_kind) return name;
  }
  throw std::logic_error("a kind without a name");
}

}  // namespace

std::string text_of(const Case& one) {
  json document{{"arguments", json::array()}, {"things", json::object()}};
  for (const std::string& word : one.arguments) document["arguments"].push_back(as_text(word));
  for (const auto& [path, thing] : one.things) {
    document["things"][as_text(path)] = {{name_of(thing.kind), as_text(thing.content)}};
  }
  return document.dump(1) + "\n";
}

Case case_of(const std::string& text) {
  const json document = json::parse(text);
  Case one;
  for (const json& word : document.at("arguments")) one.arguments.push_back(as_bytes(word));
  for (const auto& [path, thing] : document.at("things").items()) {
    const auto kind = thing.begin();
    one.things[as_bytes(path)] = {kind_named(kind.key()), as_bytes(kind.value())};
  }
  return one;
}

Case read_case(const std::filesystem::path& file) { return case_of(io::read_file_bytes(file)); }

}  // namespace torquewright::fuzz
