// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace torquewright::actuator {

/// Pieces of the files that are written, safe whatever the actuator is called.

/// Lines behind a mark ("# ", "// ").
std::string line_comment(const std::vector<std::string>& lines, std::string_view mark);

/// A comment of C, which ends nowhere inside.
std::string block_comment(const std::vector<std::string>& lines);

/// <!-- ... -->, in which no two hyphens may meet.
std::string xml_comment(const std::vector<std::string>& lines);

/// In quotes, as the value of an XML attribute.
std::string xml_quoted(std::string_view text);

/// A name that C++, Python and USD accept: other characters become underscores.
std::string identifier(std::string_view text);

/// An argument of a Python call, its value as Python writes it.
struct PythonArgument {
  std::string_view name;
  std::string value;
  bool is_yours = false;  ///< What only the user knows: marked as such.
};
/// An empty value leaves the argument out.
PythonArgument python_argument(std::string_view name, double value);

/// The armature, left out where the document states no inertia: nobody measured a 0.
PythonArgument armature_argument(double armature_kg_m2);
/// The same as an attribute, with a space before it.
std::string armature_attribute(double armature_kg_m2);

/// Python that imports a configuration class from its module and calls it; `note` in front.
std::string python_configuration(const std::vector<std::string>& note, std::string_view module,
                                 std::string_view class_name, std::string_view variable,
                                 const std::vector<PythonArgument>& arguments);

}  // namespace torquewright::actuator
