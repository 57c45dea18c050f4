// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/example_commands.hpp"

#include <sstream>

namespace torquewright::fuzz {
namespace {

const char* const kLines = R"(
gearbox optimize specs/gearbox/d151_knee.json --verify --draw knee.svg -o result.json
gearbox optimize specs/gearbox/d110a_ankle.json --top 3 --json
gearbox optimize specs/gearbox/d110a_ankle.json --all
gearbox optimize specs/gearbox/knee_synthesis.json --max-nodes 300 -o result.json
gearbox optimize specs/gearbox/finger_joint.json --relaxation never --max-nodes 200
gearbox optimize specs/gearbox/knee_choices.json --time-limit 2 --top 2 -o result.json
gearbox optimize specs/gearbox/slewing_drive.json --time-limit 1 --max-nodes 100 --relaxation always
gearbox evaluate specs/gearbox/d151_knee.json --teeth 24,48,28 -o result.json --draw knee.svg
gearbox evaluate specs/gearbox/d151_knee.json --teeth 44,44,32,132,120 --rank --json
gearbox evaluate specs/gearbox/d110a_ankle.json --teeth 18,54 --planet-count 3 -o result.json
gearbox evaluate specs/gearbox/knee_choices.json --teeth 44,44,32 --planet-count 4 --module 0.6
gearbox pareto specs/gearbox/d151_knee.json --objectives paper_cost,forward_efficiency --plot front.svg -o front.json
design specs/robot/hopper.json specs/trajectory/hopper_flip.csv --drive knee --gearbox specs/gearbox/d151_knee.json --motors specs/actuator --ratios 18:20 -o design.json
gearbox pareto specs/gearbox/knee_synthesis.json --objectives mass,hollow_shaft --points 2 --time-limit 1 --json
gearbox verify specs/gearbox/d151_knee_result.json
gearbox verify tests/fuzz/corpus/result_conflict.json --json
gearbox verify tests/fuzz/corpus/result_two_designs.json
gearbox verify tests/fuzz/corpus/result_planetary.json --json
gearbox drawing specs/gearbox/d151_knee_result.json --dxf gears.dxf --svg gears.svg
gearbox drawing specs/gearbox/d151_knee_result.json --step gears.step --face-width 10,9 --bore planet_1=6,planet_2=6
gearbox tolerances specs/gearbox/d151_knee_result.json --centre-distance 0.01 --tooth-thickness -0.06:-0.03,sun=-0.05:-0.02 --draws 200 --min-yield 0.9 --json
gearbox strength specs/gearbox/d110a_strength.json --torque 21 --side motor
gearbox strength specs/gearbox/d151_strength.json --torque 21,17 --face-widths 6,8 --modules 0.5,0.6 --json
gearbox strength specs/gearbox/d151_knee_result.json --steel case_hardened --face-width 10 --torque 16 --cycles 1e6 --design 1
actuator mor specs/actuator/d151_knee.json --at-speed 0,8,9.5,11
actuator mor specs/actuator/mini_cheetah_knee.json
actuator mor specs/actuator/d151_knee.json --table --side motor
actuator mor specs/actuator/d151_knee.json --need 200@10 --ratio 4:40 --json
actuator mor specs/actuator/d151_knee.json --need 100@5
actuator mor specs/actuator/d151_knee.json --need 2kN@0.3m/s --lever 0.1
actuator find --need 20N@95rpm --lever 0.2
actuator mor tests/fuzz/corpus/everything.json --need 200@10
actuator mor specs/actuator/d110a_ankle.json --ratio 4:40
actuator mor specs/actuator/d151_knee.json --compare specs/actuator/d110a_ankle.json --json
actuator mor specs/actuator/d151_knee.json --format mujoco --export knee.xml
actuator mor specs/actuator/ak80_9.json --format isaac-lab --fit best
actuator mor specs/actuator/ak80_9.json --for isaac-lab-2.3
actuator mor specs/actuator/ak80_9.json --format physx --bus-voltage 40 --export out.usda
actuator mor specs/actuator/mini_cheetah_knee.json --format urdf --json
actuator mor specs/actuator/d151_knee.json --format drake --rating continuous
actuator mor specs/actuator/cassie_knee.json --side motor --winding-temperature 350 --accuracy 0.01
actuator mor specs/actuator/d151_knee.json -o table.csv --plot region.svg --plot-voltage 60,48 --plot-temperature 350
actuator mor specs/log/bench_refined.json -o table.json
actuator find --need 60@10,100@5 --continuous 20 --mass-below 2 --json
actuator find --need 60@10 --ratio 4:40 --in specs/actuator -o drives.json
actuator lint specs/actuator/d151_knee.json specs/actuator/d110a_ankle.json
actuator lint specs/actuator/ak80_9.json --json
actuator check specs/trajectory/knee_extension.csv --joint knee=specs/actuator/d151_knee.json -o report.json --plot motion.svg
actuator check specs/trajectory/knee_extension.csv --joint knee=specs/actuator/d151_knee.json --repeat 10 --pause 2 --bus-voltage 50 --json
actuator check specs/trajectory/bench_lift.csv --joint knee=specs/log/bench_actuator.json --torque-includes-inertia --from 0.1 --until 0.8
actuator check specs/trajectory/bench_lift.csv --joint knee=specs/log/bench_actuator.json --column knee_torque_Nm=knee.torque:Nm*1.1 --torque-excludes-inertia
hopper check specs/robot/hopper.json specs/trajectory/hopper_flip.csv --all
hopper check specs/robot/hopper.json tests/fuzz/corpus/hopper_leap.csv --json --load-window 0.02 --left-out-share 0.02 --repeat 3 --pause 1 --ground-height 0 --contact-height 0.002
hopper check specs/robot/hopper.json tests/fuzz/corpus/hopper_leap.csv --series flip.csv -o report.json --report flip.html
hopper check specs/robot/hopper.json tests/fuzz/corpus/hopper_leap.csv --candidates specs/actuator --threads 2 --ratios 8:9 --figures flip.svg
hopper check specs/robot/rabbit.json tests/fuzz/corpus/rabbit_leap.csv --residual-limit 0.1 --contact-speed 0.1
hopper check specs/robot/hopper.json tests/fuzz/corpus/hopper_leap.csv --plot a.svg --plot-loads b.svg --torques dynamics
hopper check specs/robot/hopper.json specs/trajectory/hopper_hop.csv --plot-momentum c.svg --from 0.3
hopper check specs/robot/hopper.json tests/fuzz/corpus/hopper_leap.csv --sweep knee_ratio=18:22:2 --sweep voltage=60,67.2 --jobs 2 -o map.json --plot-sweep map.svg --json
hopper check specs/robot/hopper.json specs/trajectory/hopper_squat.csv --sweep mass_factor=0.9:1.1:0.1 --jobs 1 --sweep-journal checks.journal
hopper flip specs/robot/hopper.json -o plan.csv --task jump --contacts flat,flight,flat --objective effort=2 --intervals 10 --rounds 0 --iterations 3 --time-limit 20 --voltage-margin 0.1 --guess-noise 0.05 --seed 2 --write-best best.csv --plot-momentum d.svg --figures e.svg --report f.html --json
hopper flip specs/robot/hopper.json -o plan.csv --task jump --intervals 20 --integration-error 0.1 --bus-voltage 60 --sample-step 0.005 --plot-momentum d.svg --figures e.svg --report f.html
hopper flip specs/robot/hopper.json -o plan.csv --task hop --warm specs/trajectory/hopper_hop.csv --contacts flat,flight,flat --limits box --time-limit 1 --intervals 10 --sample-step 0.01
hopper flip specs/robot/hopper.json -o plan.csv --task jump --contacts flat,flight,flat --explain --intervals 10 --rounds 0 --integration-error 0.1 --time-limit 3 --bus-voltage 60 --sample-step 0.01 --figures e.svg
hopper flip specs/robot/hopper.json -o plan.csv --task flip --longest-first 1.2 --longest-push-off 0.3 --longest-flight 0.9 --longest-landing 0.6 --longest-last 1.1 --center-of-pressure-margin 0.2 --friction-margin 0.3 --gear-margin 0.2 --position-margin 0.1 --speed-margin 0.1 --integration-error 0.01 --intervals 10 --rounds 1 --reserve 0.02 --capture-point-margin 0.1 --flight-position-margin 0.1 --time-limit 0.5 --write-best best.csv --report f.html
hopper flip specs/robot/hopper.json -o plan.csv --task flip --longest-first 1.2 --longest-push-off 0.3 --longest-flight 0.9 --longest-landing 0.6 --longest-last 1.1 --center-of-pressure-margin 0.2 --friction-margin 0.3 --gear-margin 0.2 --position-margin 0.1 --speed-margin 0.1 --integration-error 0.01 --intervals 10 --rounds 1 --time-limit 0.5 --write-best best.csv --report f.html
hopper flip specs/robot/hopper.json -o plan.csv --task hop --stride 0.3 --speed 0.8 --repeat 2 --alike --land-at 0,0.085 --edge-margin 0.02 --longest-between 0.5 --intervals 10 --rounds 0 --iterations 2 --write-best best.csv
hopper flip specs/robot/hopper.json -o flips.json --task hop --stride 0.2 --rise 0.05 --sweep knee_ratio=18:22:4 --sweep voltage=60,67.2 --jobs 2 --contacts flat,flight,flat --intervals 10 --rounds 0 --iterations 2 --time-limit 20 --plot-sweep flips.svg --sweep-journal flips.journal --json
hopper flip specs/robot/hopper.json -o flips.json --task jump --sweep knee_ratio=20:20 --trials 1 --randomise specs/randomisation/hopper.json --trial-seed 3 --controller pd --engine own --intervals 10 --rounds 0 --iterations 2
hopper replay specs/robot/hopper.json specs/trajectory/hopper_squat.csv --step 0.0005 --stand 0.2 --push 0.1@0.3 --push calf:0,0,0.1@0.5 --json
hopper replay specs/robot/hopper.json tests/fuzz/corpus/hopper_leap.csv --from 0.75 --step 0.0005 --stand 0.1 --limits box --controller pd --impact invariant --impact-metric inertia --latency 0.001 --series run.csv -o run.json
hopper replay specs/robot/hopper.json specs/trajectory/hopper_squat.csv --step 0.0005 --stand 0.1 --trials 2 --randomise specs/randomisation/hopper.json --seed 3 --success-rate 0.5 --threads 2 --no-filter --flight-tolerance 0.3 --place-tolerance 0.1 --rotation-tolerance 0.4 --heading-tolerance 0.3 --ground-time-constant 0.002 --joint-tolerance 0.2 --slide-tolerance 0.1 --speed-tolerance 0.2
hopper replay specs/robot/hopper.json specs/trajectory/hopper_squat.csv --step 0.001 --control-period 0.001 --stand 0 --until 0.2 --controller osc --tasks specs/controller/hopper.json
hopper replay specs/robot/hopper.json specs/trajectory/hopper_squat.csv --step 0.0005 --stand 0 --until 0.2 --trials 3 --randomise specs/randomisation/hopper.json --jobs 2 --trial 1 --sweep-journal trials.journal -o trials.json --report trials.html
hopper calibrate specs/robot/hopper.json --target cam=6.0 --target cav=7.4:10.6 --free /bodies/0/inertia_kg_m2/yy,/bodies/0/inertia_kg_m2/xx=0.05:0.45 --free /postures/takeoff/knee --free /postures/tuck/knee --refined fitted.json --plot valley.svg
hopper calibrate specs/robot/hopper.json --target cam=6 --target cav@stretched=6 --posture stretched=knee:0.1,ankle_pitch:0.3 --free /bodies/0/inertia_kg_m2/yy=0.05:0.45 --tolerance 0.005 --json
identify specs/log/bench_as_built.csv --rig specs/log/bench_rig.json --actuator specs/log/bench_actuator.json --refined refined.json --report report.html
identify tests/fuzz/corpus/measured.csv --rig tests/fuzz/corpus/measured_rig.json --actuator specs/actuator/d151_knee.json --json
identify tests/fuzz/corpus/measured.csv --rig tests/fuzz/corpus/measured_rig.json --actuator specs/actuator/d151_knee.json --refined refined.json --only coulomb_friction,viscous_friction --tolerance 0.1 --empirical
identify residual tests/fuzz/corpus/measured.csv --rig tests/fuzz/corpus/measured_rig.json --actuator specs/actuator/d151_knee.json --json
identify residual specs/log/bench_as_built.csv --rig specs/log/bench_rig.json --actuator specs/log/bench_actuator.json
identify plan specs/log/bench_actuator.json --rig specs/log/bench_rig.json --separate coulomb_friction,viscous_friction --duration 8 -o excitation.csv
identify plan specs/actuator/d151_knee.json --rig specs/rig/dynamometer_knee.json --separate coulomb_friction,load_dependent_friction --speed-limit 5 --noise output_torque_Nm=0.2 --seed 3 --json
identify simulate specs/actuator/d151_knee.json --rig specs/rig/knee_sweep.json --excitation specs/excitation/knee_sweep.csv --noise output_torque_Nm=0.2 --seed 7 -o log.csv
identify import moteus specs/log/wheel_moteus.csv -o imported
identify import sysid tests/fuzz/corpus/imports/arm_sysid.json -o imported
identify import sysid_csv tests/fuzz/corpus/imports/lift_sysid.csv --units Rotations -o imported
identify import bam tests/fuzz/corpus/imports/pendulum_bam.json -o imported
identify import ros tests/fuzz/corpus/imports/legs_ros.csv --joint 1 -o imported
identify import mcap tests/fuzz/corpus/imports/legs.mcap --topic /joint_states --commands /joint_commands --joint *_joint --clock recorder -o imported
identify import odrive tests/fuzz/corpus/imports/axes_odrive.csv --joint axis0 -o imported
hopper train specs/robot/planar_leg.json --task hop --limits box --engine own --seconds 1 --iterations 1 --seed 2 --threads 2 --judge-every 1 --judge-runs 1 -o hop.json --curve hop.csv
hopper train specs/robot/hopper.json --task specs/training_task/stand.json --randomise specs/randomisation/hopper.json --curriculum --bus-voltage 60 --seconds 0.1 --iterations 1 -o stand.json
hopper train specs/robot/hopper.json --task flip --reference specs/trajectory/hopper_flip.csv --seconds 0.1 --iterations 1 --judge-runs 1 -o flip.json
hopper replay specs/robot/hopper.json specs/policy/upright.json --task stand --forward 0.1
policy export specs/policy/upright.json --format onnx -o upright.onnx
policy export specs/policy/upright.json --format c
policy import specs/policy/trained_elsewhere.onnx --observations gravity_x,gravity_z,base_pitch_rate_rad_s,knee_rad,ankle_rad,knee_rad@1,ankle_rad@1 --actions knee_target_rad,ankle_target_rad --control-period 0.02 --offset 1.1,-0.1 --scale 0.7 --stiffness knee=150,ankle=100 --damping knee=5,ankle=3 -o policy.json
policy import specs/policy/trained_elsewhere.onnx --like specs/policy/upright.json --node actions --observations a,b,c,d,e,f,g --actions knee_target_rad,ankle_target_rad
robot import specs/robot/rabbit.urdf -o rabbit.json
robot import tests/fuzz/corpus/hopper.xml --format mjcf --free-couplings --mend-inertias --drop-base-armature
robot import tests/fuzz/corpus/looped.xml -o opened.json --open-loop knee_rod --actuator ankle_left=specs/actuator/d110a_ankle.json --actuator ankle_right=specs/actuator/d110a_ankle.json --massless-links
robot import tests/fuzz/corpus/looped.xml -o looped.json --actuator knee=specs/actuator/d151_knee.json --actuator ankle_left=specs/actuator/d110a_ankle.json --actuator ankle_right=specs/actuator/d110a_ankle.json --massless-links --link-error 0.1
robot import tests/fuzz/corpus/looped.xml -o looped.json --actuators drives --feet heel_left --feet toe_*=0:0.1,-0.02:0.02,0
robot workspace specs/robot/hopper.json --joint ankle_roll --plot ankle.svg
robot export specs/robot/hopper.json --format mjcf --actuators --ground --collisions --closed-loops -o hopper.xml
robot check specs/robot/hopper.json tests/fuzz/corpus/hopper_leap.csv
robot replay specs/robot/hopper.json specs/trajectory/hopper_squat.csv --step 0.0005 --stand 0.1 --until 0.2
robot patch specs/robot/rabbit.urdf *_knee=specs/actuator/d151_knee.json -o patched.urdf
robot attach specs/robot/planar_leg.json knee=specs/actuator/d151_knee.json -o leg.json
robot export specs/robot/cassie.json --format urdf
robot export specs/robot/rabbit.json --format urdf -o rabbit.urdf
robot export specs/robot/cassie.json --format isaac-lab --actuators -o cassie.py
robot export specs/robot/mini_cheetah.json --format newton --actuators
robot export specs/robot/hopper.json --format genesis --actuators --randomise specs/randomisation/hopper.json
robot export specs/robot/hopper.json --format mjlab --actuators --randomise tolerances
robot export specs/robot/hopper.json --format mjcf --actuators --servos -o servos.xml
robot export specs/robot/cassie.json --format gazebo --actuators --friction limits -o cassie.sdf
robot export specs/robot/cassie.json --format drake
actuator lint specs/catalogue/damiao_j4340.json --current 8
robot export specs/robot/hopper.json --format isaac-lab --actuators --randomise specs/randomisation/hopper.json
robot export specs/robot/hopper.json --format playground --actuators --randomise specs/randomisation/hopper.json -o hopper.py
init actuator -o new.json
init robot --all-keys -o all.json
init actuator --envelope -o curve.json
init gearbox_problem --synthesis --all-keys -o sized.json
init actuator --from cubemars_ak80_9
init rig --from specs/log/bench.csv -o new_rig.json
init robot --explain
schema gearbox_problem
man hopper flip -o flip.1
man --all specs/rig
help gearbox optimize
completion bash -o completion.sh
)";

std::vector<Words> read_lines() {
  std::vector<Words> commands;
  std::istringstream lines(kLines);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream stream(line);
    Words words;
    for (std::string word; stream >> word;) words.push_back(word);
    if (!words.empty()) commands.push_back(words);
  }
  return commands;
}

}  // namespace

const std::vector<Words>& example_commands() {
  static const std::vector<Words> commands = read_lines();
  return commands;
}

}  // namespace torquewright::fuzz
