// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/html_page.hpp"

#include <fmt/format.h>

#include "src/report/parts/dark_colours.hpp"
#include "src/report/parts/gnuplot.hpp"
#include "src/report/parts/svg.hpp"

namespace torquewright::report {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

}  // namespace
const char* const kPageStyle = R"(
:root{color-scheme:light dark;--link:#1f5fa8;--region:#e7eef6;--flight:#dcebf9;--violated:#f4b9b3;--ink:#1d2733;--soft:#5b6875;--line:#dde3e9;--paper:#fff;--shade:#f4f6f8;--good:#00795a;--part:#a35f00;--bad:#b3261e;--open:#49566b}
*{box-sizing:border-box}
body{margin:0;background:var(--shade);color:var(--ink);font:15px/1.5 "DejaVu Sans","Segoe UI",Helvetica,Arial,sans-serif}
main{max-width:1000px;margin:0 auto;padding:28px 24px 60px}
h1{font-size:22px;margin:0 0 4px}h2{font-size:18px;margin:0 0 10px}h3{font-size:14px;margin:22px 0 6px;color:var(--soft);text-transform:uppercase;letter-spacing:.05em}
p{margin:6px 0}.soft{color:var(--soft)}code,pre{font-family:"DejaVu Sans Mono",Consolas,monospace;font-size:13px}
section{background:var(--paper);border:1px solid var(--line);border-radius:8px;padding:20px 24px;margin-top:18px}
.badge{display:inline-block;padding:3px 12px;border-radius:14px;color:#fff;font-size:13px;vertical-align:3px;margin-left:8px}
.explained,.nothing_missing,.pass{background:var(--good)}.partly_explained{background:var(--part)}.unexplained,.fail{background:var(--bad)}.cannot_tell,.undecided{background:var(--open)}
.cards{display:flex;flex-wrap:wrap;gap:14px;margin-top:14px}.card{flex:1 1 180px;background:var(--shade);border-radius:6px;padding:10px 14px}
.card b{display:block;font-size:21px;font-weight:600}.card span{color:var(--soft);font-size:13px}
table{border-collapse:collapse;width:100%;font-size:14px}th{text-align:left;color:var(--soft);font-weight:500;border-bottom:2px solid var(--line);padding:5px 14px 5px 0}
td{border-bottom:1px solid var(--line);padding:6px 14px 6px 0;vertical-align:top}td.number{white-space:nowrap;font-variant-numeric:tabular-nums}
svg{max-width:100%;height:auto;display:block;margin:6px 0}pre{background:var(--shade);padding:12px 14px;border-radius:6px;overflow-x:auto}
.key{display:inline-block;width:12px;height:12px;border-radius:2px;vertical-align:-1px;margin:0 4px 0 12px}ul{margin:6px 0;padding-left:20px}
.drawn{overflow-x:auto}.drawn svg{border-radius:4px}
@media (prefers-color-scheme:dark){:root{--ink:#dde3ea;--soft:#a3afbb;--line:#39424c;--paper:#1b2027;--shade:#12161b;--good:#0a8f6c;--part:#a8690f;--bad:#e0635a;--open:#5d6b80;--link:#7fb2ff;--region:#233041;--flight:#1f3348;--violated:#70312c}}
@media (max-width:640px){main{padding:10px 8px 40px}section{padding:14px 12px}table{display:block;overflow-x:auto}.drawn svg{min-width:640px}}
@media print{body{background:#fff}section{break-inside:avoid}}
)";

std::string Pictures::draw(const std::string& script, const std::string& words) {
  if (script.empty()) return "";
  std::string svg = inline_svg(picture_by_gnuplot(script, option_), fmt::format("p{}_", ++count_));
  const std::string said = fmt::format("<svg role=\"img\" aria-label=\"{}\"", escaped(words));
  svg.replace(0, std::string_view("<svg").size(), said);
  return "<div class=\"drawn\">" + svg + "</div>\n";
}

std::string inline_svg(std::string svg, const std::string& prefix) {
  svg.erase(0, svg.find("<svg"));
  for (const char* use : {"id='", "id=\"", "url(#", "href='#", "href=\"#"}) {
    replace_all(svg, use, use + prefix);
  }
  replace_all(svg, fmt::format("#{} [", kCanvas), fmt::format("#{}{} [", prefix, kCanvas));
  return svg;
}

}  // namespace torquewright::report
