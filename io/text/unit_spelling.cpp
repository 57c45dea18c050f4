// SPDX-License-Identifier: Apache-2.0
#include "io/text/unit_spelling.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "io/text/letter_case.hpp"

namespace torquewright::io {
namespace {

struct Spelling {
  std::string_view printed, here;
};

/// In any place. Greek letters have a sign each that looks like them.
constexpr Spelling kSigns[] = {
    {"\u03a9", "ohm"}, {"\u2126", "ohm"}, {"\u03bc", "u"}, {"\u00b5", "u"}, {"\u00b0", "deg"},
    {"\u00b2", "2"},   {"\u00b3", "3"},   {"\u00b9", "1"}, {"\u207b", "-"}, {"\u2212", "-"},
    {"\u2013", "-"},   {"\u2010", "-"},   {"\u2011", "-"}, {"\u00b7", "."}, {"\u22c5", "."},
    {"\u2219", "."},   {"\u2022", "."},   {"\u00d7", "."}, {"*", "."},      {"\u00a0", " "},
    {"\u202f", " "},   {"\u2009", " "},   {"^", ""},       {" ", ""},       {"(", ""},
    {")", ""},         {"[", ""},         {"]", ""}};

/// Of several parts.
constexpr Spelling kQuotients[] = {{"1000min-1", "krpm"}, {"1000rpm", "krpm"}, {"rev/min", "rpm"},
                                   {"r/min", "rpm"},      {"u/min", "rpm"},    {"1/min", "rpm"},
                                   {"min-1", "rpm"},      {"rot/s", "rev/s"}};

/// Of one part, in small letters.
constexpr Spelling kWords[] = {{"ohms", "ohm"},
                               {"mohms", "mohm"},
                               {"milliohm", "mohm"},
                               {"milliohms", "mohm"},
                               {"amp", "A"},
                               {"amps", "A"},
                               {"ampere", "A"},
                               {"amperes", "A"},
                               {"adc", "A"},
                               {"arms", "A_rms"},
                               {"aeff", "A_rms"},
                               {"apk", "A_peak"},
                               {"apeak", "A_peak"},
                               {"volt", "V"},
                               {"volts", "V"},
                               {"vdc", "V"},
                               {"sec", "s"},
                               {"secs", "s"},
                               {"second", "s"},
                               {"seconds", "s"},
                               {"msec", "ms"},
                               {"usec", "us"},
                               {"degree", "deg"},
                               {"degrees", "deg"},
                               {"turn", "rev"},
                               {"turns", "rev"},
                               {"celsius", "degC"},
                               {"kelvin", "K"},
                               {"watt", "W"},
                               {"watts", "W"},
                               {"nmm", "mNm"},
                               {"newtonmeter", "Nm"},
                               {"newtonmeters", "Nm"},
                               {"newtonmetre", "Nm"},
                               {"newtonmetres", "Nm"},
                               {"ozin", "ozf_in"},
                               {"ozfin", "ozf_in"},
                               {"inoz", "ozf_in"},
                               {"inozf", "ozf_in"},
                               {"lbin", "lbf_in"},
                               {"lbfin", "lbf_in"},
                               {"inlb", "lbf_in"},
                               {"inlbf", "lbf_in"},
                               {"lbft", "lbf_ft"},
                               {"lbfft", "lbf_ft"},
                               {"ftlb", "lbf_ft"},
                               {"ftlbf", "lbf_ft"},
                               {"ftlbs", "lbf_ft"},
                               {"kgcm", "kgf_cm"},
                               {"kgfcm", "kgf_cm"},
                               {"ozins2", "ozf_in_s2"},
                               {"ozinsec2", "ozf_in_s2"},
                               {"ozfins2", "ozf_in_s2"},
                               {"lbins2", "lbf_in_s2"},
                               {"ozin2", "oz_in2"},
                               {"lbin2", "lb_in2"}};

/// In these capitals.
constexpr Spelling kAsPrinted[] = {{"NM", "Nm"}, {"mNM", "mNm"}};

/// The same in small letters, where capitals mean nothing else.
constexpr std::string_view kAnyCapitals[] = {"ohm", "rpm", "krpm", "deg", "rad", "gcm2", "kgm2"};

void replace_all(std::string& text, const Spelling& each) {
  for (std::size_t at = text.find(each.printed); at != text.npos;
       at = text.find(each.printed, at + each.here.size())) {
    text.replace(at, each.printed.size(), each.here);
  }
}

bool is_digit_at(const std::string& text, std::size_t at) {
  return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
}

/// "Nm" of "N.m" and "ozin" of "oz-in"; the sign of a power and the point of a number stay.
std::string without_joints(const std::string& text) {
  std::string kept;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_joint = text[i] == '.' || text[i] == '-';
    if (!is_joint || is_digit_at(text, i + 1)) kept += text[i];
  }
  return kept;
}

std::string word_spelling(const std::string& printed) {
  for (const Spelling& each : kAsPrinted) {
    if (each.printed == printed) return std::string(each.here);
  }
  const std::string small = in_small_letters(printed);
  if (printed.starts_with('M') && small != "min") return printed;  // Mega, not milli.
  for (const Spelling& each : kWords) {
    if (each.printed == small) return std::string(each.here);
  }
  const bool is_one =
      std::find(std::begin(kAnyCapitals), std::end(kAnyCapitals), small) != std::end(kAnyCapitals);
  if (is_one) return small;
  return small == "mohm" ? small : printed;
}

}  // namespace

std::string unit_spelling(std::string_view printed) {
  std::string text(printed);
  for (const Spelling& each : kSigns) replace_all(text, each);
  text = without_joints(text);
  std::string small = in_small_letters(text);
  for (const Spelling& each : kQuotients) {
    const std::size_t at = small.find(each.printed);
    if (at == small.npos) continue;
    text.replace(at, each.printed.size(), each.here);
    small = in_small_letters(text);
  }
  std::string spelt;
  std::size_t from = 0;
  while (true) {
    const std::size_t until = std::min(text.find('/', from), text.size());
    spelt += word_spelling(text.substr(from, until - from));
    if (until == text.size()) return spelt;
    spelt += '/';
    from = until + 1;
  }
}

}  // namespace torquewright::io
