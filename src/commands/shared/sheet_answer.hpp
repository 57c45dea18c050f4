// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "src/commands/shared/sheet_questions.hpp"

namespace torquewright::cli {

inline constexpr const char* kRatio = "/gearbox/ratio";
inline constexpr const char* kOfPhase = "phase";
inline constexpr const char* kOfTerminals = "line_to_line";

/// "> 93 mohm phase" as its number, its unit, the word behind it and what stands before it; or, in
/// the place of a ratio, the document of the gearbox that has it.
struct Typed {
  std::string file;
  double number = 0.0;
  std::string unit;        ///< As tables have it.
  std::string typed_unit;  ///< As it was typed.
  std::string word;        ///< Of a resistance: between which leads.
  std::string ampere;      ///< Of a torque constant: "rms", "peak" or empty.
  std::string bound;       ///< As documents have it; empty: none.
  std::string remark;      ///< What stands behind the unit and bears on nothing: "@ 25 degC".
  std::string fault;       ///< Why it is no number, as the end of a sentence; empty: it is one.
  bool is_about = false;   ///< The sheet says "about".
};

/// "48 V" and "20 A" of "48 V, 20 A", which is one answer to the first question; else the second is
/// empty.
std::pair<std::string, std::string> parts_of(const SheetQuestion& question,
                                             const std::string& answer);

Typed taken_apart(const SheetQuestion& question, const std::string& whole);

}  // namespace torquewright::cli
