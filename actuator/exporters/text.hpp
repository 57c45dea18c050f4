// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::actuator {

/// Pieces of the files that are written, safe whatever the actuator is called.

/// Lines behind a mark ("# ", "// ").
std::string line_comment(const std::vector<std::string>& lines, std::string_view mark);

/// <!-- ... -->, in which no two hyphens may meet.
std::string xml_comment(const std::vector<std::string>& lines);

/// Returns the text in quotes, as the value of an XML attribute.
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
/// Returns the armature as an attribute of XML, with a space before it.
std::string armature_attribute(double armature_kg_m2);

/// A friction as an argument.
PythonArgument friction_argument(std::string_view name, double value);

/// What MuJoCo makes of a joint's damping and friction loss, as measured with 2.2.2 by
/// tests/actuator/exporters/mujoco_friction_test.cpp.
inline constexpr std::string_view kFrictionLoss =
    "damping and frictionloss are at the joint (XML reference, body/joint): Coulomb's friction in "
    "motion and at rest, by a soft constraint (Computation, friction loss): below it the joint "
    "creeps, and it is not full where the joint would come to rest within the constraint's time, "
    "which solreffriction sets to the least that MuJoCo's refsafe allows, two steps; its default "
    "is "
    "0.02 s.";

/// The constraint's time constant in s, and its damping ratio.
inline constexpr std::string_view kFrictionConstraint = "0.0001 1";

/// Returns kFrictionConstraint as an attribute with a space before it; empty where there is no
/// friction loss.
std::string friction_constraint(double frictionloss_Nm);

/// Returns the text as a literal of Python.
std::string python_string(std::string_view text);

/// Regular expressions of Python that match these names and nothing else, as literals behind
/// commas.
std::string python_expressions(std::span<const std::string> names);

/// A call of a class, kept under a name.
struct PythonCall {
  std::string variable;
  std::vector<PythonArgument> arguments;
};

/// Python that imports a configuration class from its module, and what else the calls name, and
/// calls it; `note` in front.
std::string python_configurations(const std::vector<std::string>& note, std::string_view module,
                                  std::string_view class_name, std::span<const PythonCall> calls,
                                  std::string_view also = "");

}  // namespace torquewright::actuator
