// SPDX-License-Identifier: Apache-2.0
#include "io/documents/schema.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "io/documents/document.hpp"
#include "io/faults/diagnosis.hpp"
#include "io/files/file_bytes.hpp"

namespace torquewright::io {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<fs::path> json_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

const fs::path kSpecs = fs::path(TORQUEWRIGHT_SOURCE_DIR) / "specs";

TEST(DocumentKinds, AreTheFilesInTheSchemaFolder) {
  std::vector<std::string> stems;
  for (const fs::path& file : json_files(kSpecs / "schema")) stems.push_back(file.stem().string());
  EXPECT_EQ(document_kinds(), stems);
  for (const std::string& kind : stems) {
    EXPECT_EQ(schema_of(kind)["properties"]["kind"]["const"], kind);
    EXPECT_EQ(schema_of(kind)["properties"]["version"]["const"], 1);
  }
}

TEST(Specs, AllHaveTheShapeOfTheirKind) {
  int count = 0;
  for (const fs::path& file : json_files(kSpecs)) {
    if (file.parent_path() == kSpecs / "schema") continue;
    const std::string kind = json::parse(read_file_bytes(file)).value("kind", "");
    EXPECT_NO_THROW(read_document(file, kind)) << file;
    ++count;
  }
  EXPECT_GE(count, 5);
}

/// Every keyword of a schema node that constrains, outside "properties" and "definitions".
void collect_keywords(const json& schema, std::vector<std::string>& keywords) {
  if (schema.is_array()) {
    for (const json& each : schema) collect_keywords(each, keywords);
  }
  if (!schema.is_object()) return;
  for (const auto& [key, value] : schema.items()) {
    keywords.push_back(key);
    if (key == "pattern") {
      EXPECT_EQ(value, "\\S");  // "not blank": the only one that is known
    }
    if (key == "properties" || key == "definitions") {
      for (const json& each : value) collect_keywords(each, keywords);
    } else if (key == "items" || key == "anyOf" || key == "additionalProperties") {
      collect_keywords(value, keywords);
    }
  }
}

// A keyword the diagnosis does not know would be enforced without a sentence that says so.
TEST(Schemas, UseOnlyKeywordsThatTheDiagnosisKnows) {
  const std::vector<std::string> known = {
      "$schema",     "title",    "description",   "definitions", "type",     "const",
      "enum",        "minimum",  "maximum",       "minItems",    "maxItems", "items",
      "properties",  "required", "anyOf",         "$ref",        "unit",     "additionalProperties",
      "also_called", "pattern",  "usually_stated"};
  for (const std::string& kind : document_kinds()) {
    std::vector<std::string> keywords;
    collect_keywords(schema_of(kind), keywords);
    for (const std::string& keyword : keywords) {
      EXPECT_NE(std::find(known.begin(), known.end(), keyword), known.end()) << kind << keyword;
    }
  }
}

/// The document with each of its values replaced by each of some others.
std::vector<json> slips_of(const json& document) {
  const json replacements = {nullptr, -1, 0, 1.5, 1e9, "x", true, json::array(), json::object()};
  std::vector<json> slips;
  const json leaves = document.flatten();
  for (const auto& leaf : leaves.items()) {
    for (const json& replacement : replacements) {
      slips.push_back(document);
      slips.back()[json::json_pointer(leaf.key())] = replacement;
    }
  }
  for (const auto& member : document.items()) {
    slips.push_back(document);
    slips.back().erase(member.key());
  }
  return slips;
}

// Oracle: valijson, an independent implementation of JSON Schema. The sentences must be there
// exactly where it refuses.
TEST(Diagnosis, AgreesWithTheValidator) {
  int refused = 0;
  for (const fs::path& file : json_files(kSpecs / "gearbox")) {
    const json document = json::parse(read_file_bytes(file));
    const std::string kind = document["kind"];
    for (const json& slip : slips_of(document)) {
      const bool has_faults = !diagnose(slip, schema_of(kind), "f", "").empty();
      EXPECT_EQ(has_faults, !conforms(slip, kind)) << slip;
      refused += has_faults ? 1 : 0;
    }
  }
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace torquewright::io
