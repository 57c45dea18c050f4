// SPDX-License-Identifier: Apache-2.0
// The catalogue: every number has a source. Oracle: the documents themselves, walked as JSON.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "actuator/catalogue/drive_set.hpp"

namespace torquewright::actuator {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kFolder = fs::path(TORQUEWRIGHT_SOURCE_DIR) / "specs/catalogue";

std::vector<fs::path> files() {
  std::vector<fs::path> all;
  for (const fs::directory_entry& entry : fs::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".json") all.push_back(entry.path());
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Pointers of all numbers of a document; one with "also" counts as one.
void collect(const json& value, const std::string& pointer, std::set<std::string>& numbers) {
  if (value.is_number()) numbers.insert(pointer);
  if (value.is_object() && value.contains("value")) {
    numbers.insert(pointer);
  } else if (value.is_structured()) {
    for (const auto& [key, part] : value.items()) collect(part, pointer + "/" + key, numbers);
  }
}

bool is_within(const std::string& pointer, const std::string& block) {
  return pointer == block || pointer.starts_with(block + "/");
}

TEST(Catalogue, HasThirtyDrivesAndMore) { EXPECT_GE(files().size(), 30u); }

TEST(Catalogue, IsCompiledInAsItStands) {
  const DriveSet inside = catalogue();
  const DriveSet outside = drives_in(kFolder);
  EXPECT_TRUE(outside.left_out.empty()) << outside.left_out.front();
  ASSERT_EQ(inside.drives.size(), outside.drives.size());
  for (std::size_t i = 0; i < inside.drives.size(); ++i) {
    EXPECT_EQ(inside.drives[i].stem, outside.drives[i].stem);
    EXPECT_EQ(inside.drives[i].actuator.name, outside.drives[i].actuator.name);
  }
}

TEST(Catalogue, EveryNumberHasASourceOrIsAssumed) {
  for (const fs::path& file : files()) {
    std::ifstream stream(file);
    const json root = json::parse(stream);
    std::set<std::string> numbers;
    for (const char* block : {"envelope", "motor", "drive", "gearbox", "datasheet", "mass_kg"}) {
      if (root.contains(block)) collect(root[block], std::string("/") + block, numbers);
    }
    std::set<std::string> known;
    for (const json& pointer : root.value("assumed", json::array())) known.insert(pointer);
    ASSERT_TRUE(root.contains("sources")) << file;
    for (const json& source : root["sources"]) {
      for (const json& pointer : source["values"]) {
        EXPECT_TRUE(root.contains(json::json_pointer(pointer.get<std::string>())))
            << file << " names a source of " << pointer << ", which it does not state";
        known.insert(pointer);
      }
    }
    for (const std::string& number : numbers) {
      const auto holds = [&](const std::string& pointer) { return is_within(number, pointer); };
      EXPECT_TRUE(std::any_of(known.begin(), known.end(), holds))
          << file << ": " << number << " has no source";
    }
  }
}

/// How many sources name a pointer, or what it stands in.
std::size_t sources_of(const json& root, const std::string& pointer) {
  std::size_t count = 0;
  for (const json& source : root["sources"]) {
    for (const json& value : source["values"])
      count += is_within(pointer, value.get<std::string>()) ? 1 : 0;
  }
  return count;
}

TEST(Catalogue, SourcesHaveTheFormOfSources) {
  for (const fs::path& file : files()) {
    std::ifstream stream(file);
    const json root = json::parse(stream);
    for (const json& source : root["sources"]) {
      if (source.contains("page")) {
        EXPECT_TRUE(std::regex_search(source["page"].get<std::string>(), std::regex("^https?://")));
        continue;
      }
      const std::string repository = source["repository"], commit = source["commit"];
      EXPECT_TRUE(std::regex_match(repository, std::regex("[^/ ]+/[^/ ]+"))) << file << repository;
      EXPECT_TRUE(std::regex_match(commit, std::regex("[0-9a-f]{7,40}"))) << file << commit;
    }
  }
}

TEST(Catalogue, WhatStandsTwiceHasTwoSources) {
  for (const fs::path& file : files()) {
    std::ifstream stream(file);
    const json root = json::parse(stream);
    for (const char* block : {"envelope", "datasheet"}) {
      if (!root.contains(block)) continue;
      for (const auto& [key, value] : root[block].items()) {
        if (!value.is_object() || !value.contains("also")) continue;
        EXPECT_GE(sources_of(root, std::string("/") + block + "/" + key), 2u) << file << key;
      }
    }
  }
}

}  // namespace
}  // namespace torquewright::actuator
