// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>
#include <set>

#include "identification/log/stretch.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::identification {

void give_names(std::vector<Stretch>& stretches, const std::vector<std::filesystem::path>& files) {
  std::map<std::string, std::set<std::size_t>> files_by_name;
  for (const Stretch& stretch : stretches) files_by_name[stretch.run.name].insert(stretch.file);
  std::map<std::string, std::size_t> file_of;
  for (Stretch& stretch : stretches) {
    std::string& name = stretch.run.name;
    if (files_by_name[name].size() > 1) {
      const std::string stem = io::stem_in_text(files[stretch.file]);
      name = name == stem ? name : stem + "/" + name;
    }
    const auto [other, is_new] = file_of.emplace(name, stretch.file);
    if (is_new || other->second == stretch.file) continue;
    throw io::SpecError({{files[stretch.file].string(), "",
                          fmt::format("its run \"{}\" has the name of one of {}; rename a file, or "
                                      "give each once",
                                      name, files[other->second].string())}});
  }
}

}  // namespace torquewright::identification
