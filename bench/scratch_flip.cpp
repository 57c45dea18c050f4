#include <fmt/format.h>
#include <cstdlib>
#include <cmath>
#include "hopper/flip/guess.hpp"
#include "hopper/flip/integration_error.hpp"
#include "hopper/flip/mesh_refinement.hpp"
#include "hopper/robot/robot_spec.hpp"
#include "optimization/nonlinear/solve.hpp"
using namespace torquewright; using namespace torquewright::hopper;
static double env(const char* n, double d){ const char* v=getenv(n); return v?atof(v):d; }

static void csv(const SagittalRobot& plane, const PlannedMotion& m, const char* file){
  FILE* f=fopen(file,"w");
  fprintf(f,"time_s,base_x_position_m,base_y_position_m,base_z_position_m,base_qw_position,base_qx_position,base_qy_position,base_qz_position,knee_position_rad,ankle_pitch_position_rad,ankle_roll_position_rad,base_x_velocity_m_s,base_y_velocity_m_s,base_z_velocity_m_s,base_angular_x_velocity_rad_s,base_angular_y_velocity_rad_s,base_angular_z_velocity_rad_s,knee_velocity_rad_s,ankle_pitch_velocity_rad_s,ankle_roll_velocity_rad_s,base_x_acceleration_m_s2,base_y_acceleration_m_s2,base_z_acceleration_m_s2,base_angular_x_acceleration_rad_s2,base_angular_y_acceleration_rad_s2,base_angular_z_acceleration_rad_s2,knee_acceleration_rad_s2,ankle_pitch_acceleration_rad_s2,ankle_roll_acceleration_rad_s2,heel_left_contact,heel_right_contact,toe_left_contact,toe_right_contact\n");
  for(auto&ph:m.phases){ bool first=true; for(size_t i=0;i+2<ph.instants.size();i+=2){ auto&a=ph.instants[i];auto&b=ph.instants[i+1];auto&c=ph.instants[i+2]; double h=c.time_s-a.time_s; int n=std::max(2,(int)std::ceil(h/1e-3)); for(int j=0;j<=n;++j){ if(j==0&&!(first)) continue; if (first&&j==0&&&ph!=&m.phases[0]) { const auto& before=(&ph-1)->instants.back(); auto tb=tree_motion(plane,(&ph-1)->frame(),{before.position,before.velocity,before.acceleration}), ta=tree_motion(plane,ph.frame(),{a.position,a.velocity,a.acceleration}); if((tb.velocity-ta.velocity).norm()<1e-6){first=false; continue;} } first=false; double t=h*j/n, s=t/h;
     Eigen::VectorXd c1=(-3*a.acceleration+4*b.acceleration-c.acceleration), c2=(2*a.acceleration-4*b.acceleration+2*c.acceleration);
     Eigen::VectorXd acc=a.acceleration+s*c1+s*s*c2, v=a.velocity+h*(s*a.acceleration+s*s/2*c1+s*s*s/3*c2), q=a.position+h*s*a.velocity+h*h*(s*s/2*a.acceleration+s*s*s/6*c1+s*s*s*s/12*c2);
     auto tm=tree_motion(plane,ph.frame(),{q,v,acc}); q=tm.position; v=tm.velocity; acc=tm.acceleration;
     auto pr=[&](double x){fprintf(f,",%.15g",x);};
     fprintf(f,"%.15g",a.time_s+t); pr(q[0]);pr(0);pr(q[1]);pr(cos(q[2]/2));pr(0);pr(sin(q[2]/2));pr(0);pr(q[3]);pr(q[4]);pr(0);
     for(auto*x:{&v,&acc}){pr((*x)[0]);pr(0);pr((*x)[1]);pr(0);pr((*x)[2]);pr(0);pr((*x)[3]);pr((*x)[4]);pr(0);}
     for(int k=0;k<4;++k) pr(ph.touches[k]?1:0);
     fprintf(f,"\n"); } } }
  fclose(f);
}
int main(int argc,char**argv){
  auto robot = read_robot(argv[1]).robot;
  PlanOptions o; 
  if (env("BOX",0)) o.limits=DriveLimits::kBox;
  o.margins.voltage=env("VM",0.05); o.margins.current=env("CM",0.08); o.margins.friction=env("FM",0.15); o.margins.center_of_pressure=env("COP",0.1); o.margins.gear_load=env("GM",0.1);
  o.guess_noise_rad=env("NOISE",0); o.guess_seed=(unsigned)env("SEED",0);
  PlanModel model = plan_model(robot,o);
  for(size_t i=0;i<model.joint_rad.size();++i) fmt::print("joint {} {} {} speed {} Nm {}\n",i,model.joint_rad[i].lower,model.joint_rad[i].upper,model.joint_rad_s[i],model.joint_Nm[i]);
  for(size_t i=0;i<model.gear_Nm.size();++i) fmt::print("drive {} gear {} rotor {} peak {}\n",i,model.gear_Nm[i],model.rotors_kg_m2[i],(*model.regions)[i].greatest_torque_Nm());
  for(auto&s:*model.supplies) fmt::print("supply {} V {} ohm drives {}\n",s.open_V,s.resistance_ohm,s.drives.size());
  auto stances=stances_of(model.plane,{"flat","heel","flight","heel","flat"});
  std::vector<MeshPhase> mesh; 
  double dur[]={0.45,0.12,0.52,0.08,0.7}; double n[]={env("N0",16),env("N1",12),env("N2",20),env("N3",6),env("N4",16)};
  double lo[]={0.2,0.03,0.3,0.02,0.4}, hi[]={0.8,env("H1",0.2),0.8,env("H3",0.12),1.2};
  bool fixed=env("FIX",1);
  for(int p=0;p<5;++p){ MeshPhase m{stances[p],{},{lo[p],hi[p]}}; m.duration_s= fixed? optimization::Bounds{dur[p],dur[p]}:optimization::Bounds{lo[p],hi[p]}; for(int i=0;i<=n[p];++i) m.knots.push_back(i/n[p]); mesh.push_back(m);}  
  PlanGoal goal; goal.turn_rad=2*M_PI;
  auto gm=mesh; for(int p=0;p<5;++p) gm[p].duration_s={dur[p],dur[p]};
  PlannedMotion guess=key_frame_guess(model,gm,goal,o);
  auto run=[&](std::vector<MeshPhase>& me, const PlannedMotion& g, double mu){
    FlipProgram fp=flip_program(model,me,goal,o,g);
    fmt::print("vars {} rows {}\n",fp.program.variable_count(),fp.program.row_count());
    optimization::NonlinearOptions no; no.most_seconds=env("TL",60); no.first_barrier=mu; no.most_iterations=(int)env("MI",600);
    no.tolerance=env("TOL",1e-5);
    no.on_iterate=[&](const optimization::NonlinearIterate& it){ if(it.iteration%10==0) {fmt::print("  it {} obj {:.5f} viol {:.2e}\n",it.iteration,it.objective,it.largest_violation); fflush(stdout);} };
    auto s=optimization::solve(fp.program,no);
    fmt::print("status {} it {} obj {} viol {} time {:.1f} deriv {:.1f}\n",name_of(s.status),s.iterations,s.objective,s.largest_violation,s.seconds,s.derivative_seconds);
    // worst rows
    std::vector<std::pair<double,std::string>> worst;
    for(auto&r:fp.program.rows()){ auto x=optimization::gathered(*r,s.values); Eigen::VectorXd v(r->size()); r->values(x,v); for(int i=0;i<v.size();++i){ double e=std::max({0.0,r->bounds()[i].lower-v[i],v[i]-r->bounds()[i].upper})/r->scales()[i]; if(e>1e-4) worst.push_back({e,fmt::format("{} row {}",r->name(),i)});} }
    std::sort(worst.rbegin(),worst.rend()); for(size_t i=0;i<std::min<size_t>(8,worst.size());++i) fmt::print("   {:.2e} {}\n",worst[i].first,worst[i].second);
    return motion_of(fp,model,s.values);
  };
  auto show=[&](const PlannedMotion& m){ for(auto&ph:m.phases){ fmt::print("{} {:.4f}..{:.4f}\n",ph.stance,ph.begin_s(),ph.end_s()); size_t step=std::max<size_t>(2,ph.instants.size()/6/2*2); for(size_t i=0;i<ph.instants.size();i+=step){auto&p=ph.instants[i]; fmt::print("   t{:.3f} x{:.3f} z{:.3f} th{:.3f} kn{:.3f} an{:.3f} | {:.2f} {:.2f} {:.2f} | u {:.1f} {:.1f} {:.1f} | fx {:.1f} heel {:.1f} toe {:.1f} V {:.1f}\n",p.time_s,p.position[0],p.position[1],p.position[2],p.position[3],p.position[4],p.velocity[2],p.velocity[3],p.velocity[4],p.drive_Nm[0],p.drive_Nm[1],p.drive_Nm[2],p.contact_N.row(0).sum(),p.contact_N(2,0)+p.contact_N(2,1),p.contact_N(2,2)+p.contact_N(2,3),p.bus_V);} } };
  if(env("SHOWG",0)) show(guess);
  auto m=run(mesh,guess,env("MU",0.1));
  for(int r=0;;++r){ auto es=integration_errors(model.plane,stances,m); bool ok=true; int total=0; for(size_t p=0;p<es.size();++p){ fmt::print("  err {} {:.2e} worst interval {:.2e} n {}\n",stances[p].name,es[p].whole_rad,*std::max_element(es[p].interval_rad.begin(),es[p].interval_rad.end()),es[p].interval_rad.size()); if(es[p].whole_rad>2e-3){ok=false; mesh[p].knots=refined(mesh[p].knots,es[p].interval_rad,env("AL",1e-3));} total+=(int)mesh[p].knots.size()-1; } if(ok||r>=env("ROUNDS",4)) break; fmt::print("round {} intervals {}\n",r,total); m=run(mesh,m,env("MU2",0.01)); }
  { SagittalDynamicsOf<double> dyn(model.plane); WholeBody wb(model.plane.robot);
    for(auto&ph:m.phases) for(size_t i=0;i<ph.instants.size();i+=ph.instants.size()/3){ auto&a=ph.instants[i]; auto tm=tree_motion(model.plane,ph.frame(),{a.position,a.velocity,a.acceleration}); (void)wb.set(tm.position,tm.velocity); Eigen::VectorXd f(6); wb.inverse_dynamics(tm.acceleration,f); double fz=a.contact_N.row(2).sum(); fmt::print("{} t{:.3f} fx {:.3f} fz {:.3f} (plan {:.3f} {:.3f})  acc {:.2f} {:.2f} v {:.3f} {:.3f}\n",ph.stance,a.time_s,f[0],f[1],a.contact_N.row(0).sum(),fz,tm.acceleration[0],tm.acceleration[1],tm.velocity[0],tm.velocity[1]); } }
  show(m); if(getenv("CSV")) csv(model.plane,m,getenv("CSV"));
  if(env("FREE",0)){ for(int p=0;p<5;++p) mesh[p].duration_s={lo[p],hi[p]}; m=run(mesh,m,env("MU2",0.01)); show(m);}  
}
