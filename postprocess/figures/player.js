// Plays the frames of the page: three.js draws, this file unpacks them, turns the view, and goes through time.
"use strict";
(function () {
const box = document.getElementById("film");
const film = JSON.parse(document.getElementById("film-data").textContent);
const find = (name) => box.querySelector(name);
const canvas = find("canvas"), stage = find(".stage"), slider = find("input"), playButton = find(".play");
const context = canvas.getContext("webgl", { antialias: true, alpha: true });
if (!context) return;  // the still stands open in its place
box.hidden = false;
const still = document.querySelector("details.still");
if (still) still.open = false;

// Data
function bytes(text) {
  const raw = atob(text), all = new Uint8Array(raw.length);
  for (let k = 0; k < raw.length; ++k) all[k] = raw.charCodeAt(k);
  return all.buffer;
}
const rows = new Uint16Array(bytes(film.data)), columns = film.columns.length;
const first = [0];
for (const count of film.counts) first.push(first[first.length - 1] + count);
const most = Math.max.apply(null, film.counts), frames = film.counts.length;

// Spheres: one shape, drawn once for each particle
const renderer = new THREE.WebGLRenderer({ canvas: canvas, context: context, antialias: true, alpha: true });
renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(24, 1, 1, 10);
const palette = new THREE.DataTexture(new Uint8Array(film.colours), film.colours.length / 3, 1, THREE.RGBFormat);
palette.minFilter = palette.magFilter = THREE.LinearFilter;
palette.needsUpdate = true;
const fine = most < 3000;
const spheres = new THREE.InstancedBufferGeometry().copy(new THREE.SphereBufferGeometry(1, fine ? 28 : 12, fine ? 18 : 8));
const place = new THREE.InstancedBufferAttribute(new Float32Array(4 * most), 4);
const shade = new THREE.InstancedBufferAttribute(new Float32Array(most), 1);
spheres.setAttribute("place", place);
spheres.setAttribute("shade", shade);
const balls = new THREE.Mesh(spheres, new THREE.ShaderMaterial({
  uniforms: { palette: { value: palette } },
  vertexShader: `attribute vec4 place; attribute float shade; varying vec3 n, eye; varying float s;
    void main() { vec4 at = modelViewMatrix * vec4(place.xyz + place.w * position, 1.0);
      n = normalMatrix * position; eye = -at.xyz; s = shade; gl_Position = projectionMatrix * at; }`,
  fragmentShader: `uniform sampler2D palette; varying vec3 n, eye; varying float s;
    void main() { vec3 m = normalize(n); float lit = max(0.0, dot(m, normalize(vec3(-0.5, 0.7, 1.0))));
      float rim = smoothstep(0.05, 0.35, dot(m, normalize(eye)));
      gl_FragColor = vec4(texture2D(palette, vec2(s, 0.5)).rgb * (0.75 + 0.45 * lit) * (0.4 + 0.6 * rim) + 0.06 * lit + 0.10 * pow(lit, 24.0), 1.0); }`,
}));
balls.frustumCulled = false;
scene.add(balls);

// Walls: thin glass, which shows most where it is seen along its face
function corners(walls) {
  if (walls.triangles) return new Float32Array(bytes(walls.triangles));
  const all = [], top = walls.height;
  for (const side of [walls.upper, walls.lower])
    for (let k = 0; k + 1 < side.length; ++k) {
      const [a, b] = [side[k], side[k + 1]];
      all.push(a[0], a[1], 0, b[0], b[1], 0, b[0], b[1], top, a[0], a[1], 0, b[0], b[1], top, a[0], a[1], top);
    }
  const around = walls.lower.concat(walls.upper.slice().reverse()).map((p) => new THREE.Vector2(p[0], p[1]));
  for (const face of THREE.ShapeUtils.triangulateShape(around, []))
    for (const z of [0, top]) for (const k of face) all.push(around[k].x, around[k].y, z);
  return new Float32Array(all);
}
if (film.walls) {
  const glass = new THREE.BufferGeometry();
  glass.setAttribute("position", new THREE.BufferAttribute(corners(film.walls), 3));
  glass.computeVertexNormals();
  scene.add(new THREE.Mesh(glass, new THREE.ShaderMaterial({
    transparent: true, depthWrite: false, side: THREE.DoubleSide,
    vertexShader: `varying vec3 n, eye; void main() { vec4 at = modelViewMatrix * vec4(position, 1.0);
      n = normalMatrix * normal; eye = -at.xyz; gl_Position = projectionMatrix * at; }`,
    fragmentShader: `varying vec3 n, eye; void main() { float along = 1.0 - abs(dot(normalize(n), normalize(eye)));
      gl_FragColor = vec4(0.36, 0.43, 0.50, 0.05 + 0.28 * along * along); }`,
  })));
  scene.add(new THREE.LineSegments(new THREE.EdgesGeometry(glass, 25),
    new THREE.LineBasicMaterial({ color: 0x1d2733, transparent: true, opacity: 0.55 })));
}

// View
const low = new THREE.Vector3().fromArray(film.box[0]), high = new THREE.Vector3().fromArray(film.box[1]);
const start = { yaw: -0.1, pitch: 0.45 };
let yaw, pitch, away, middle, dirty = true;
function basis() {
  const turn = new THREE.Matrix4().makeRotationFromEuler(new THREE.Euler(pitch, yaw, 0, "YXZ"));
  const axes = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  turn.extractBasis(axes[0], axes[1], axes[2]);
  return axes;
}
function fit() {  // the nearest place from which all of the box is seen
  const [right, up, back] = basis(), tangent = Math.tan(camera.fov * Math.PI / 360);
  let distance = 0;
  for (let k = 0; k < 8; ++k) {
    const c = new THREE.Vector3(k & 1 ? low.x : high.x, k & 2 ? low.y : high.y, k & 4 ? low.z : high.z).sub(middle);
    distance = Math.max(distance, c.dot(back) + Math.abs(c.dot(right)) / (tangent * camera.aspect), c.dot(back) + Math.abs(c.dot(up)) / tangent);
  }
  return 1.04 * distance;
}
function reset() {
  yaw = start.yaw; pitch = start.pitch;
  middle = low.clone().add(high).multiplyScalar(0.5);
  away = null;
  dirty = true;
}
function turn(dx, dy) {
  yaw -= dx;
  pitch = Math.max(-1.55, Math.min(1.55, pitch - dy));
  dirty = true;
}
function pan(dx, dy) {  // in shares of the picture's height
  const [right, up] = basis(), size = 2 * (away || fit()) * Math.tan(camera.fov * Math.PI / 360);
  away = away || fit();
  middle.addScaledVector(right, -dx * size).addScaledVector(up, dy * size);
  middle.clamp(low, high);
  dirty = true;
}
function zoom(factor) {
  const whole = fit();
  away = Math.max(0.08 * whole, Math.min(3 * whole, (away || whole) * factor));
  dirty = true;
}
function resize() {
  const width = stage.clientWidth, height = stage.clientHeight;
  if (!width || !height) return;
  renderer.setSize(width, height, false);
  camera.aspect = width / height;
  dirty = true;
}
function draw() {
  const [right, up, back] = basis(), distance = away || fit(), size = high.distanceTo(low);
  camera.position.copy(middle).addScaledVector(back, distance);
  camera.up.copy(up);
  camera.lookAt(middle);
  camera.near = Math.max(0.002 * size, distance - 1.5 * size);
  camera.far = distance + 1.5 * size;
  camera.updateProjectionMatrix();
  renderer.render(scene, camera);
}

// Time
let frame = -1, playing = false, due = 0;
function show(k) {
  frame = Math.max(0, Math.min(frames - 1, k));
  const count = film.counts[frame];
  for (let p = 0; p < count; ++p) {
    const row = columns * (first[frame] + p);
    for (let c = 0; c < 3; ++c) place.array[4 * p + c] = film.low[c] + rows[row + c] * film.step[c];
    shade.array[p] = Math.min(1, rows[row + 3] / 65535);
    place.array[4 * p + 3] = columns > 4 ? rows[row + 4] * film.radius : film.radius;
  }
  place.needsUpdate = shade.needsUpdate = true;
  spheres.maxInstancedCount = spheres.instanceCount = count;  // one of them, by the version of three.js
  slider.value = frame;
  const words = "t = " + film.times[frame] + " ms" + (film.stages[frame] ? ", " + film.stages[frame] : "");
  slider.setAttribute("aria-valuetext", words);
  find(".moment").textContent = words;
  for (const button of find(".stages").children) button.setAttribute("aria-current", button.textContent === film.stages[frame]);
  box.dataset.frame = frame;
  dirty = true;
}
function play(wanted) {
  playing = wanted;
  playButton.textContent = playing ? "Pause" : "Play";
  due = 0;
}
function step(by) { play(false); show((frame + by + frames) % frames); }
function tick(now) {
  if (playing && now >= due) {
    if (due) show((frame + 1) % frames);
    due = now + (frame === 0 || frame === frames - 1 ? 1000 : 1000 / film.rate);  // both arches are worth a look
  }
  if (dirty) { dirty = false; draw(); }
  requestAnimationFrame(tick);
}

// Controls
slider.max = frames - 1;
slider.oninput = () => { play(false); show(+slider.value); };
playButton.onclick = () => play(!playing);
find(".back").onclick = () => step(-1);
find(".on").onclick = () => step(1);
find(".reset").onclick = reset;
film.stages.forEach((name, k) => {
  if (!name || name === film.stages[k - 1]) return;
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = name;
  button.onclick = () => { play(false); show(k); };
  find(".stages").appendChild(button);
});
const held = new Map();
stage.onpointerdown = (event) => {
  held.set(event.pointerId, event);
  stage.setPointerCapture(event.pointerId);
};
stage.onpointermove = (event) => {
  const last = held.get(event.pointerId);
  if (!last) return;
  const dx = event.clientX - last.clientX, dy = event.clientY - last.clientY, height = stage.clientHeight;
  if (held.size > 1) {  // two fingers: what is between them moves and grows with them
    const other = [...held.values()].find((each) => each.pointerId !== event.pointerId);
    const length = (each) => Math.hypot(each.clientX - other.clientX, each.clientY - other.clientY);
    zoom((length(last) + 1) / (length(event) + 1));
    pan(dx / height / 2, dy / height / 2);
  } else if (event.shiftKey || event.buttons & 2) pan(dx / height, dy / height);
  else turn(dx * 0.008, dy * 0.008);
  held.set(event.pointerId, event);
};
stage.onpointerup = stage.onpointercancel = (event) => held.delete(event.pointerId);
stage.oncontextmenu = (event) => event.preventDefault();
stage.addEventListener("wheel", (event) => {
  if (document.activeElement !== stage) return;  // the page scrolls
  event.preventDefault();
  zoom(Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * 0.003));
}, { passive: false });
const keys = { " ": () => play(!playing), ",": () => step(-1), ".": () => step(1), "+": () => zoom(0.85), "=": () => zoom(0.85), "-": () => zoom(1.18),
  Home: () => { play(false); show(0); }, End: () => { play(false); show(frames - 1); }, 0: reset, Escape: () => stage.blur() };
const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
stage.onkeydown = (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const arrow = arrows[event.key];
  if (arrow && event.shiftKey) pan(arrow[0] * 0.06, arrow[1] * 0.06);
  else if (arrow) turn(arrow[0] * 0.1, arrow[1] * 0.1);
  else if (keys[event.key]) keys[event.key]();
  else return;
  event.preventDefault();
};

// Colour bar
const stops = [];
for (let k = 0; k < film.colours.length; k += 3) stops.push("rgb(" + film.colours.slice(k, k + 3).join(",") + ")");
find(".scale i").style.background = "linear-gradient(to right, " + stops.join(",") + ")";
const rough = film.fastest / 4, ten = Math.pow(10, Math.floor(Math.log10(rough)));
const interval = ten * [1, 2, 5, 10].find((each) => each * ten >= rough);
for (let value = 0; value <= film.fastest * 1.0001; value += interval) {
  const mark = document.createElement("span");
  mark.textContent = +value.toPrecision(6);
  mark.style.left = 100 * value / film.fastest + "%";
  find(".ticks").appendChild(mark);
}

reset();
resize();
if (window.ResizeObserver) new ResizeObserver(resize).observe(stage); else window.addEventListener("resize", resize);
show(film.begin);
requestAnimationFrame(tick);
// It starts when it is first seen, unless the reader wants no motion.
if (window.IntersectionObserver && !window.matchMedia("(prefers-reduced-motion: reduce)").matches) {
  let started = false;
  new IntersectionObserver((seen) => {
    const visible = seen[seen.length - 1].isIntersecting;
    if (visible && !started) { started = true; show(0); play(true); } else if (!visible) play(false);
  }, { threshold: 0.4 }).observe(stage);
}
})();
