// SPDX-License-Identifier: Apache-2.0
#include "io/documents/document.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/documents/json_reader.hpp"
#include "io/documents/read_notes.hpp"
#include "io/documents/schema.hpp"
#include "io/documents/stated_units.hpp"
#include "io/faults/diagnosis.hpp"
#include "io/files/file_bytes.hpp"
#include "io/files/sha256.hpp"
#include "io/text/letter_case.hpp"
#include "io/text/one_line.hpp"
#include "io/text/wording.hpp"

namespace torquewright::io {
namespace {

using nlohmann::json;

/// Only a document built in memory can hold one; a file cannot say it.
void find_infinite_numbers(const Document& document, const json& value, const std::string& path,
                           std::vector<Fault>& faults) {
  if (value.is_number_float() && !std::isfinite(value.get<double>())) {
    faults.push_back({document.file, path, "is no number, must be finite"});
  }
  if (!value.is_structured()) return;
  for (const auto& [key, child] : value.items()) {
    find_infinite_numbers(document, child, child_path(path, key), faults);
  }
}

void find_unprintable_texts(const Document& document, const json& value, const std::string& path,
                            std::vector<Fault>& faults) {
  if (faults.size() >= kMaxListedFaults) return;
  if (value.is_string()) {
    if (const auto found = unprintable_in(value.get_ref<const std::string&>())) {
      faults.push_back(
          {document.file, path, fmt::format("holds {}; must be one line of text", *found)});
    }
    return;
  }
  if (!value.is_structured()) return;
  for (const auto& [key, child] : value.items()) {
    const std::string place = child_path(path, key);
    if (const auto found = unprintable_in(key)) {
      faults.push_back(
          {document.file, place, fmt::format("a key with {}; must be one line of text", *found)});
    }
    find_unprintable_texts(document, child, place, faults);
  }
}

bool leads_somewhere(const json& root, const std::string& pointer) {
  try {
    return root.contains(json::json_pointer(pointer));
  } catch (const json::exception&) {  // no pointer at all, or no index where one must stand
    return false;
  }
}

void find_lost_assumptions(const Document& document, std::vector<Fault>& faults) {
  const json assumed = document.root.value("assumed", json::array());
  for (std::size_t i = 0; i < assumed.size(); ++i) {
    if (!assumed[i].is_string() || leads_somewhere(document.root, assumed[i])) continue;
    const std::string path = child_path(document.path + "/assumed", std::to_string(i));
    faults.push_back({document.file, path,
                      as_written(assumed[i]) + " points at nothing; must be the JSON pointer of "
                                               "a value of this document"});
  }
}

/// The rest of another kind, or of another version, is nobody's business here.
bool is_foreign(const json& root, const json& properties) {
  for (const char* key : {"kind", "version"}) {
    if (root.contains(key) && root[key] != properties[key]["const"]) return true;
  }
  return false;
}

/// What is wrong with these two alone.
std::vector<Fault> kind_and_version_faults(const Document& document, const json& schema) {
  std::vector<Fault> faults;
  for (const char* key : {"kind", "version"}) {
    if (!document.root.contains(key)) continue;
    const std::vector<Fault> found = diagnose(document.root[key], schema["properties"][key],
                                              document.file, child_path(document.path, key));
    faults.insert(faults.end(), found.begin(), found.end());
  }
  return faults;
}

/// Everything that is wrong with the document's shape. Never empty where it does not conform.
std::vector<Fault> find_faults(const Document& document, std::string_view kind) {
  std::vector<Fault> faults;
  if (!conforms(document.root, kind)) {
    const json& schema = schema_of(kind);
    if (document.root.is_object() && is_foreign(document.root, schema["properties"])) {
      return kind_and_version_faults(document, schema);
    }
    faults = diagnose(document.root, schema, document.file, document.path);
    if (faults.empty()) {  // a keyword of the schema that diagnose() does not know
      faults = {{document.file, document.path, "is not as specs/schema demands"}};
    }
  }
  if (faults.empty()) find_unprintable_texts(document, document.root, document.path, faults);
  if (document.root.is_object() && document.root.value("assumed", json()).is_array()) {
    find_lost_assumptions(document, faults);
  }
  return faults;
}

}  // namespace

namespace {

JsonText read_complete_text(const std::string& bytes, const std::string& file) {
  JsonText text = read_json_text(bytes, file);
  if (!text.complete) throw SpecError(std::move(text.faults));
  return text;
}

Document checked(JsonText text, const std::string& bytes, const std::string& file,
                 std::string_view kind) {
  take_listed_capitals(text.root, schema_of(kind));
  std::vector<Fault> faults = std::move(text.faults);
  take_stated_units(text.root, schema_of(kind), file, faults);
  Document document{file, "", std::move(text.root), sha256(bytes)};
  for (Fault& fault : find_faults(document, kind)) faults.push_back(std::move(fault));
  if (!faults.empty()) throw SpecError(std::move(faults));
  note_read(document.file, document.root);
  return document;
}

}  // namespace

Document read_document(const std::filesystem::path& file, std::string_view kind) {
  const std::string bytes = read_file_bytes(file);
  return checked(read_complete_text(bytes, file.string()), bytes, file.string(), kind);
}

namespace {

Document read_one_of(const std::filesystem::path& file, const std::vector<std::string>& kinds) {
  const std::string bytes = read_file_bytes(file);
  JsonText text = read_complete_text(bytes, file.string());
  const json stated = text.root.is_object() ? text.root.value("kind", json()) : json();
  for (const std::string& kind : kinds) {
    if (stated == kind) return checked(std::move(text), bytes, file.string(), kind);
  }
  throw SpecError({{file.string(), "/kind",
                    as_written(stated) + " is not what is needed here; must be " + either(kinds)}});
}

}  // namespace

Document read_document(const std::filesystem::path& file,
                       std::initializer_list<std::string_view> kinds) {
  return read_one_of(file, {kinds.begin(), kinds.end()});
}

Document read_any_document(const std::filesystem::path& file) {
  return read_one_of(file, document_kinds());
}

Document check_document(json root, std::string_view kind, std::string file, std::string path) {
  take_listed_capitals(root, schema_of(kind));
  Document document{std::move(file), std::move(path), std::move(root), ""};
  std::vector<Fault> faults;
  find_infinite_numbers(document, document.root, document.path, faults);
  if (faults.empty()) faults = find_faults(document, kind);
  if (!faults.empty()) throw SpecError(std::move(faults));
  document.sha256 = sha256(document.root.dump(-1, ' ', false, json::error_handler_t::replace));
  return document;
}

}  // namespace torquewright::io
