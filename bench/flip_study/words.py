# SPDX-License-Identifier: Apache-2.0
"""How answers are said in tables."""
import math

DEGREES = 180 / math.pi


def table(names, rows):
    lines = ["| " + " | ".join(names) + " |", "|" + "---|" * len(names)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def reached(is_reached):
    return "reached" if is_reached else "**missed**"


def status(found):
    if found["status"] == "limit" and found.get("rounds"):
        solver = found["rounds"][-1]["solver"]
        return "solved, check fails" if solver == "solved" else f"none: {solver}"
    return {"planned": "planned", "locally_infeasible": "locally infeasible", "limit": "none within the limit",
            "check_fails": "solved, check fails", "refused": "refused"}.get(found["status"], found["status"])


def why(found):
    """What holds a search back: rows that are violated or bind most, or the reason."""
    if found["status"] == "planned":
        region = next((one for one in found["least_margins"] if one["rule"] == "motor-operating-region"), None)
        return f"region: {region['margin']:.1f} N m left at the {region['place']}" if region else ""
    binding = found.get("binding") or []
    if binding:
        worst = sorted(binding, key=lambda one: (-one["violation"], -one["instants"] / one["of"]))
        return "; ".join(f"{one['name']} ({one['stance']}, {one['instants']} of {one['of']} instants)"
                         for one in worst[:1])
    return found.get("reason", "")[:120]


def flight(found):
    """CAM, CAV at take-off, peak and rise of a plan."""
    if not found.get("cam_kg_m2_s"):
        return "", "", "", ""
    off, peak = found["cav_take_off_rad_s"], found["cav_peak_rad_s"]
    return f"{found['cam_kg_m2_s']:.2f}", f"{off:.2f}", f"{peak:.2f}", f"{100 * (peak / off - 1):+.1f}"


def shortness(report):
    """Degrees by which the base has turned less than planned at touch-down; negative: more."""
    if report is None or not report.get("touch_down"):
        return None
    return report["touch_down"]["rotation_short_rad"] * DEGREES


def fell(report):
    if report["verdict"] != "fell":
        return report["verdict"]
    return f"fell at {report['end']['time_s']:.2f} s"


def planned_or_best(found):
    if found["motion"] is None:
        return "no motion"
    return "plan" if found["status"] == "planned" else "closest motion"
