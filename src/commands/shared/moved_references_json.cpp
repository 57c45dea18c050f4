// SPDX-License-Identifier: Apache-2.0
#include "src/commands/shared/moved_references_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "io/faults/refusal.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::cli {
namespace {

namespace fs = std::filesystem;

template <typename Json>
void move(Json& file, const fs::path& from, const fs::path& to) {
  const fs::path old = fs::absolute(from.parent_path() / file.template get<std::string>());
  const std::string moved = fs::proximate(old, fs::absolute(to).parent_path()).string();
  if (const auto found = io::unprintable_in(moved)) {
    io::refuse_output(to, fmt::format("it would name the file {}, which holds {}; a document names "
                                      "files by one line of text",
                                      io::one_line(moved), *found));
  }
  file = moved;
}

template <typename Json>
void move_mechanisms(Json& document, const fs::path& from, const fs::path& to) {
  if (!document.contains("mechanisms")) return;
  for (Json& mechanism : document["mechanisms"]) {
    for (Json& file : mechanism["actuators"]) move(file, from, to);
    const typename Json::json_pointer strength("/transmission_limit/strength");
    if (mechanism.contains(strength)) move(mechanism[strength], from, to);
  }
}

}  // namespace

void move_actuator(nlohmann::ordered_json& document, const fs::path& from, const fs::path& to) {
  nlohmann::ordered_json& gearbox = document["gearbox"];
  if (gearbox.contains("file")) move(gearbox["file"], from, to);
}

void require_movable_actuator(const io::Document& document, const fs::path& to) {
  nlohmann::ordered_json moved = document.root;
  move_actuator(moved, document.file, to);
}

void move_robot(nlohmann::json& document, const fs::path& from, const fs::path& to) {
  move_mechanisms(document, from, to);
}

void move_robot(nlohmann::ordered_json& document, const fs::path& from, const fs::path& to) {
  move_mechanisms(document, from, to);
}

}  // namespace torquewright::cli
