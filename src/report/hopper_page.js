// SPDX-License-Identifier: Apache-2.0
// The time cursor of a whole-body check's page: one slider moves the figure, its forces, and a mark
// in every chart. The page is complete without it; all numbers come from the element #motion.
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("motion").textContent);
  const columns = data.columns;
  const times = columns.time_s;
  const last = times.length - 1;
  const byId = (id) => document.getElementById(id);
  const all = (selector) => [...document.querySelectorAll(selector)];
  const slider = byId("time");
  const play = byId("play");
  const speed = byId("speed");
  const number = (x, digits = 4) => (x === null ? "none" : String(Number(x.toPrecision(digits))));
  const view = typeof turningView === "function" ? turningView(data, number) : null;
  let now = 0; // The sample that is shown.
  let playing = null; // The clock's time at which the motion's first instant would have been.
  let speaking = 0;
  let resting = 0;

  const value = (name) => columns[name][now];

  /** The sample nearest to a time; of two alike, after an impact. */
  function sampleAt(time) {
    let low = 0;
    let high = last;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= time) low = middle;
      else high = middle - 1;
    }
    const isNextNearer = low < last && times[low + 1] - time < time - times[low];
    return isNextNearer ? low + 1 : low;
  }

  const isWithin = ([from, until]) => from <= times[now] && times[now] <= until;
  const violated = () => data.violations.filter((violation) => violation.times.some(isWithin));

  function drawRobot(active) {
    const robot = document.querySelector("svg.robot");
    if (!robot) return;
    const at = (point) => [data.points[point].x[now], data.points[point].y[now]];
    const bad = new Set(active.flatMap((violation) => violation.bodies));
    for (const bone of robot.querySelectorAll(".bone")) {
      [bone.x1.baseVal.value, bone.y1.baseVal.value] = at(bone.dataset.from);
      [bone.x2.baseVal.value, bone.y2.baseVal.value] = at(bone.dataset.to);
      bone.classList.toggle("bad", bad.has(Number(bone.dataset.body)));
    }
    const mass = robot.querySelector(".mass");
    mass.cx.baseVal.value = data.mass.x[now];
    mass.cy.baseVal.value = data.mass.y[now];
    for (const arrow of robot.querySelectorAll(".force")) {
      const contact = data.contacts[arrow.dataset.contact];
      arrow.setAttribute("d", contact.x ? arrowPath(at(contact.point), contact) : "");
    }
  }

  /** From a contact point along the ground's force on it. */
  function arrowPath([x, y], contact) {
    const { greatest_N, power, longest_paper } = data.force;
    const size_N = Math.hypot(value(contact.x), value(contact.z));
    const length = longest_paper * (size_N / greatest_N) ** power;
    if (!(length > 1)) return "";
    const dx = (value(contact.x) * length) / size_N;
    const dy = (-value(contact.z) * length) / size_N;
    const head = Math.min(9, length / 2) / length;
    const [tipX, tipY] = [x + dx, y + dy];
    const side = (sign) =>
      `L${tipX - head * (dx + sign * 0.4 * dy)} ${tipY - head * (dy - sign * 0.4 * dx)}`;
    return `M${x} ${y}L${tipX} ${tipY}${side(1)}M${tipX} ${tipY}${side(-1)}`;
  }

  /**
   * What follows the cursor, by the chart or table that holds it. While the cursor moves, only what
   * is on the screen follows, numbers as often as one can read them; the rest when it stands, and
   * before the page is printed.
   */
  const kReadable_ms = 100;
  const holders = new Map();
  for (const part of all("svg.chart .moves, [data-column]")) {
    const holder = part.closest("svg.chart, table, dl") || part;
    if (!holders.has(holder)) holders.set(holder, { marks: [], cells: [], seen: true });
    holders.get(holder)[part.matches(".moves") ? "marks" : "cells"].push(part);
  }
  const watcher = new IntersectionObserver((entries) => entries.forEach((entry) => {
    const held = holders.get(entry.target);
    held.seen = entry.isIntersecting;
    if (held.seen) draw(held);
  }), { rootMargin: "100px" });
  for (const holder of holders.keys()) watcher.observe(holder);

  let toldAt = -1000; // The clock's time, in ms from the page's opening, when numbers were last told.

  function draw(held, withNumbers = true) {
    if (held.marked !== now) held.marks.forEach(drawMark);
    held.marked = now;
    if (!withNumbers || held.told === now) return;
    held.cells.forEach(drawCell);
    held.told = now;
  }

  function drawSeen() {
    const clock = performance.now();
    const withNumbers = clock - toldAt >= kReadable_ms;
    if (withNumbers) toldAt = clock;
    holders.forEach((held) => { if (held.seen) draw(held, withNumbers); });
    clearTimeout(resting);
    resting = setTimeout(drawAll, kReadable_ms);
  }

  const drawAll = () => holders.forEach((held) => draw(held));

  function drawCell(cell) {
    cell.textContent = number(value(cell.dataset.column));
    cell.classList.toggle("bad", Boolean(cell.dataset.bad) && value(cell.dataset.bad) > 0);
  }

  /** Marks of charts: each names the columns that it follows. */
  function drawMark(mark) {
    const chart = mark.ownerSVGElement.dataset;
    const x = (name) => value(name) * chart.xSlope + Number(chart.xZero);
    const y = (name) => value(name) * chart.ySlope + Number(chart.yZero);
    const { x: xName, y: yName, y1, y2, bad } = mark.dataset;
    const isThere = [xName, yName, y1, y2].every((name) => !name || value(name) !== null);
    mark.classList.toggle("there", isThere);
    if (!isThere) return;
    if (mark.tagName === "circle") {
      mark.setAttribute("cx", x(xName));
      mark.setAttribute("cy", y(yName));
      mark.classList.toggle("bad", Boolean(bad) && value(bad) > 0);
      return;
    }
    mark.setAttribute("x1", x(xName));
    mark.setAttribute("x2", x(xName));
    if (!y1) return;
    mark.setAttribute("y1", y(y1));
    mark.setAttribute("y2", y(y2));
  }

  function phase() {
    if (!columns.in_flight) return "";
    return value("in_flight") > 0 ? "in flight" : "on the ground";
  }

  /** What a screen reader is told once the cursor stands. */
  function spoken(active) {
    const drives = data.drives.map(
      (drive) =>
        `${drive.name}: ${number(value(drive.torque), 3)} newton metres at ` +
        `${number(value(drive.speed), 3)} radians per second, ` +
        (value(drive.outside) > 0 ? "outside its region" : "inside its region"));
    const words = active.map((violation) => `${violation.name}: ${violation.rule}`);
    return [`${number(times[now])} seconds`, phase(),
      words.length ? `violated: ${words.join(", ")}` : "nothing violated", ...drives]
      .filter(Boolean).join("; ");
  }

  function say(active) {
    const words = active.map((violation) => `${violation.name} ${violation.rule}`);
    byId("clock").textContent = `${times[now].toFixed(3)} s`;
    byId("phase").textContent = phase();
    byId("violated").replaceChildren(...words.map((text) => {
      const item = document.createElement("li");
      item.textContent = text;
      return item;
    }));
    slider.setAttribute("aria-valuetext",
      [`${number(times[now])} seconds`, phase(), ...words].filter(Boolean).join(", "));
    clearTimeout(speaking);
    if (playing === null) {
      speaking = setTimeout(() => { byId("spoken").textContent = spoken(active); }, 300);
    }
  }

  function show(sample) {
    now = Math.max(0, Math.min(last, sample));
    const active = violated();
    drawRobot(active);
    if (view) view.show(now, new Set(active.flatMap((violation) => violation.bodies)));
    drawSeen();
    say(active);
  }

  function moveTo(sample) {
    show(sample);
    slider.value = times[now];
  }

  function pause() {
    playing = null;
    play.textContent = "Play";
    say(violated());
  }

  function tick(clock) {
    if (playing === null) return;
    const time = times[0] + ((clock - playing) / 1000) * Number(speed.value);
    moveTo(sampleAt(time));
    if (now >= last) pause();
    else requestAnimationFrame(tick);
  }

  /** From where the cursor is; at the end from the begin. */
  function start() {
    if (now >= last) moveTo(0);
    playing = performance.now() - ((times[now] - times[0]) * 1000) / Number(speed.value);
    play.textContent = "Pause";
    requestAnimationFrame(tick);
  }

  function stopAndMoveTo(sample) {
    if (playing !== null) pause();
    moveTo(sample);
  }

  const worst = data.violations.map((violation) => violation.worst_s).sort((a, b) => a - b);
  const isPast = (time) => time > times[now] + 1e-9;
  const isBefore = (time) => time < times[now] - 1e-9;

  play.addEventListener("click", () => (playing === null ? start() : pause()));
  speed.addEventListener("change", () => { if (playing !== null) start(); });
  slider.addEventListener("input", () => {
    if (playing !== null) pause();
    show(sampleAt(Number(slider.value)));
  });
  slider.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
    if (!step || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    stopAndMoveTo(now + step * (event.shiftKey ? 10 : 1));
  });
  byId("before").addEventListener("click", () => {
    const time = worst.filter(isBefore).pop();
    if (time !== undefined) stopAndMoveTo(sampleAt(time));
  });
  byId("after").addEventListener("click", () => {
    const time = worst.find(isPast);
    if (time !== undefined) stopAndMoveTo(sampleAt(time));
  });
  for (const id of ["before", "after", "violated"]) byId(id).hidden = worst.length === 0;

  addEventListener("beforeprint", drawAll);
  all(".needs-script").forEach((element) => { element.hidden = false; });
  moveTo(sampleAt(data.begin_s));
})();
