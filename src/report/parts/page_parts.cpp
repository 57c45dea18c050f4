// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/page_parts.hpp"

#include <fmt/format.h>

#include "src/report/parts/svg.hpp"

namespace torquewright::report {
namespace {

std::string key(const std::string& mark, const std::string& words) {
  return fmt::format("<li><svg aria-hidden=\"true\" viewBox=\"0 0 26 14\">{}</svg>{}</li>\n", mark,
                     escaped(words));
}

}  // namespace

std::string page_section(const std::string& title, const std::string& content) {
  if (content.empty()) return "";
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", escaped(title), content);
}

std::string page_table(const std::string& caption, const std::vector<std::string>& headings,
                       const std::vector<std::vector<std::string>>& rows) {
  // Roles are said, since a table that is laid out as blocks loses its own in some browsers.
  std::string text = fmt::format(
      "<table class=\"stack\" role=\"table\">\n<caption class=\"spoken\">{}</caption>\n<tr "
      "class=\"head\" role=\"row\">",
      escaped(caption));
  for (const std::string& heading : headings) {
    text += "<th role=\"columnheader\" scope=\"col\">" + escaped(heading) + "</th>";
  }
  text += "</tr>\n";
  for (const auto& row : rows) {
    text += "<tr role=\"row\">";
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += fmt::format("<td role=\"cell\" data-label=\"{}\">{}</td>", escaped(headings[i]),
                          escaped(row[i]));
    }
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string panel_of(const std::string& heading, const std::string& picture) {
  return fmt::format("<figure class=\"panel\">\n<figcaption>{}</figcaption>\n{}</figure>\n",
                     escaped(heading), picture);
}

std::string panels(const std::string& content) {
  return content.empty() ? "" : "<div class=\"panels\">\n" + content + "</div>\n";
}

std::string box_key(const std::string& style, const std::string& words) {
  return key(fmt::format("<rect class=\"{}\" x=\"3\" width=\"20\" height=\"14\"/>", style), words);
}

std::string line_key(const std::string& style, const std::string& words) {
  return key(fmt::format("<line class=\"{}\" x1=\"1\" y1=\"7\" x2=\"25\" y2=\"7\"/>", style),
             words);
}

std::string dot_key(const std::string& style, const std::string& words) {
  return key(fmt::format("<circle class=\"{}\" cx=\"13\" cy=\"7\" r=\"5\"/>", style), words);
}

std::string legend(const std::string& keys) { return "<ul class=\"legend\">\n" + keys + "</ul>\n"; }

}  // namespace torquewright::report
