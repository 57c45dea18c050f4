// SPDX-License-Identifier: Apache-2.0
// The robot in three dimensions, drawn by three.js, which stands before this script in the page.
// What it shows is in the page's numbers under "view"; the page's own script says when.
"use strict";

const GRID_CELLS = 40; // To either side.
const GRID_PIECE = 4; // Cells that one line passes.

/** Float32 or Int16, as the report wrote them: little-endian, as every machine with a browser. */
function decoded(text, Kind) {
  return new Kind(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer);
}

/** Triangles of shapes that are round about an axis, and of boxes, as one geometry. */
class Solid {
  constructor() {
    this.places = [];
    this.normals = [];
    this.corners = [];
  }

  /** `profile`: [radius, height, normal outwards, normal along], from the lower end to the upper. */
  lathe(from, along, profile, sides = 20) {
    const axis = along.clone().normalize();
    const helper = Math.abs(axis.x) < 0.7 ? new THREE.Vector3(1, 0, 0) : new THREE.Vector3(0, 1, 0);
    const u = helper.cross(axis).normalize();
    const v = axis.clone().cross(u);
    const first = this.places.length / 3;
    for (const [radius, height, outwards, upwards] of profile) {
      for (let i = 0; i <= sides; ++i) {
        const angle = (2 * Math.PI * i) / sides;
        const out = u.clone().multiplyScalar(Math.cos(angle))
          .addScaledVector(v, Math.sin(angle));
        const place = from.clone().addScaledVector(axis, height).addScaledVector(out, radius);
        const normal = out.multiplyScalar(outwards).addScaledVector(axis, upwards);
        this.places.push(place.x, place.y, place.z);
        this.normals.push(normal.x, normal.y, normal.z);
      }
    }
    for (let ring = 0; ring + 1 < profile.length; ++ring) {
      for (let i = 0; i < sides; ++i) {
        const a = first + ring * (sides + 1) + i;
        const b = a + sides + 1;
        this.corners.push(a, a + 1, b, b, a + 1, b + 1);
      }
    }
  }

  capsule([ax, ay, az, bx, by, bz, radius]) {
    const from = new THREE.Vector3(ax, ay, az);
    const along = new THREE.Vector3(bx, by, bz).sub(from);
    const length = along.length();
    if (length < 1e-9) along.set(0, 0, 1);
    const profile = [];
    for (const [centre, begin] of [[0, -6], [length, 0]]) {
      for (let i = begin; i <= begin + 6; ++i) {
        const [cos, sin] = [Math.cos((i * Math.PI) / 12), Math.sin((i * Math.PI) / 12)];
        profile.push([radius * cos, centre + radius * sin, cos, sin]);
      }
    }
    this.lathe(from, along, profile);
  }

  /** `axes`: the box's own, one after the other. */
  box({ at, half, axes }) {
    const centre = new THREE.Vector3(...at);
    const sides = [0, 1, 2].map((i) => new THREE.Vector3(...axes.slice(3 * i, 3 * i + 3)));
    for (let i = 0; i < 3; ++i) {
      const [j, k] = [(i + 1) % 3, (i + 2) % 3];
      for (const sign of [-1, 1]) {
        const first = this.places.length / 3;
        for (const [b, c] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
          const place = centre.clone().addScaledVector(sides[i], sign * half[i])
            .addScaledVector(sides[j], sign * b * half[j]).addScaledVector(sides[k], c * half[k]);
          this.places.push(place.x, place.y, place.z);
          this.normals.push(...sides[i].clone().multiplyScalar(sign).toArray());
        }
        this.corners.push(first, first + 1, first + 2, first, first + 2, first + 3);
      }
    }
  }

  geometry() {
    const made = new THREE.BufferGeometry();
    made.setAttribute("position", new THREE.Float32BufferAttribute(this.places, 3));
    made.setAttribute("normal", new THREE.Float32BufferAttribute(this.normals, 3));
    made.setIndex(this.corners);
    return made;
  }
}

/**
 * Solids that move each by itself and are drawn in one go: a frame uploads a matrix of each, and
 * colours only where one has changed. Frames of a solid are set from outside.
 */
class Assembly {
  /** `owners`: of each solid the number of the frame that carries it. */
  constructor(solids, owners, frames) {
    this.first = []; // Vertices of each solid.
    const all = new Solid();
    const skinned = [];
    const weights = [];
    solids.forEach((solid, i) => {
      const begin = all.places.length / 3;
      this.first.push(begin);
      for (const corner of solid.corners) all.corners.push(begin + corner);
      for (const place of solid.places) all.places.push(place);
      for (const normal of solid.normals) all.normals.push(normal);
      for (let k = solid.places.length / 3; k > 0; --k) {
        skinned.push(owners[i], 0, 0, 0);
        weights.push(1, 0, 0, 0);
      }
    });
    this.first.push(all.places.length / 3);
    this.geometry = all.geometry();
    this.geometry.setAttribute("skinIndex", new THREE.Uint16BufferAttribute(skinned, 4));
    this.geometry.setAttribute("skinWeight", new THREE.Float32BufferAttribute(weights, 4));
    this.colours = new THREE.Float32BufferAttribute(this.first[solids.length] * 3, 3);
    this.geometry.setAttribute("color", this.colours);
    this.painted = solids.map(() => null);
    const still = frames.map(() => new THREE.Matrix4());
    this.skeleton = new THREE.Skeleton(frames, still);
  }

  /** One more drawing of it. */
  mesh(material, order = 0) {
    const mesh = new THREE.SkinnedMesh(this.geometry, material);
    mesh.bindMode = "detached";
    mesh.bind(this.skeleton, new THREE.Matrix4());
    mesh.frustumCulled = false;
    mesh.matrixAutoUpdate = false;
    mesh.renderOrder = order;
    return mesh;
  }

  paint(solid, colour) {
    const { r, g, b } = colour;
    const now = `${r} ${g} ${b}`;
    if (this.painted[solid] === now) return;
    this.painted[solid] = now;
    for (let i = this.first[solid]; i < this.first[solid + 1]; ++i) this.colours.setXYZ(i, r, g, b);
    this.colours.needsUpdate = true;
  }
}

/** Colours of the page, dark or light, as its stylesheet has them. */
class Colours {
  constructor() {
    const named = ["one", "other", "bad", "force", "idle", "paper"];
    for (const name of named) this[name] = new THREE.Color();
    this.solid = new THREE.MeshLambertMaterial(
      { vertexColors: THREE.VertexColors, skinning: true, fog: false });
    // In front of all else: it would be hidden in the leg that it pushes.
    this.arrow = new THREE.MeshLambertMaterial({ skinning: true, fog: false, depthTest: false });
    this.planned = new THREE.MeshLambertMaterial(
      { skinning: true, fog: false, transparent: true, opacity: 0.3, depthWrite: false });
    this.shadow = new THREE.MeshBasicMaterial({ skinning: true, side: THREE.DoubleSide });
    this.mass = new THREE.MeshBasicMaterial({ color: 0xd96b0f, depthTest: false, fog: false });
    this.way = new THREE.LineBasicMaterial({ color: 0xd96b0f, fog: false });
    this.grid = new THREE.LineBasicMaterial();
    this.read();
  }

  read() {
    const style = getComputedStyle(document.documentElement);
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    const named = (name) => style.getPropertyValue(name).trim();
    this.one.set(dark ? "#5b97dc" : "#1f5fa8");
    this.other.set(dark ? "#8fbaf0" : "#4f8ac6");
    this.bad.set(named("--bad"));
    this.force.set(dark ? "#19b58a" : "#00795a");
    this.idle.set(dark ? "#7d8894" : "#98a3ae");
    this.paper.set(named("--paper"));
    this.arrow.color.copy(this.force);
    this.planned.color.set(dark ? "#c3cfdb" : "#5b6875");
    this.grid.color.set(dark ? "#4a5561" : "#b9c3cd");
    this.shadow.color.copy(this.paper).lerp(new THREE.Color(dark ? "#000000" : "#1d2733"),
      dark ? 0.45 : 0.13);
  }
}

/** Where one looks from: turned by drags and keys about a point that may go with the robot. */
class Orbit {
  constructor(view) {
    this.view = view;
    this.camera = new THREE.PerspectiveCamera(32, 1, view.radius_m / 50, view.radius_m * 60);
    this.camera.up.set(0, 0, 1);
    this.target = new THREE.Vector3(...view.centre_m);
    this.zoom = 1;
    this.turn_to(0.5, 0.18);
  }

  /** Of azimuth 0 and elevation 0 one sees x to the right and z up. */
  turn_to(azimuth_rad, elevation_rad) {
    this.azimuth_rad = azimuth_rad;
    this.elevation_rad = Math.max(-0.2, Math.min(1.55, elevation_rad));
  }

  turn_by(azimuth_rad, elevation_rad) {
    this.turn_to(this.azimuth_rad + azimuth_rad, this.elevation_rad + elevation_rad);
  }

  zoom_by(factor) {
    this.zoom = Math.max(0.15, Math.min(12, this.zoom * factor));
  }

  /** All of the motion fits at zoom 1, whatever the window's shape. */
  place(aspect) {
    const half = (this.camera.fov * Math.PI) / 360;
    const narrow = Math.min(half, Math.atan(Math.tan(half) * aspect));
    const distance = this.view.radius_m / Math.sin(narrow) / this.zoom;
    const [a, e] = [this.azimuth_rad, this.elevation_rad];
    const back = new THREE.Vector3(
      Math.sin(a) * Math.cos(e), -Math.cos(a) * Math.cos(e), Math.sin(e));
    this.camera.aspect = aspect;
    this.camera.position.copy(this.target).addScaledVector(back, distance);
    this.camera.lookAt(this.target);
    this.camera.updateProjectionMatrix();
    return distance;
  }
}

/** Poses of a robot's bodies at the samples that the cursor may stand on. */
class Poses {
  constructor(view, { places, turns }) {
    this.count = view.bodies.length;
    this.places = decoded(places, Float32Array);
    this.turns = decoded(turns, Int16Array);
  }

  /** The centre of mass comes after the bodies. */
  place(sample, body, to) {
    return to.fromArray(this.places, 3 * (sample * (this.count + 1) + body));
  }

  move(sample, frames) {
    const place = new THREE.Vector3();
    const turn = new THREE.Quaternion();
    const size = new THREE.Vector3(1, 1, 1);
    frames.forEach((frame, body) => {
      this.place(sample, body, place);
      const at = 4 * (sample * this.count + body);
      const [w, x, y, z] = this.turns.subarray(at, at + 4);
      frame.matrixWorld.compose(place, turn.set(x, y, z, w).normalize(), size);
    });
  }
}

/** The ground's forces on the contact points as arrows, all of them drawn in one go. */
class Arrows {
  constructor(count, colours, size_m) {
    this.thick_m = 0.009 * size_m;
    const up = new THREE.Vector3(0, 0, 1);
    const shaft = new Solid();
    shaft.lathe(new THREE.Vector3(), up,
      [[0, 0, 0, -1], [1, 0, 0, -1], [1, 0, 1, 0], [1, 1, 1, 0]], 12);
    const head = new Solid();
    head.lathe(new THREE.Vector3(), up,
      [[0, 0, 0, -1], [1, 0, 0, -1], [1, 0, 0.9, 0.4], [0, 1, 0.9, 0.4]], 12);
    this.frames = [];
    const solids = [];
    for (let i = 0; i < count; ++i) {
      solids.push(shaft, head);
      this.frames.push(new THREE.Bone(), new THREE.Bone());
    }
    this.assembly = new Assembly(solids, solids.map((solid, i) => i), this.frames);
    this.mesh = this.assembly.mesh(colours.arrow, 2);
  }

  /** Too short a one is not seen. */
  point(arrow, from, direction, length_m) {
    const tip_m = Math.min(7 * this.thick_m, 0.5 * length_m);
    const there = length_m > 0.1 * this.thick_m ? 1 : 0;
    const turn = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 0, 1), direction);
    const thick = there * this.thick_m;
    this.frames[2 * arrow].matrixWorld.compose(from, turn,
      new THREE.Vector3(thick, thick, there * (length_m - tip_m)));
    const neck = from.clone().addScaledVector(direction, length_m - tip_m);
    this.frames[2 * arrow + 1].matrixWorld.compose(neck, turn,
      new THREE.Vector3(tip_m / 2.4, tip_m / 2.4, tip_m).multiplyScalar(there));
  }
}

/** Shapes of the bodies, their shadows on the ground, and what the ground does to them. */
class Stage {
  constructor(data, colours) {
    this.data = data;
    this.view = data.view;
    this.colours = colours;
    this.scene = new THREE.Scene();
    this.scene.fog = new THREE.Fog(0, 1, 2);
    this.scene.fog.color = colours.paper;
    this.poses = new Poses(this.view, this.view.is);
    this.frames = this.view.bodies.map(() => new THREE.Bone());
    const bodies = this.view.bodies.map((body) => this.solid(body));
    const balls = this.view.contacts.map((contact) => this.ball(contact));
    const owners = [...bodies.keys(), ...this.view.contacts.map((contact) => contact.body)];
    this.robot = new Assembly([...bodies, ...balls], owners, this.frames);
    this.shadow = this.robot.mesh(colours.shadow);
    this.scene.add(this.robot.mesh(colours.solid), this.shadow);
    if (this.view.planned) this.add_planned(bodies);
    this.add_light();
    this.add_ground();
    this.add_mass();
    this.arrows = new Arrows(this.view.contacts.length, colours, this.view.size_m);
    if (this.view.contacts.length > 0) this.scene.add(this.arrows.mesh);
    this.add_targets([...bodies, ...balls], owners);
    this.fall_light();
  }

  solid(body) {
    const solid = new Solid();
    body.capsules.forEach((capsule) => solid.capsule(capsule));
    body.boxes.forEach((box) => solid.box(box));
    return solid;
  }

  ball({ at, ball_m }) {
    const solid = new Solid();
    solid.capsule([...at, ...at, Math.max(ball_m, 0.014 * this.view.size_m)]);
    return solid;
  }

  add_planned(bodies) {
    this.planned = new Poses(this.view, this.view.planned);
    this.planned_frames = bodies.map(() => new THREE.Bone());
    const ghost = new Assembly(bodies, [...bodies.keys()], this.planned_frames);
    this.scene.add(ghost.mesh(this.colours.planned, 1));
  }

  /** What the pointer may meet: not drawn. */
  add_targets(solids, owners) {
    this.targets = solids.map((solid, i) => {
      const target = new THREE.Mesh(solid.geometry(), this.colours.mass);
      target.matrixAutoUpdate = false;
      target.matrixWorld = this.frames[owners[i]].matrixWorld;
      return target;
    });
  }

  /** Shadows fall onto the ground from a light that is high, a little to the side. */
  fall_light() {
    const ground = this.view.ground_m;
    const [x, y] = [-0.12, 0.16];
    const thin = 1e-4; // Not quite flat: three.js wants an inverse.
    this.shadow.matrix.set(1, 0, x, -x * ground, 0, 1, y, -y * ground, 0, 0, thin,
      (1 - thin) * ground + 2e-4 * this.view.size_m, 0, 0, 0, 1);
  }

  add_light() {
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x9aa4b0, 0.8));
    const sun = new THREE.DirectionalLight(0xffffff, 0.6);
    sun.position.set(0.5, -0.8, 1.2);
    this.scene.add(sun);
  }

  /** Lines over both axes; in short pieces: one that passes the eye is not drawn by every driver. */
  flat_lines() {
    const step = this.view.grid_m;
    const lines = [];
    for (let i = -GRID_CELLS; i <= GRID_CELLS; ++i) {
      for (let k = -GRID_CELLS; k < GRID_CELLS; k += GRID_PIECE) {
        lines.push(i * step, k * step, 0, i * step, (k + GRID_PIECE) * step, 0);
        lines.push(k * step, i * step, 0, (k + GRID_PIECE) * step, i * step, 0);
      }
    }
    return lines;
  }

  /** The same at the height of each step of the ground, with the upright faces between them. */
  stepped_lines() {
    const step = this.view.grid_m;
    const reach = GRID_CELLS * step;
    const { edges_m, heights_m } = this.view;
    const ends = [edges_m[0] - reach, ...edges_m, edges_m[edges_m.length - 1] + reach];
    const lines = [];
    const across = (x, z) => {
      for (let k = -GRID_CELLS; k < GRID_CELLS; k += GRID_PIECE) {
        lines.push(x, k * step, z, x, (k + GRID_PIECE) * step, z);
      }
    };
    heights_m.forEach((z, level) => {
      const [from, until] = [ends[level], ends[level + 1]];
      const inside = [];
      for (let i = Math.ceil(from / step); i * step < until; ++i) inside.push(i * step);
      [from, ...inside, until].forEach((x) => across(x, z));
      const pieces = [from, ...inside.filter((x, i) => i % GRID_PIECE === 0), until];
      for (let k = -GRID_CELLS; k <= GRID_CELLS; ++k) {
        pieces.slice(1).forEach((x, i) => lines.push(pieces[i], k * step, z, x, k * step, z));
        if (level > 0) lines.push(from, k * step, heights_m[level - 1], from, k * step, z);
      }
    });
    return lines;
  }

  add_ground() {
    const lines = this.view.edges_m ? this.stepped_lines() : this.flat_lines();
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(lines, 3));
    this.grid = new THREE.LineSegments(geometry, this.colours.grid);
    this.grid.frustumCulled = false;
    this.scene.add(this.grid);
  }

  add_mass() {
    const rows = this.poses.turns.length / 4 / this.poses.count;
    const way = [];
    for (let i = 0; i < rows; ++i) {
      way.push(...this.poses.place(i, this.poses.count, new THREE.Vector3()).toArray());
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(way, 3));
    const line = new THREE.Line(geometry, this.colours.way);
    line.frustumCulled = false;
    this.scene.add(line);
    const ball = new Solid();
    ball.capsule([0, 0, 0, 0, 0, 0, 0.02 * this.view.size_m]);
    this.mass = new THREE.Mesh(ball.geometry(), this.colours.mass);
    this.mass.frustumCulled = false;
    this.mass.renderOrder = 3;
    this.scene.add(this.mass);
  }

  /** In N, or null where none is known. */
  force_of(contact, sample) {
    const parts = [contact.x, contact.y, contact.z].map((name) => {
      const column = name && this.data.columns[name];
      return column ? column[sample] : null;
    });
    if (parts[0] === null && parts[2] === null) return null;
    return new THREE.Vector3(...parts.map((part) => part || 0));
  }

  show_contact(contact, i, sample) {
    const force = this.force_of(contact, sample);
    const size_N = force ? force.length() : 0;
    this.robot.paint(this.view.bodies.length + i,
      size_N > 0 ? this.colours.force : this.colours.idle);
    const { greatest_N, power, longest_m } = this.data.force;
    const length_m = size_N > 0 ? longest_m * (size_N / greatest_N) ** power : 0;
    const from = new THREE.Vector3(...contact.at)
      .applyMatrix4(this.frames[contact.body].matrixWorld);
    const direction = size_N > 0 ? force.divideScalar(size_N) : new THREE.Vector3(0, 0, 1);
    this.arrows.point(i, from, direction, length_m);
  }

  show(sample, bad, target) {
    this.poses.move(sample, this.frames);
    if (this.planned) this.planned.move(sample, this.planned_frames);
    const plain = [this.colours.one, this.colours.other];
    this.frames.forEach((frame, body) => {
      this.robot.paint(body, bad.has(body) ? this.colours.bad : plain[body % 2]);
    });
    this.poses.place(sample, this.poses.count, this.mass.position);
    this.view.contacts.forEach((contact, i) => this.show_contact(contact, i, sample));
    if (this.view.follows) {
      target.x = this.mass.position.x;
      target.y = this.mass.position.y;
    }
    const step = this.view.grid_m;
    const along = this.view.edges_m ? 0 : step * Math.round(target.x / step); // Edges stay.
    this.grid.position.set(along, step * Math.round(target.y / step), this.view.ground_m);
  }
}

/** What stands beside the pointer. */
class Hover {
  constructor(stage, box, number) {
    this.stage = stage;
    this.box = box;
    this.number = number;
    this.ray = new THREE.Raycaster();
    this.at = null; // In the canvas, from its left upper corner, in CSS pixels.
  }

  lines(hit, sample) {
    const at = this.stage.targets.indexOf(hit);
    const { bodies, contacts } = this.stage.view;
    if (at >= bodies.length) {
      const contact = contacts[at - bodies.length];
      const force = this.stage.force_of(contact, sample);
      const parts = force ? force.toArray().map((part) => this.number(part, 3)).join(", ") : "";
      return [contact.name, force
        ? `force ${this.number(force.length(), 3)} N (${parts})` : "no force is known"];
    }
    const said = bodies[at];
    return [said.name, ...said.told.map(({ words, column, unit }) =>
      `${words} ${this.number(this.stage.data.columns[column][sample])} ${unit}`)];
  }

  update(camera, width, height, sample) {
    this.box.hidden = true;
    if (!this.at) return;
    const place = new THREE.Vector2((2 * this.at.x) / width - 1, 1 - (2 * this.at.y) / height);
    this.ray.setFromCamera(place, camera);
    const [hit] = this.ray.intersectObjects(this.stage.targets);
    if (!hit) return;
    this.box.replaceChildren(...this.lines(hit.object, sample).map((text) => {
      const line = document.createElement("div");
      line.textContent = text;
      return line;
    }));
    this.box.hidden = false;
    const left = Math.min(this.at.x + 14, width - this.box.offsetWidth - 4);
    this.box.style.left = `${Math.max(4, left)}px`;
    this.box.style.top = `${Math.max(4, this.at.y - this.box.offsetHeight - 10)}px`;
  }
}

/** The view of a page; null where it has none, or where the browser has no WebGL: that is said. */
function turningView(data, number) {
  const figure = document.querySelector("figure.turning");
  if (!figure || !data.view) return null;
  const canvas = figure.querySelector("canvas");
  // Kept, so that the picture can be saved as one sees it.
  const wish = { alpha: true, stencil: false, preserveDrawingBuffer: true };
  const context =
    canvas.getContext("webgl", { ...wish, antialias: true, failIfMajorPerformanceCaveat: true }) ||
    canvas.getContext("webgl", { ...wish, antialias: false });
  if (!context) {
    figure.querySelector(".no-webgl").hidden = false;
    return null;
  }
  const renderer = new THREE.WebGLRenderer({ canvas, context });
  figure.classList.add("turns");
  for (const part of figure.querySelectorAll(".view, .view-words")) part.hidden = false;
  const colours = new Colours();
  const stage = new Stage(data, colours);
  const orbit = new Orbit(data.view);
  const hover = new Hover(stage, figure.querySelector(".hover"), number);
  const isFast = context.getContextAttributes().antialias; // Else the processor draws.
  let now = 0;
  let bad = new Set();
  let asked = 0; // The next frame, if one is to be drawn.
  // Told by the browser: to ask for it would have the whole page laid out in every frame.
  let [width, height] = [canvas.clientWidth, canvas.clientHeight];

  function draw() {
    asked = 0;
    if (width === 0 || height === 0) return;
    const ratio = isFast ? Math.min(2, devicePixelRatio) : 1;
    if (canvas.width !== Math.floor(width * ratio) || canvas.height !== Math.floor(height * ratio)) {
      renderer.setPixelRatio(ratio);
      renderer.setSize(width, height, false);
    }
    stage.show(now, bad, orbit.target);
    const distance = orbit.place(width / height);
    stage.scene.fog.near = distance;
    stage.scene.fog.far = distance + 5 * data.view.radius_m;
    renderer.render(stage.scene, orbit.camera);
    hover.update(orbit.camera, width, height, now);
    canvas.dataset.azimuth = orbit.azimuth_rad;
    canvas.dataset.elevation = orbit.elevation_rad;
    canvas.dataset.zoom = orbit.zoom;
  }
  // A processor that draws is not asked for sixty pictures a second: the charts need it too.
  const kPatience_ms = 150;
  const ask = () => {
    if (asked) return;
    asked = isFast ? requestAnimationFrame(draw) : setTimeout(draw, kPatience_ms);
  };

  const held = new Map(); // Pointers that are down: a second one zooms.
  const inCanvas = (event) => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const gap = () => {
    const [one, other] = [...held.values()];
    return Math.hypot(one.x - other.x, one.y - other.y);
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    held.set(event.pointerId, inCanvas(event));
    hover.at = inCanvas(event);
    ask();
  });
  canvas.addEventListener("pointermove", (event) => {
    const at = inCanvas(event);
    hover.at = held.size > 0 ? null : at;
    const before = held.get(event.pointerId);
    if (before && held.size === 1) orbit.turn_by((before.x - at.x) / 120, (at.y - before.y) / 120);
    const wide = held.size === 2 ? gap() : 0;
    if (before) held.set(event.pointerId, at);
    if (before && wide > 0) orbit.zoom_by(gap() / wide);
    ask();
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, (event) => held.delete(event.pointerId));
  }
  canvas.addEventListener("pointerleave", () => { hover.at = null; ask(); });
  canvas.addEventListener("wheel", (event) => {
    // The page scrolls past a view that nobody has taken hold of.
    if (document.activeElement !== canvas && !event.ctrlKey) return;
    event.preventDefault();
    orbit.zoom_by(Math.exp(-event.deltaY / 600));
    ask();
  }, { passive: false });

  const keys = {
    ArrowLeft: () => orbit.turn_by(0.1, 0), ArrowRight: () => orbit.turn_by(-0.1, 0),
    ArrowUp: () => orbit.turn_by(0, 0.1), ArrowDown: () => orbit.turn_by(0, -0.1),
    "+": () => orbit.zoom_by(1.2), "-": () => orbit.zoom_by(1 / 1.2),
  };
  canvas.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key]();
    ask();
  });
  const views = {
    turned: [0.5, 0.18], side: [0, 0], front: [Math.PI / 2, 0.05], above: [0, 1.55],
  };
  for (const button of figure.querySelectorAll("[data-look]")) {
    button.addEventListener("click", () => {
      const look = button.dataset.look;
      if (views[look]) orbit.turn_to(...views[look]);
      else keys[look]();
      ask();
    });
  }

  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    colours.read();
    ask();
  });
  new ResizeObserver(([{ contentRect }]) => {
    [width, height] = [contentRect.width, contentRect.height];
    ask();
  }).observe(canvas);
  return {
    show(sample, bodies) {
      now = sample;
      bad = bodies;
      ask();
    },
  };
}
