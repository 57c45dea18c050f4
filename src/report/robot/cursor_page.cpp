// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/cursor_page.hpp"

#include <fmt/format.h>

#include "io/documents/provenance.hpp"
#include "src/report/parts/embedded_page.hpp"
#include "src/report/parts/html_page.hpp"
#include "src/report/parts/script_policy.hpp"
#include "src/report/parts/svg.hpp"

namespace torquewright::report {

std::string cursor_page_begin(const std::string& title, const std::string& further_style) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{}</title>\n<style>{}{}{}</style>\n</head>\n<body>\n<main>\n",
      script_policy({kThreeScript, kTurningScript, kHopperScript}), escaped(title), kPageStyle,
      kHopperStyle, further_style);
}

std::string cursor_page_end(const std::string& numbers, bool turns) {
  std::string script;
  if (!numbers.empty()) {
    script = fmt::format(
        "<script type=\"application/json\" id=\"motion\">{}</script>\n{}<script>{}</script>\n",
        numbers,
        turns ? fmt::format("<script>{}</script>\n<script>{}</script>\n", kThreeScript,
                            kTurningScript)
              : "",
        kHopperScript);
  }
  return fmt::format("<p class=\"soft\">torquewright {}</p>\n</main>\n{}</body>\n</html>\n",
                     io::tool_version(), script);
}

}  // namespace torquewright::report
