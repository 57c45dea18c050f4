#include <fmt/format.h>
#include <cstdlib>
#include <cmath>
#include "hopper/flip/plan.hpp"
#include "hopper/flip/plan_setup.hpp"
#include "hopper/robot/robot_spec.hpp"
using namespace torquewright; using namespace torquewright::hopper;
static double env(const char* n, double d){ const char* v=getenv(n); return v?atof(v):d; }
static void csv(const Motion& m, const char* file){
  FILE* f=fopen(file,"w");
  fprintf(f,"time_s,base_x_position_m,base_y_position_m,base_z_position_m,base_qw_position,base_qx_position,base_qy_position,base_qz_position,knee_position_rad,ankle_pitch_position_rad,ankle_roll_position_rad,base_x_velocity_m_s,base_y_velocity_m_s,base_z_velocity_m_s,base_angular_x_velocity_rad_s,base_angular_y_velocity_rad_s,base_angular_z_velocity_rad_s,knee_velocity_rad_s,ankle_pitch_velocity_rad_s,ankle_roll_velocity_rad_s,base_x_acceleration_m_s2,base_y_acceleration_m_s2,base_z_acceleration_m_s2,base_angular_x_acceleration_rad_s2,base_angular_y_acceleration_rad_s2,base_angular_z_acceleration_rad_s2,knee_acceleration_rad_s2,ankle_pitch_acceleration_rad_s2,ankle_roll_acceleration_rad_s2,heel_left_contact,heel_right_contact,toe_left_contact,toe_right_contact\n");
  for(Eigen::Index i=0;i<m.samples();++i){ fprintf(f,"%.17g",m.time_s(i)); for(auto*t:{&m.positions,&m.velocities,&m.accelerations,&m.touching}) for(double x: t->col(i)) fprintf(f,",%.17g",x); fprintf(f,"\n"); }
  fclose(f);
}
int main(int,char**argv){
  auto robot = read_robot(argv[1]).robot;
  PlanOptions o;
  if (env("BOX",0)) o.limits=DriveLimits::kBox;
  o.task = env("TASK",0)==1?PlanTask::kJump:env("TASK",0)==2?PlanTask::kHop:PlanTask::kFlip;
  o.margins.voltage=env("VM",o.margins.voltage); o.margins.current=env("CM",o.margins.current); o.margins.friction=env("FM",o.margins.friction); o.margins.center_of_pressure=env("COP",o.margins.center_of_pressure); o.margins.gear_load=env("GM",o.margins.gear_load);
  o.margins.position_rad=env("PM",o.margins.position_rad); o.guess_noise_rad=env("NOISE",0); o.guess_seed=(unsigned)env("SEED",0); o.intervals=(int)env("N",100); o.most_seconds=env("TL",120); o.most_rounds=(int)env("ROUNDS",6);
  if (getenv("V")) o.on_progress=[](const PlanProgress& p){ if(p.iteration%10==0) {fmt::print("  r{} it {} n {} obj {:.5f} viol {:.2e}\n",p.round,p.iteration,p.intervals,p.objective,p.largest_violation);fflush(stdout);} };
  auto r=plan_motion(robot,o);
  fmt::print("{}: {}\n",name_of(r.status),r.reason);
  for(auto&x:r.rounds) fmt::print("round n {} it {} {} obj {:.6f} viol {:.2e} err {:.2e} {:.1f} s (deriv {:.1f})\n",x.intervals,x.iterations,x.solver,x.objective,x.largest_violation,x.integration_error_rad,x.seconds,x.derivative_seconds);
  for(auto&b:r.binding) fmt::print("binds {} {} {}/{} viol {}\n",b.stance,b.name,b.instants,b.of,b.violation);
  for(auto&ph:r.plan.phases) { fmt::print("{} {:.4f}..{:.4f}\n",ph.stance,ph.begin_s(),ph.end_s()); if(env("SHOW",0)){ size_t step=env("ALL",0)?1:std::max<size_t>(2,ph.instants.size()/6/2*2); for(size_t i=0;i<ph.instants.size();i+=step){auto&p=ph.instants[i]; fmt::print("   t{:.3f} x{:.3f} z{:.3f} th{:.3f} kn{:.3f} an{:.3f} | {:.2f} {:.2f} {:.2f} | u {:.1f} {:.1f} | fx {:.1f} heel {:.1f} toe {:.1f} V {:.1f}\n",p.time_s,p.position[0],p.position[1],p.position[2],p.position[3],p.position[4],p.velocity[2],p.velocity[3],p.velocity[4],p.drive_Nm[0],p.drive_Nm[1],p.contact_N.row(0).sum(),p.contact_N(2,0)+p.contact_N(2,1),p.contact_N(2,2)+p.contact_N(2,3),p.bus_V);} } }
  if(r.check){ for(auto&f:r.check->check.findings) if(f.severity!=actuator::Severity::kNote) fmt::print("finding {}\n",f.sentence); fmt::print("check {}\n",actuator::name_of(r.check->check.verdict)); }
  for(auto&m:r.least_margins) fmt::print("margin {} {} t {:.3f} value {:.4g} limit {:.4g} margin {:.4g} {}\n",m.rule,m.place,m.time_s,m.value,m.limit,m.margin,m.unit);
  fmt::print("CAM {:.3f} CAV {:.3f} -> {:.3f} +{:.1f} %\n",r.angular_momentum_Nm_s,r.take_off_rad_s,r.peak_rad_s,100*(r.peak_rad_s/r.take_off_rad_s-1));
  if(getenv("CSV")) csv(r.motion,getenv("CSV"));
}
