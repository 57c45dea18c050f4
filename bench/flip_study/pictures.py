# SPDX-License-Identifier: Apache-2.0
"""Pictures by gnuplot."""
import subprocess

HEAD = """set datafile separator ','
set terminal svg size {size} dynamic font 'sans-serif,12' background 'white'
set grid lc rgb '#dddddd'
set output '{path}'
"""


def draw(path, size, script):
    subprocess.run(["gnuplot"], input=HEAD.format(path=path, size=size) + script, text=True, check=True)


def curves(path, folder, take_off_s, touch_down_s):
    """Fig. 5 a to c: three panels, a band and lines."""
    panels = [("pitch_rate", "pitch rate, rad/s"), ("pitch", "pitch, degrees"), ("height", "base height, m")]
    script = "set multiplot layout 3,1\nset xrange [0.5:2.6]\nset key top left\n"
    for time_s in (take_off_s, touch_down_s):
        script += f"set arrow from {time_s}, graph 0 to {time_s}, graph 1 nohead dt 3 lc rgb '#888888'\n"
    for i, (name, label) in enumerate(panels):
        if i == 2:
            script += "set xlabel 'time, s'\n"
        title = (lambda words: f"title '{words}'") if i == 0 else (lambda words: "notitle")
        script += f"set ylabel '{label}'\n"
        script += (f"plot '{folder}/{name}_band.csv' using 1:2:3 with filledcurves lc rgb '#cccccc' "
                   f"{title('MOR plan, randomised (in the place of hardware)')}")
        for file, colour, words in (("mor_in_mor", "#1f77b4", "MOR plan under MOR"),
                                    ("box_in_box", "#2ca02c", "box plan in box"),
                                    ("box_in_mor", "#d62728", "box plan under MOR")):
            script += f", '{folder}/{file}_{name}.csv' using 1:2 with lines lw 1.5 lc rgb '{colour}' {title(words)}"
        script += "\n"
    draw(path, "720,720", script + "unset multiplot\n")


def gear_bands(path, folder, limits):
    """Figs. 6 and 7: the motor-side load after touch-down, with and without the landing objective."""
    script = "set multiplot layout 2,1\nset xrange [-0.02:0.08]\nset key top right\n"
    for drive, limit_Nm in limits:
        script += f"set ylabel '{drive.replace('_', ' ')}, N m at the motor'\nset xlabel 'after touch-down, s'\n"
        script += (f"plot '{folder}/{drive}_without.csv' using 1:2:3 with filledcurves fs transparent solid 0.5 "
                   f"lc rgb '#d62728' title 'effort alone', "
                   f"'{folder}/{drive}_with.csv' using 1:2:3 with filledcurves fs transparent solid 0.5 "
                   f"lc rgb '#1f77b4' title 'with gear load', "
                   f"{limit_Nm} with lines dt 2 lc rgb '#000000' title 'strength', -{limit_Nm} with lines dt 2 "
                   f"lc rgb '#000000' notitle\n")
    draw(path, "720,560", script + "unset multiplot\n")
