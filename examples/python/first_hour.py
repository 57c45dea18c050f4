# SPDX-License-Identifier: Apache-2.0
"""A first hour: what can a knee do, can it do a motion, and which gears would do?

From the repository's root: python3 examples/python/first_hour.py. Behind #> stands what it prints.
"""
import numpy as np
import torquewright

knee = torquewright.actuator("specs/actuator/d151_knee.json")
region = knee.region([0.0, 5.0, 10.0], winding_temperature_K=350)
print(region["torque_max_Nm"].round(1), region["limiter_max"])
#> [320.  320.   60.8] ['current', 'current', 'voltage']

time_s = np.linspace(0.0, 1.0, 501)
motion = {
    "time_s": time_s,
    "knee_position_rad": 0.8 * np.sin(12 * time_s),
    "knee_velocity_rad_s": 9.6 * np.cos(12 * time_s),
    "knee_torque_Nm": 200 * np.cos(12 * time_s),
}
cut_off_Nm = motion["knee_torque_Nm"] - knee.clip(
    motion["knee_torque_Nm"], motion["knee_velocity_rad_s"]
)
print(f"{np.count_nonzero(cut_off_Nm)} samples, up to {np.abs(cut_off_Nm).max():.2f} Nm")
#> 87 samples, up to 68.34 Nm

report = torquewright.check(motion, {"knee": knee}, torque_includes_inertia=True, pause_s=1)
for finding in report["findings"]:
    if finding["severity"] == "violation":
        print(finding["sentence"])
#> knee: 87 of 501 samples (17.4 %) lie outside the region, the worst at t = 0 s: at 9.6 rad/s the drive can push with at most 131.657 Nm; it is asked to push with 200 Nm (voltage)

problem = torquewright.read("specs/gearbox/d151_knee.json")
for ratio in (15, 20, 22):
    result = torquewright.optimize(problem | {"target_ratio": ratio})
    print(ratio, result["status"], [list(one["teeth"].values()) for one in result["designs"]])
#> 15 infeasible []
#> 20 optimal [[44, 44, 32, 132, 120]]
#> 22 optimal [[40, 40, 30, 120, 110]]
