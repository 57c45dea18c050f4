// SPDX-License-Identifier: Apache-2.0
#include "actuator/catalogue/drive_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "actuator/catalogue/embedded_catalogue.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "io/documents/json_reader.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/nearest.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::actuator {
namespace {

namespace fs = std::filesystem;

void add(const std::string& stem, io::Document document, DriveSet& set) {
  ReadActuator read = read_actuator(std::move(document));
  set.drives.push_back({stem, std::move(read.actuator)});
  for (io::Document& one : read.documents) set.documents.push_back(std::move(one));
}

std::vector<fs::path> json_files(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) io::refuse(folder.string(), "is no folder");
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  if (error) io::refuse_unreadable(folder.string(), error.value());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

DriveSet drives_in(const fs::path& folder) {
  DriveSet set;
  for (const fs::path& file : json_files(folder)) {
    const std::string stem = io::stem_in_text(file);
    try {
      io::Document document = io::read_any_document(file);
      if (document.root["kind"] != "actuator") continue;
      add(stem, std::move(document), set);
    } catch (const io::SpecError& error) {
      set.left_out.push_back(fmt::format("{}: {}", stem, error.faults().front().message));
    }
  }
  if (set.drives.empty()) io::refuse(folder.string(), "holds no actuator that can be read");
  return set;
}

std::string catalogue_text(const std::string& stem) {
  std::vector<std::string> stems;
  for (const EmbeddedDrive& drive : embedded_catalogue()) {
    if (drive.stem == stem) return std::string(drive.text);
    stems.emplace_back(drive.stem);
  }
  const std::optional<std::string> near = io::nearest(stem, stems);
  io::refuse(stem, near ? fmt::format("is no drive of the catalogue; did you mean {}?", *near)
                        : "is no drive of the catalogue; `actuator find` lists them");
}

DriveSet catalogue() {
  DriveSet set;
  for (const EmbeddedDrive& drive : embedded_catalogue()) {
    const std::string file = fmt::format("catalogue/{}.json", drive.stem);
    io::JsonText text = io::read_json_text(drive.text, file);
    add(std::string(drive.stem), io::check_document(std::move(text.root), "actuator", file, ""),
        set);
  }
  return set;
}

}  // namespace torquewright::actuator
