// SPDX-License-Identifier: Apache-2.0
#include "src/commands/shared/sheet_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include "io/text/letter_case.hpp"
#include "io/text/unit_spelling.hpp"
#include "src/commands/shared/printed_number.hpp"

namespace torquewright::cli {
namespace {

/// How sheets print a bound.
struct BoundMark {
  std::string_view mark;
  const char* bound;
};

constexpr BoundMark kBoundMarks[] = {
    {">=", "at_least"}, {">", "at_least"}, {"\u2265", "at_least"}, {"at least", "at_least"},
    {"<=", "at_most"},  {"<", "at_most"},  {"\u2264", "at_most"},  {"at most", "at_most"}};

constexpr std::string_view kAboutMarks[] = {"~",     "\u2248", "approx.", "approx",
                                            "about", "ca.",    "typ.",    "typ"};

/// How sheets say between which leads a resistance is.
struct LeadsWord {
  std::string_view printed;
  const char* word;
};

constexpr LeadsWord kLeadsWords[] = {{"phase to phase", kOfTerminals},
                                     {"phase-to-phase", kOfTerminals},
                                     {"phase-phase", kOfTerminals},
                                     {"line to line", kOfTerminals},
                                     {"line-to-line", kOfTerminals},
                                     {"line-line", kOfTerminals},
                                     {"terminal-terminal", kOfTerminals},
                                     {"line_to_line", kOfTerminals},
                                     {"terminal", kOfTerminals},
                                     {"l-l", kOfTerminals},
                                     {"phase to neutral", kOfPhase},
                                     {"phase-neutral", kOfPhase},
                                     {"line-neutral", kOfPhase},
                                     {"per phase", kOfPhase},
                                     {"phase", kOfPhase}};

std::string without_blanks_around(std::string text) {
  text.erase(0, text.find_first_not_of(' '));
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

/// The answer without the mark of a bound that it begins with.
std::string without_bound(const std::string& answer, Typed& typed) {
  for (const BoundMark& each : kBoundMarks) {
    if (!answer.starts_with(each.mark)) continue;
    typed.bound = each.bound;
    return without_blanks_around(answer.substr(each.mark.size()));
  }
  return answer;
}

std::string without_about(std::string answer, Typed& typed) {
  for (const std::string_view mark : kAboutMarks) {
    if (!answer.starts_with(mark)) continue;
    typed.is_about = true;
    return without_blanks_around(answer.substr(mark.size()));
  }
  return answer;
}

/// "9:1", "9 : 1" and "1:9" are 9.
void take_ratio(Typed& typed) {
  std::string unit = typed.unit;
  std::erase(unit, ' ');
  if (unit == ":1") typed.unit.clear();
  if (typed.number != 1.0 || !unit.starts_with(':') || unit == ":1") return;
  const PrintedNumber other = printed_number(unit.substr(1));
  if (!other.fault.empty() || !other.behind.empty()) return;
  typed.number = other.number;
  typed.unit.clear();
}

/// "mohm" and "phase" of "mohm (per phase)".
void take_leads(Typed& typed) {
  std::string small = io::in_small_letters(typed.unit);
  std::replace(small.begin(), small.end(), '(', ' ');
  std::erase(small, ')');
  small = without_blanks_around(small);
  for (const LeadsWord& each : kLeadsWords) {
    if (!small.ends_with(each.printed)) continue;
    typed.word = each.word;
    const std::size_t left = small.size() - each.printed.size();
    typed.unit = without_blanks_around(typed.unit.substr(0, left));
    return;
  }
}

/// "Nm/A" and "rms" of "Nm/Arms".
void take_ampere(Typed& typed) {
  for (const std::string_view ampere : {"rms", "peak"}) {
    if (!typed.unit.ends_with("_" + std::string(ampere))) continue;
    typed.ampere = ampere;
    typed.unit.erase(typed.unit.size() - ampere.size() - 1);
  }
}

/// "0.11 Nm/A" of "Kt = 0.11 Nm/A".
std::string without_symbol(const std::string& answer) {
  const std::size_t at = answer.find_first_of("=:");
  constexpr std::size_t kLongestSymbol = 16;
  if (at == answer.npos || at == 0 || at > kLongestSymbol) return answer;
  const bool is_symbol = std::isalpha(static_cast<unsigned char>(answer.front())) != 0;
  return is_symbol ? without_blanks_around(answer.substr(at + 1)) : answer;
}

/// What sheets say behind a number that says nothing of its size.
constexpr std::string_view kRemarks[] = {"@",    " at ",   " for ",     "\u00b1",  "+/-",
                                         "(max", "(peak",  "(rated",    "(nom",    " nom",
                                         " max", " rated", "planetary", "nominal", "(typ"};

/// "@ 25 \u00b0C" of "ohm @ 25 \u00b0C". Of a current "(peak)" says which ampere it is.
void take_remark(const SheetQuestion& question, Typed& typed) {
  const bool is_current = question.pointer.ends_with("_current_A");
  for (const std::string_view mark : kRemarks) {
    if (is_current && mark == "(peak") continue;
    const std::size_t at = typed.unit.find(mark);
    if (at == typed.unit.npos) continue;
    typed.remark = without_blanks_around(typed.unit.substr(at));
    typed.unit = without_blanks_around(typed.unit.substr(0, at));
  }
}

/// Of units that another question takes, or that no conversion leads from.
std::string fault_of_unit(const SheetQuestion& question, const Typed& typed) {
  if (question.pointer == "/drive/bus_voltage_V" && typed.unit == "S") {
    return fmt::format(
        "a count of cells; of lithium cells {:g} are {:.3g} V nominal, {:.3g} V full", typed.number,
        3.7 * typed.number, 4.2 * typed.number);
  }
  const bool is_kv = question.pointer == "/motor/velocity_constant_rpm_V";
  const double rpm_V = typed.unit == "V/krpm" ? 1e3 / typed.number : 1.0 / typed.number;
  if (is_kv && (typed.unit == "V/krpm" || typed.unit == "V/rpm") && std::isfinite(rpm_V)) {
    return fmt::format(
        "a back-EMF constant; where its volts are the amplitude between two leads, Kv is {:.4g} "
        "rpm/V",
        rpm_V);
  }
  return "";
}

}  // namespace

std::pair<std::string, std::string> parts_of(const SheetQuestion& question,
                                             const std::string& answer) {
  if (question.pointer != "/drive/bus_voltage_V") return {answer, ""};
  for (const std::string_view mark : {", ", " / "}) {
    const std::size_t at = answer.find(mark);
    if (at == std::string::npos) continue;
    return {answer.substr(0, at), without_blanks_around(answer.substr(at + mark.size()))};
  }
  return {answer, ""};
}

Typed taken_apart(const SheetQuestion& question, const std::string& whole) {
  Typed typed;
  if (question.pointer == kRatio && whole.ends_with(".json")) {
    typed.file = whole;
    return typed;
  }
  std::string answer = without_symbol(without_about(without_bound(whole, typed), typed));
  const bool is_kv = question.pointer == "/motor/velocity_constant_rpm_V";
  if (is_kv && io::in_small_letters(answer).starts_with("kv")) answer = answer.substr(2) + " KV";
  const PrintedNumber read = printed_number(without_blanks_around(answer));
  typed.number = read.number;
  typed.unit = without_blanks_around(read.behind);
  take_remark(question, typed);
  typed.fault = read.fault;
  if (question.pointer == kRatio) take_ratio(typed);
  if (question.pointer == "/motor/resistance_ohm") take_leads(typed);
  if (is_kv && io::in_small_letters(typed.unit) == "kv") typed.unit = "rpm/V";
  typed.typed_unit = typed.unit;
  typed.unit = io::unit_spelling(typed.unit);
  if (typed.fault.empty()) typed.fault = fault_of_unit(question, typed);
  if (question.pointer == "/motor/torque_constant_Nm_A") take_ampere(typed);
  return typed;
}

}  // namespace torquewright::cli
