// SPDX-License-Identifier: Apache-2.0
#include "tests/layers/layers.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

namespace torquewright::layers {
namespace {

namespace fs = std::filesystem;
using Folders = std::set<std::string, std::less<>>;

/// Which folders the files of each may include, besides its own:
/// python -> src -> hopper, identification -> robot, simulation -> actuator, dynamics -> gearbox ->
/// optimization; learning -> hopper; io for all.
const std::map<std::string, Folders, std::less<>> kMayInclude = {
    {"io", {}},
    {"optimization", {"io"}},
    {"learning", {"io"}},
    {"gearbox", {"io", "optimization"}},
    {"actuator", {"io", "optimization", "gearbox"}},
    {"dynamics", {"io", "optimization", "gearbox"}},
    {"robot", {"io", "optimization", "gearbox", "actuator", "dynamics"}},
    {"simulation", {"io", "optimization", "gearbox", "actuator", "dynamics"}},
    {"hopper",
     {"io", "optimization", "learning", "gearbox", "actuator", "dynamics", "robot", "simulation"}},
    {"identification",
     {"io", "optimization", "gearbox", "actuator", "dynamics", "robot", "simulation"}},
    {"src",
     {"io", "optimization", "learning", "gearbox", "actuator", "dynamics", "robot", "simulation",
      "hopper", "identification"}},
    {"python", {"io", "optimization", "actuator", "hopper", "src"}},
};

/// The rooms of a folder, and which of its other rooms the files of each may include. What lies
/// beside the rooms is their common ground: every room may include it, and it includes none.
using Rooms = std::map<std::string, Folders, std::less<>>;
const std::map<std::string, Rooms, std::less<>> kRooms = {
    {"io",
     {{"text", {}},
      {"faults", {"text"}},
      {"table_forms", {"faults", "text"}},
      {"files", {"faults", "table_forms", "text"}},
      {"columns", {"faults", "files", "text"}},
      {"documents", {"faults", "files", "text"}}}},
    {"optimization",
     {{"expressions", {}},
      {"discrete", {"expressions"}},
      {"fit", {}},
      {"nonlinear", {}},
      {"quadratic", {}}}},
    {"learning", {{"formulas", {}}, {"network", {}}, {"training", {"formulas", "network"}}}},
    {"gearbox",
     {{"teeth", {}},
      {"train", {"teeth"}},
      {"constraints", {"teeth", "train"}},
      {"topologies", {"teeth", "train", "constraints"}},
      {"strength", {"teeth", "train", "constraints", "topologies"}},
      {"search", {"topologies"}},
      {"inspection", {"teeth"}},
      {"tolerances", {"teeth", "train", "constraints"}},
      {"synthesis", {"teeth", "train", "constraints", "topologies", "strength", "search"}},
      {"front", {"constraints", "topologies", "search", "synthesis"}},
      {"proof/reading", {}},
      {"proof/gears", {}},
      {"proof/claims", {"proof/gears", "proof/reading"}},
      {"proof/relaxation", {"proof/claims", "proof/gears"}},
      {"proof/tree", {"proof/claims", "proof/gears", "proof/reading", "proof/relaxation"}},
      {"proof/result", {"proof/claims", "proof/reading", "proof/tree"}},
      {"sized_proof/enclosures", {}},
      {"sized_proof", {"teeth", "train", "constraints", "strength", "sized_proof/enclosures"}},
      {"verification",
       {"topologies", "search", "strength", "synthesis", "proof/reading", "proof/result",
        "sized_proof"}}}},
    {"actuator",
     {{"effects", {}},
      {"motor", {"effects"}},
      {"heat", {"effects", "motor"}},
      {"region", {"effects", "motor", "heat"}},
      {"mor", {"region"}},
      {"conditions", {"region", "mor"}},
      {"trajectory", {}},
      {"drive_check", {"motor", "heat", "region", "mor", "conditions", "trajectory"}},
      {"check", {"trajectory", "drive_check"}},
      {"catalogue", {"motor", "mor"}},
      {"lint", {"motor", "region"}},
      {"winding", {"motor", "lint"}},
      {"friction", {"effects", "motor", "heat", "region"}},
      {"source_text", {}},
      {"exporters", {"motor", "region", "mor", "heat", "conditions", "friction", "source_text"}}}},
    {"dynamics", {}},
    {"simulation",
     {{"contact", {}},
      {"plants", {}},
      {"joint", {}},
      {"stepper", {"joint"}},
      {"in_engine", {"joint", "plants", "stepper"}},
      {"run", {"joint", "stepper"}}}},
    {"robot",
     {{"parts", {}},
      {"mechanisms", {"parts"}},
      {"model", {"mechanisms", "parts"}},
      {"xml", {"model"}},
      {"draft", {"mechanisms", "model", "parts", "xml"}},
      {"loops", {"draft", "mechanisms", "model", "xml"}},
      {"urdf", {"draft", "model", "parts", "xml"}},
      {"sdf", {"draft", "model", "parts", "urdf", "xml"}},
      {"mjcf", {"draft", "loops", "model", "urdf", "xml"}},
      {"simulators", {"draft", "model", "urdf", "xml"}}}},
    {"hopper",
     {{"motion", {}},
      {"contact", {"motion"}},
      {"demand", {"contact"}},
      {"check", {"motion", "contact", "demand"}},
      {"candidates", {"check"}},
      {"design", {"check", "candidates"}},
      {"calibration", {}},
      {"variation", {}},
      {"engines", {}},
      {"policy", {}},
      {"surroundings", {}},
      {"tracking", {"motion", "contact"}},
      {"tracking/operational", {"tracking"}},
      {"tracking/stepping", {"motion", "tracking"}},
      {"record", {"demand", "check", "tracking"}},
      {"verdict", {"motion", "demand", "record"}},
      {"trials", {"tracking", "verdict"}},
      {"randomised_files", {"trials"}},
      {"replay",
       {"demand", "check", "engines", "surroundings", "tracking", "record", "verdict", "trials"}},
      {"replay_report", {"check", "trials", "replay"}},
      {"skill", {"demand", "policy", "tracking", "verdict"}},
      {"training/rewards", {"tracking", "skill"}},
      {"training/rewards/flip", {"training/rewards"}},
      {"training/rewards/hop", {"training/rewards"}},
      {"training/task",
       {"tracking", "verdict", "trials", "skill", "training/rewards", "planning/plane"}},
      {"training/episode", {"motion", "engines", "verdict", "trials", "replay", "training/task"}},
      {"training/run",
       {"policy", "verdict", "trials", "replay", "skill", "training/task", "training/episode"}},
      {"planning/region", {"replay"}},
      {"planning/plane", {}},
      {"planning/tasks", {"demand", "replay", "planning/plane"}},
      {"planning/model", {"planning/region", "planning/plane", "planning/tasks"}},
      {"planning/objectives", {"planning/plane", "planning/model"}},
      {"planning/constraints", {"planning/plane", "planning/model"}},
      {"planning/programme",
       {"motion", "contact", "planning/plane", "planning/tasks", "planning/model",
        "planning/objectives", "planning/constraints"}},
      {"planning/result", {"check", "planning/plane", "planning/model", "planning/constraints"}},
      {"planning/search",
       {"check", "trials", "variation", "replay_report", "planning/plane", "planning/tasks",
        "planning/objectives", "planning/programme", "planning/result"}}}},
    {"identification",
     {{"rig", {}},
      {"recordings", {}},
      {"imports", {"recordings", "rig"}},
      {"outputs", {"rig"}},
      {"draft", {"rig"}},
      {"log", {"rig"}},
      {"reading", {"rig", "log"}},
      {"simulated", {"rig", "log"}},
      {"signals", {"rig", "log", "simulated"}},
      {"preparation", {"log", "signals"}},
      {"findings", {"log", "signals", "preparation"}},
      {"forward", {"rig", "signals", "preparation", "findings"}},
      {"selection", {"log", "signals", "preparation", "findings", "forward"}},
      {"replay", {"simulated", "preparation", "findings", "forward"}},
      {"rollout", {"rig", "log", "simulated", "findings", "selection"}},
      {"robot", {"rig", "log", "reading", "simulated", "rollout"}},
      {"robot_search", {"log", "findings", "forward", "rollout", "robot"}},
      {"robot_plan", {"rig", "log", "simulated", "rollout"}},
      {"experiment", {"rig", "simulated", "signals", "preparation", "findings", "forward"}},
      {"answer",
       {"log", "reading", "signals", "preparation", "findings", "forward", "selection", "replay",
        "rollout"}}}},
    {"src",
     {{"sweep", {}},
      {"command_line", {}},
      {"options", {"command_line", "sweep"}},
      {"report/parts", {"sweep"}},
      {"report/gearbox", {"report/parts"}},
      {"report/workshop", {"report/gearbox", "report/parts"}},
      {"report/actuator", {"report/parts"}},
      {"report/turning", {"report/parts"}},
      {"report/robot", {"report/actuator", "report/parts", "report/turning", "sweep"}},
      {"report/motion", {"report/parts", "report/robot", "report/turning"}},
      {"report/identification", {"report/parts"}},
      {"commands/shared", {"command_line", "options", "report/identification", "report/parts"}},
      {"commands/gearbox",
       {"command_line", "commands/shared", "options", "report/gearbox", "report/parts",
        "report/workshop"}},
      {"commands/actuator",
       {"command_line", "commands/shared", "options", "report/actuator", "report/parts"}},
      {"commands/policy", {"command_line", "commands/shared", "options"}},
      {"commands/robot",
       {"command_line", "commands/shared", "options", "report/motion", "report/parts",
        "report/robot", "sweep"}},
      {"commands/design",
       {"command_line", "commands/robot", "commands/shared", "options", "report/parts",
        "report/robot"}},
      {"commands/planning",
       {"commands/robot", "commands/shared", "options", "report/motion", "report/parts",
        "report/robot", "sweep"}},
      {"commands/identification",
       {"command_line", "commands/shared", "options", "report/actuator", "report/identification",
        "report/parts"}}}},
};

/// The only files that stand above the rooms of their folder.
constexpr std::array<std::string_view, 2> kAbove{"src/main.cpp", "src/program.cpp"};

std::string folder_of(std::string_view name) {
  const std::size_t slash = name.find('/');
  return slash == std::string_view::npos ? "" : std::string(name.substr(0, slash));
}

/// The room of a file: the deepest of the folders that it lies in that the table knows, or the
/// first one where it knows none; empty where the file lies beside the rooms.
std::string room_of(std::string_view name) {
  const std::string folder = folder_of(name);
  std::string inside = fs::path(name).parent_path().lexically_relative(folder).generic_string();
  if (inside == ".") return "";
  const auto rooms = kRooms.find(folder);
  const std::string first = inside.substr(0, inside.find('/'));
  while (rooms != kRooms.end() && !inside.empty() && !rooms->second.contains(inside)) {
    inside = fs::path(inside).parent_path().generic_string();
  }
  return inside.empty() ? first : inside;
}

std::string objection_inside(const std::string& folder, const std::string& from,
                             const std::string& to) {
  const auto rooms = kRooms.find(folder);
  if (rooms == kRooms.end()) return "";
  for (const std::string& room : {from, to}) {
    if (room.empty() || rooms->second.contains(room)) continue;
    return "the layer test does not know the room " + folder + "/" + room;
  }
  if (to.empty() || from == to) return "";
  if (!from.empty() && rooms->second.at(from).contains(to)) return "";
  const std::string above =
      from.empty() ? "what lies beside the rooms of " + folder + "/" : folder + "/" + from + "/";
  return above + " does not stand above " + folder + "/" + to + "/";
}

bool is_solver(std::string_view header) {
  std::string lower(header);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char letter) { return std::tolower(letter); });
  return lower.starts_with("ip") || lower.starts_with("coin") || lower.starts_with("nlopt");
}

bool is_shared_with_the_checker(std::string_view name) {
  return name.starts_with("gearbox/proof/") || name.starts_with("io/") ||
         name == "gearbox/problem.hpp" || name == "gearbox/problem_spec.hpp" ||
         name == "gearbox/floors.hpp";
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool is_source(const fs::path& file) {
  return file.extension() == ".cpp" || file.extension() == ".hpp";
}

}  // namespace

std::map<std::string, std::set<std::string>> folders_below() {
  std::map<std::string, std::set<std::string>> below;
  for (const auto& [folder, others] : kMayInclude) below[folder] = {others.begin(), others.end()};
  return below;
}

std::map<std::string, std::set<std::string>> rooms_below(const std::string& folder) {
  std::map<std::string, std::set<std::string>> below;
  const auto found = kRooms.find(folder);
  if (found == kRooms.end()) return below;
  for (const auto& [room, others] : found->second) below[room] = {others.begin(), others.end()};
  return below;
}

std::string room_named(std::string_view file) {
  const std::string room = room_of(file);
  return folder_of(file) + (room.empty() ? "" : "/" + room);
}

std::string objection(std::string_view file, const Include& include) {
  const std::string& included = include.name;
  const std::string from = folder_of(file);
  const std::string to = folder_of(included);
  if (to == "tests" || to == "bench") return to + "/ is not for the library";
  const bool is_ours = kMayInclude.contains(to);
  // A path from the file's own folder, or with ".." in it, would slip through everything below.
  if (included.find("..") != std::string::npos || (include.is_quoted && !is_ours)) {
    return "our headers are named from the root, those of others in <>";
  }
  if (!is_ours) {
    if (included.starts_with("CLI/") && !file.starts_with("src/command_line/")) {
      return "only src/command_line/ includes CLI11";
    }
    const bool may_solve = from == "optimization" || !is_solver(included);
    return may_solve ? "" : "only optimization/ includes a solver";
  }
  if (file.starts_with("gearbox/proof/") && !is_shared_with_the_checker(included)) {
    return "the checker of proofs shares only the reader of problems with the search";
  }
  if (from == to) {
    const bool is_above = std::find(kAbove.begin(), kAbove.end(), file) != kAbove.end();
    return is_above ? "" : objection_inside(from, room_of(file), room_of(included));
  }
  if (kMayInclude.at(from).contains(to)) return "";
  return from + "/ does not stand above " + to + "/";
}

std::vector<Include> includes_in(std::string_view text) {
  static const std::regex kDirective(
      R"re((?:^|\n)[ \t]*#[ \t]*include[ \t]*(["<])([^">\n]*)[">])re");
  std::vector<Include> includes;
  using Iterator = std::regex_iterator<std::string_view::const_iterator>;
  for (Iterator found(text.begin(), text.end(), kDirective); found != Iterator(); ++found) {
    includes.push_back({(*found)[2].str(), (*found)[1].str() == "\""});
  }
  return includes;
}

std::vector<SourceFile> library_sources(const fs::path& root) {
  std::vector<SourceFile> sources;
  for (const auto& [folder, others] : kMayInclude) {
    if (!fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!is_source(entry.path())) continue;
      sources.push_back({entry.path().lexically_relative(root).generic_string(),
                         includes_in(text_of(entry.path()))});
    }
  }
  return sources;
}

std::vector<std::string> find_objections(const fs::path& root) {
  std::vector<std::string> sentences;
  for (const SourceFile& source : library_sources(root)) {
    for (const Include& include : source.includes) {
      const std::string why = objection(source.name, include);
      if (!why.empty()) sentences.push_back(source.name + " includes " + include.name + ": " + why);
    }
  }
  std::sort(sentences.begin(), sentences.end());
  return sentences;
}

}  // namespace torquewright::layers
