// SPDX-License-Identifier: Apache-2.0
#include "hopper/randomised_files/event_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "actuator/exporters/text.hpp"
#include "hopper/randomised_files/every_event_writer.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::hopper {
namespace {

std::vector<const EventWriter*> every_event_writer() {
  return {
#define TORQUEWRIGHT_ADDRESS(name) &event_writers::name,
      TORQUEWRIGHT_EVERY_EVENT_WRITER(TORQUEWRIGHT_ADDRESS)
#undef TORQUEWRIGHT_ADDRESS
  };
}

}  // namespace

const EventWriter* find_event_writer(std::string_view format) {
  for (const EventWriter* writer : every_event_writer()) {
    if (std::find(writer->formats.begin(), writer->formats.end(), format) !=
        writer->formats.end()) {
      return writer;
    }
  }
  return nullptr;
}

std::vector<std::string> randomised_formats() {
  std::vector<std::string> all;
  for (const EventWriter* writer : every_event_writer()) {
    all.insert(all.end(), writer->formats.begin(), writer->formats.end());
  }
  return all;
}

std::string events_of(const EventWriter& writer, const Randomisation& randomisation,
                      const Robot& robot, std::vector<std::string>& notes) {
  const DrawnParts parts = drawn_parts(randomisation, robot);
  const EventText written = writer.write(parts, robot);
  std::vector<std::string> head{
      fmt::format("Randomisation: {}.", io::name_in_text(randomisation.file)),
      fmt::format("Terms as in {}", writer.source), std::string(writer.advice)};
  for (const auto* list : {&parts.left_out, &written.left_out}) {
    for (const std::string& each : *list) {
      head.push_back("Left out: " + each);
      notes.push_back("left out of the randomisation: " + each);
    }
  }
  for (const std::string& each : parts.notes) {
    head.push_back(each + ".");
    notes.push_back(each);
  }
  for (const std::string& each : randomisation.assumed) head.push_back("Assumed: " + each);
  return "\n" + actuator::line_comment(head, "# ") + written.text;
}

}  // namespace torquewright::hopper
