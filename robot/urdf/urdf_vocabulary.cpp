// SPDX-License-Identifier: Apache-2.0
// Names: the URDF XML specification (wiki.ros.org/urdf/XML); Drake's in "Notes on parsing"
// (drake.mit.edu); Gazebo's, ros2_control's, MuJoCo's, Bullet's, Isaac's and RaiSim's own
// extensions. What stands here neither way is no word of URDF's: urdfdom, and with it every reader,
// skips it.
#include "robot/urdf/urdf_vocabulary.hpp"

namespace torquewright::hopper {
std::span<const Words> urdf_words() {
  using enum Meaning;
  using enum Words::Kind;
  static constexpr Words kWords[] = {
      {"robot", kAttributes, kRead, "name"},
      {"robot", kAttributes, kNeutral, "version"},
      {"robot", kChildren, kRead, "link joint transmission gazebo"},
      {"robot", kChildren, kNeutral,
       "material sensor ros2_control mujoco drake:collision_filter_group group group_state "
       "disable_collisions link_collision_filter"},
      {"robot", kChildren, kRefused, "include", "put the file's content here"},
      {"robot", kChildren, kRefused,
       "xacro:include xacro:macro xacro:property xacro:if xacro:unless",
       "macros are not expanded here: run xacro first"},

      {"robot", kChildren, kRefused,
       "loop_joint drake:joint drake:linear_bushing_rpy drake:linear_spring_damper "
       "drake:ball_constraint drake:tendon_constraint force_element",
       "readers that know it add a joint, a loop or a force for it: leave it out, and state a "
       "mechanism where it closes a loop"},

      {"link", kAttributes, kRead, "name"},
      {"link", kAttributes, kNeutral, "type concave"},
      {"link", kChildren, kRead, "inertial"},
      {"link", kChildren, kNeutral,
       "visual collision self_filter self_collision_checking collision_checking contact material "
       "sensor"},

      {"inertial", kAttributes, kNeutral, "name"},
      {"inertial", kChildren, kRead, "origin mass inertia"},
      {"origin", kAttributes, kRead, "xyz rpy"},
      {"origin", kAttributes, kRefused, "quat_xyzw",
       "some readers turn the frame by it: state rpy"},
      {"mass", kAttributes, kRead, "value"},
      {"inertia", kAttributes, kRead, "ixx ixy ixz iyy iyz izz"},

      {"joint", kAttributes, kRead, "name type"},
      {"joint", kAttributes, kNeutral, "dont_collapse"},
      {"joint", kChildren, kRead, "parent child origin axis limit mimic dynamics"},
      {"dynamics", kAttributes, kRead, "damping friction rotor_inertia"},
      {"joint", kChildren, kNeutral,
       "safety_controller calibration hardwareInterface joint_properties"},
      {"joint", kChildren, kRefused, "drake:mimic drake:screw_thread_pitch",
       "readers that know it couple or turn the joint by it"},
      {"axis", kAttributes, kRead, "xyz"},
      {"limit", kAttributes, kRead, "lower upper effort velocity"},
      {"limit", kAttributes, kNeutral, "acceleration drake:acceleration jerk"},
  };
  return kWords;
}

}  // namespace torquewright::hopper
