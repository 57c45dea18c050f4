// SPDX-License-Identifier: Apache-2.0
// Names: MuJoCo's XML reference (mujoco.readthedocs.io, XMLreference).
#include "robot/mjcf/mjcf_vocabulary.hpp"

namespace torquewright::hopper {
namespace {

constexpr const char* kDrives =
    "motor general position velocity intvelocity damper cylinder muscle adhesion";

}  // namespace

std::span<const Words> mjcf_words() {
  using enum Meaning;
  using enum Words::Kind;
  static constexpr Words kWords[] = {
      {"mujoco", kAttributes, kRead, "model"},
      {"mujoco", kChildren, kRead,
       "compiler option default worldbody equality actuator tendon keyframe"},
      {"mujoco", kChildren, kNeutral,
       "asset contact sensor visual statistic custom size extension"},
      {"mujoco", kChildren, kRefused, "deformable", "bodies that bend are no rigid bodies"},

      {"keyframe", kChildren, kRead, "key"},
      {"key", kAttributes, kRead, "name qpos"},
      {"key", kAttributes, kNeutral, "time qvel act ctrl mpos mquat"},

      {"compiler", kAttributes, kRead,
       "angle eulerseq autolimits inertiafromgeom inertiagrouprange boundmass boundinertia "
       "balanceinertia settotalmass coordinate"},
      {"compiler", kAttributes, kNeutral,
       "strippath meshdir texturedir assetdir discardvisual fusestatic convexhull fitaabb "
       "usethread "
       "saveinertial exactmeshinertia conflict"},
      {"compiler", kAttributes, kRefused, "alignfree", "it moves the frames of free bodies"},
      {"compiler", kChildren, kNeutral, "lengthrange"},

      {"option", kAttributes, kRead, "gravity"},
      {"option", kAttributes, kForce, "wind density viscosity"},
      {"option", kAttributes, kNeutral,
       "timestep apirate impratio tolerance ls_tolerance noslip_tolerance ccd_tolerance "
       "mpr_tolerance "
       "sleep_tolerance magnetic o_margin o_solref o_solimp o_friction integrator collision cone "
       "jacobian solver iterations ls_iterations noslip_iterations ccd_iterations mpr_iterations "
       "sdf_iterations sdf_initpoints actuatorgroupdisable"},
      {"option", kChildren, kRead, "flag"},
      {"flag", kAttributes, kRead,
       "gravity equality frictionloss constraint passive spring damper"},
      {"flag", kAttributes, kNeutral,
       "limit contact clampctrl warmstart "
       "filterparent actuation refsafe sensor midphase eulerdamp autoreset nativeccd island "
       "override "
       "energy fwdinv invdiscrete multiccd sensornoise sleep diagexact"},

      {"worldbody", kAttributes, kNeutral, "name"},
      {"worldbody", kChildren, kRead, "body frame"},
      {"worldbody", kChildren, kNeutral, "geom plugin"},
      {"worldbody", kChildren, kNeutral, "site camera light"},
      {"worldbody", kChildren, kRefused, "replicate composite flexcomp attach",
       "expand it first: MuJoCo does when it saves the model"},

      {"body", kAttributes, kRead, "name childclass pos quat axisangle xyaxes zaxis euler"},
      {"body", kAttributes, kForce, "gravcomp"},
      {"body", kAttributes, kNeutral, "user sleep"},
      {"body", kAttributes, kRefused, "mocap", "what moves by hand is no robot"},
      {"body", kChildren, kRead, "body frame joint freejoint inertial geom"},
      {"body", kChildren, kNeutral, "site camera light"},
      {"body", kChildren, kForce, "plugin"},
      {"body", kChildren, kRefused, "replicate composite flexcomp attach",
       "expand it first: MuJoCo does when it saves the model"},

      {"frame", kAttributes, kRead, "name childclass pos quat axisangle xyaxes zaxis euler"},
      {"frame", kChildren, kRead, "body frame joint freejoint geom"},
      {"frame", kChildren, kNeutral, "site camera light"},
      {"frame", kChildren, kForce, "plugin"},
      {"frame", kChildren, kRefused, "inertial", "put it into the body itself"},
      {"frame", kChildren, kRefused, "replicate composite flexcomp attach",
       "expand it first: MuJoCo does when it saves the model"},

      {"freejoint", kAttributes, kRead, "name"},
      {"freejoint", kAttributes, kNeutral, "group"},
      {"freejoint", kAttributes, kRefused, "align", "it moves the body's frame"},

      {"joint", kAttributes, kRead,
       "name class type pos axis ref range limited armature actuatorfrcrange actuatorfrclimited "
       "stiffness springref damping frictionloss"},
      {"joint", kAttributes, kForce, "springdamper"},
      {"joint", kAttributes, kNeutral,
       "group solreflimit solimplimit solreffriction solimpfriction margin user "
       "actuatorgravcomp"},

      {"inertial", kAttributes, kRead,
       "pos quat axisangle xyaxes zaxis euler mass diaginertia fullinertia"},

      // Of shapes whose mass counts; others are left behind.
      {"geom", kAttributes, kRead,
       "name class type pos quat axisangle xyaxes zaxis euler fromto size mass density group"},
      {"geom", kAttributes, kNeutral,
       "contype conaffinity condim priority friction solmix solref solimp margin gap material rgba "
       "user"},
      {"geom", kAttributes, kForce, "fluidshape fluidcoef"},
      {"geom", kAttributes, kRefused, "mesh hfield fitscale",
       "no mesh is opened; state <inertial>"},
      {"geom", kAttributes, kRefused, "shellinertia", "state <inertial>"},

      {"connect", kAttributes, kRead, "name class body1 body2 anchor site1 site2 active"},
      {"connect", kAttributes, kNeutral, "solref solimp"},

      {"tendon", kChildren, kRead, "fixed spatial"},
      {"fixed", kAttributes, kForce, "stiffness damping frictionloss"},
      {"fixed", kAttributes, kNeutral,
       "name class group limited range actuatorfrclimited actuatorfrcrange solreflimit solimplimit "
       "solreffriction solimpfriction margin springlength width rgba material user"},
      {"fixed", kAttributes, kRefused, "armature", "it couples joints by mass"},
      {"fixed", kChildren, kNeutral, "joint"},
      {"spatial", kAttributes, kForce, "stiffness damping frictionloss"},
      {"spatial", kAttributes, kNeutral,
       "name class group limited range actuatorfrclimited actuatorfrcrange width material rgba "
       "solreflimit solimplimit solreffriction solimpfriction margin springlength user"},
      {"spatial", kAttributes, kRefused, "armature", "it couples joints by mass"},
      {"spatial", kChildren, kNeutral, "site geom pulley"},

      // None of what drives has mass.
      {"actuator", kChildren, kRead, kDrives},
      {"actuator", kChildren, kRefused, "plugin dcmotor", "state its limits at the joint"},
      {kDrives, kAttributes, kRead,
       "name class joint jointinparent tendon body site cranksite slidersite refsite gear "
       "ctrlrange "
       "ctrllimited forcerange forcelimited"},
      {kDrives, kAttributes, kNeutral, "group lengthrange cranklength user nsample interp delay"},
      {"general", kAttributes, kRead, "dyntype gaintype biastype gainprm"},
      {"general", kAttributes, kNeutral, "actlimited actrange actdim dynprm biasprm actearly"},
      {"position", kAttributes, kNeutral, "kp kv dampratio timeconst inheritrange"},
      {"velocity damper", kAttributes, kNeutral, "kv"},
      {"intvelocity", kAttributes, kNeutral, "kp kv dampratio actrange actlimited inheritrange"},
      {"cylinder", kAttributes, kNeutral, "timeconst area diameter bias"},
      {"muscle", kAttributes, kNeutral,
       "timeconst tausmooth range force scale lmin lmax vmax fpmax fvmax"},
      {"adhesion", kAttributes, kNeutral, "gain"},
  };
  return kWords;
}

}  // namespace torquewright::hopper
