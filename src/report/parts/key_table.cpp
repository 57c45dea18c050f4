// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/key_table.hpp"

#include <fmt/format.h>

#include "io/documents/published_schema.hpp"

namespace torquewright::report {
namespace {

using io::SchemaKey;

/// "a number from 0.5 to 2000 V; required"
std::string conditions(const SchemaKey& key) {
  std::string text = key.allowed;
  if (!key.unit.empty()) text += (text.empty() ? "in " : "; in ") + key.unit;
  if (key.is_required) text += text.empty() ? "required" : "; required";
  return text;
}

std::string title_line(std::string_view kind, const io::KindOfDocument& described) {
  return fmt::format("{}: {}\n", kind, described.title);
}

std::string rows(const std::vector<SchemaKey>& keys) {
  std::string text;
  for (const SchemaKey& key : keys) {
    text += fmt::format("\n{}  ({})\n    {}\n", key.pointer, conditions(key), key.meaning);
  }
  return text;
}

/// A cell of a table in Markdown: no bar ends it, no asterisk or underscore sets it in italics.
std::string cell(const std::string& text) {
  std::string cell;
  for (const char letter : text) {
    if (std::string_view("|*_<>").find(letter) != std::string_view::npos) cell += '\\';
    cell += letter;
  }
  return cell;
}

std::string start_of_page(std::string_view kind, const io::KindOfDocument& described) {
  std::string page = fmt::format("# `{}`\n\n{}.\n", kind, cell(described.title));
  if (!described.description.empty()) page += fmt::format("\n{}\n", cell(described.description));
  return page + fmt::format("\n<!-- Written by `torquewright schema {} --markdown`. -->\n", kind);
}

}  // namespace

std::string key_table_text(std::string_view kind) {
  const io::KindOfDocument described = io::describe_kind(kind);
  return title_line(kind, described) + rows(described.keys);
}

std::string key_table_text(std::string_view kind, const std::string& document) {
  const io::KindOfDocument described = io::describe_kind(kind);
  const std::vector<SchemaKey> standing = io::keys_in(document, described.keys);
  std::string text = title_line(kind, described) + rows(standing);
  if (standing.size() == described.keys.size()) return text;
  return text + fmt::format(
                    "\n{} more keys may stand there, none of which it needs:\n"
                    "torquewright init {} --all-keys --explain\n",
                    described.keys.size() - standing.size(), kind);
}

std::string key_table_markdown(std::string_view kind) {
  const io::KindOfDocument described = io::describe_kind(kind);
  std::string page = start_of_page(kind, described);
  if (const std::string example = io::document_to_start_from(kind); !example.empty()) {
    page += fmt::format("\n`torquewright init {} --all-keys` prints:\n\n", kind);
    page += "```json\n" + example + "```\n";
  }
  page +=
      "\n`*` stands for each entry of a list, or for any key. Required keys, in bold, must stand "
      "where the object that they belong to stands.\n\n"
      "| key | allowed | unit | meaning |\n|---|---|---|---|\n";
  for (const SchemaKey& key : described.keys) {
    const std::string_view mark = key.is_required ? "**" : "";
    page += fmt::format("| {0}`{1}`{0} | {2} | {3} | {4} |\n", mark, key.pointer, cell(key.allowed),
                        cell(key.unit), cell(key.meaning));
  }
  return page;
}

}  // namespace torquewright::report
