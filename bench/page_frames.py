#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a frame of a robot's page costs its script: 30 bodies and 10,000 rows, played in a headless
Chromium.

    bench/page_frames.py TORQUEWRIGHT [--bodies 30] [--rows 10000] [--frames 600] [--keep FOLDER]

A frame is the page's own work from a step of the cursor to the picture's last call of WebGL: charts
and values, bodies, forces, shadows, and what three.js does to hand them over. Where no graphics
card is, the processor would draw; so the calls that draw (drawElements, drawArrays) return at once,
and the figure is of the script alone. The second row has them drawn, by whatever is there. The
first columns are processor time of the page's thread, which other programs do not lengthen: script,
styles and layout, and all that the thread does, painting and the handing over of pictures included.
"""
import argparse
import json
import math
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile

BROWSERS = ("chromium", "chromium-browser", "google-chrome")
OPTIONS = ("--headless", "--no-sandbox", "--disable-gpu", "--no-first-run",
           "--disable-background-networking", "--disable-dev-shm-usage",
           "--remote-debugging-pipe", "--enable-unsafe-swiftshader")
# The page as with a graphics card: a picture a frame. Before its own scripts.
AS_WITH_A_CARD = """
const get = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, wish) {
  const context = get.call(this, kind, {...wish, failIfMajorPerformanceCaveat: false});
  if (kind === "webgl" && context && DRAWS_NOTHING) {
    for (const name of ["drawElements", "drawArrays"]) context[name] = () => {};
  }
  return context;
};
const request = window.requestAnimationFrame.bind(window);
window.spent = 0;
window.requestAnimationFrame = (work) => request((clock) => {
  const begin = performance.now();
  work(clock);
  window.spent += performance.now() - begin;
});
"""
PLAYED = """
(async () => {
  const slider = document.getElementById("time");
  const [from, to] = [Number(slider.min), Number(slider.max)];
  const next = () => new Promise((done) => setTimeout(done, 0));
  const shown = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const frames = [];
  const begin = performance.now();
  for (let i = 0; i < COUNT; ++i) {
    window.spent = 0;
    slider.value = from + (to - from) * i / (COUNT - 1);
    const start = performance.now();
    slider.dispatchEvent(new Event("input"));
    const step = performance.now() - start;
    await shown();
    frames.push(step + window.spent);
    await next();
  }
  return {frames, seconds: (performance.now() - begin) / 1000,
          canvas: Boolean(document.querySelector("canvas").dataset.azimuth)};
})()
"""


class Browser:
    """Chromium by its debugging pipe: messages of JSON, each with a zero byte behind it."""

    def __init__(self, program, folder):
        read_by_it, self.to = os.pipe()
        self.source, written_by_it = os.pipe()

        def descriptors():
            os.dup2(read_by_it, 103)
            os.dup2(written_by_it, 104)
            os.dup2(103, 3)
            os.dup2(104, 4)

        self.process = subprocess.Popen(
            [program, *OPTIONS, f"--user-data-dir={folder}"],
            preexec_fn=descriptors, close_fds=False, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)
        os.close(read_by_it)
        os.close(written_by_it)
        self.buffer, self.calls, self.session = b"", 0, None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.call("Page.enable")

    def message(self):
        while b"\0" not in self.buffer:
            piece = os.read(self.source, 1 << 16)
            if not piece:
                sys.exit("the browser has ended")
            self.buffer += piece
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **parameters):
        self.calls += 1
        message = {"id": self.calls, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.message()
            if answer.get("id") == self.calls:
                if "error" in answer:
                    sys.exit(f"{method}: {answer['error']}")
                return answer["result"]

    def open(self, page):
        self.call("Page.navigate", url=page.resolve().as_uri())
        while self.message().get("method") != "Page.loadEventFired":
            pass

    def value_of(self, expression):
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in answer:
            sys.exit(json.dumps(answer["exceptionDetails"]))
        return answer["result"]["value"]

    def close(self):
        self.process.terminate()
        self.process.wait()


LINK_M = 0.12
FOOT_M = 0.02


def robot(bodies):
    """A trunk on four legs as alike as the count allows, in URDF. The last link of each has a foot."""
    lines = ['<robot name="many">']

    def link(name, foot):
        shape = (f'<collision><origin xyz="0 0 {-LINK_M}"/><geometry><sphere radius="{FOOT_M}"/>'
                 '</geometry></collision>') if foot else ""
        lines.append(
            f'<link name="{name}"><inertial><origin xyz="0 0 {-LINK_M / 2}"/><mass value="0.5"/>'
            '<inertia ixx="1e-3" iyy="1e-3" izz="1e-3" ixy="0" ixz="0" iyz="0"/></inertial>'
            f"{shape}</link>")

    link("trunk", False)
    legs = [(bodies - 1 - leg + 3) // 4 for leg in range(4)]
    for leg, links in enumerate(legs):
        for depth in range(links):
            parent = "trunk" if depth == 0 else f"link_{leg}_{depth - 1}"
            place = f"{0.2 if leg < 2 else -0.2} {0.12 if leg % 2 else -0.12} 0"
            link(f"link_{leg}_{depth}", depth == links - 1)
            lines.append(
                f'<joint name="joint_{leg}_{depth}" type="revolute"><parent link="{parent}"/><child '
                f'link="link_{leg}_{depth}"/><origin xyz="{place if depth == 0 else f"0 0 {-LINK_M}"}"/>'
                '<axis xyz="0 1 0"/><limit lower="-2.5" upper="2.5" effort="80" velocity="20"/></joint>')
    return "\n".join(lines + ["</robot>"]), legs


def angles(links, height_m):
    """Of a leg that folds like a bellows: links lean forward and back by turns, so the foot stays
    below the hip. Of an odd count the first hangs straight."""
    straight = links % 2
    lean = math.acos((height_m / LINK_M - straight) / (links - straight))
    leans = [0.0] * straight + [lean * (-1) ** i for i in range(links - straight)]
    return [after - before for before, after in zip([0.0] + leans, leans)]


def motion(legs, rows):
    """The trunk goes up and down on its four feet, slowly enough that they keep to the ground."""
    base = ["base_x_position_m", "base_y_position_m", "base_z_position_m", "base_qw_position",
            "base_qx_position", "base_qy_position", "base_qz_position"]
    names = [f"joint_{leg}_{depth}_position_rad" for leg, links in enumerate(legs)
             for depth in range(links)]
    lines = [",".join(["time_s", *base, *names])]
    for row in range(rows):
        time_s = 0.001 * row
        height_m = LINK_M * min(legs) * (0.85 + 0.05 * math.sin(3 * time_s))
        bent = [angle for links in legs for angle in angles(links, height_m)]
        numbers = [time_s, 0, 0, height_m + FOOT_M, 1, 0, 0, 0, *bent]
        lines.append(",".join(f"{number:.12g}" for number in numbers))
    return "\n".join(lines) + "\n"


def page_of(program, bodies, rows, folder):
    text, legs = robot(bodies)
    (folder / "many.urdf").write_text(text)
    (folder / "motion.csv").write_text(motion(legs, rows))
    for command in (["robot", "import", "many.urdf", "-o", "many.json"],
                    ["hopper", "check", "many.json", "motion.csv", "--report", "page.html"]):
        ended = subprocess.run([program, *command], cwd=folder, capture_output=True, text=True)
        if ended.returncode not in (0, 1, 3):
            sys.exit(f"{' '.join(command)}: {ended.stderr}")
    return folder / "page.html"


def metrics(browser):
    """Seconds of the page's thread so far."""
    return {metric["name"]: metric["value"] for metric in browser.call("Performance.getMetrics")["metrics"]
            if metric["name"].endswith("Duration")}


def measured(browser, page, frames, draws_nothing):
    script = AS_WITH_A_CARD.replace("DRAWS_NOTHING", "true" if draws_nothing else "false")
    added = browser.call("Page.addScriptToEvaluateOnNewDocument", source=script)["identifier"]
    browser.call("Emulation.setDeviceMetricsOverride", width=1100, height=900, deviceScaleFactor=1,
                 mobile=False)
    browser.open(page)
    browser.call("Performance.enable", timeDomain="threadTicks")
    before = metrics(browser)
    result = browser.value_of(PLAYED.replace("COUNT", str(frames)))
    after = metrics(browser)
    result["ms"] = {name: 1000 * (after[name] - before[name]) / frames for name in after}
    browser.call("Performance.disable")
    browser.call("Page.removeScriptToEvaluateOnNewDocument", identifier=added)
    if not result["canvas"]:
        sys.exit("the page did not turn: no WebGL")
    return result


def row(words, result):
    frames = sorted(result["frames"])
    rank = frames[int(0.99 * (len(frames) - 1))]
    ms = result["ms"]
    laid_out = ms["LayoutDuration"] + ms["RecalcStyleDuration"]
    return (f"| {words} | {ms['ScriptDuration']:.1f} | {laid_out:.1f} | {ms['TaskDuration']:.1f} "
            f"| {statistics.median(frames):.1f} | {rank:.1f} "
            f"| {1000 * result['seconds'] / len(frames):.0f} |")


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("program", type=pathlib.Path)
    options.add_argument("--bodies", type=int, default=30)
    options.add_argument("--rows", type=int, default=10000)
    options.add_argument("--frames", type=int, default=600)
    options.add_argument("--keep", type=pathlib.Path, help="folder in which robot and page stay")
    chosen = options.parse_args()
    chromium = next(filter(None, map(shutil.which, BROWSERS)), None)
    if chromium is None:
        sys.exit("Chromium is not installed (Debian: chromium)")
    with tempfile.TemporaryDirectory() as scratch:
        folder = chosen.keep or pathlib.Path(scratch) / "page"
        folder.mkdir(parents=True, exist_ok=True)
        page = page_of(chosen.program.resolve(), chosen.bodies, chosen.rows, folder)
        print(f"{chosen.bodies} bodies, {chosen.rows} rows, page of "
              f"{page.stat().st_size / 1e6:.1f} MB; ms a frame\n")
        print("| what | script | styles, layout | thread | script by the clock, median | 99 % "
              "| from frame to frame |\n|---|---|---|---|---|---|---|")
        browser = Browser(chromium, pathlib.Path(scratch) / "profile")
        try:
            print(row("script", measured(browser, page, chosen.frames, True)))
            print(row("script, drawn by the processor",
                      measured(browser, page, max(10, chosen.frames // 20), False)))
        finally:
            browser.close()


if __name__ == "__main__":
    main()
