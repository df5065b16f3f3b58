// Plays the frames of the page: three.js draws, this file unpacks them, turns the view, and goes through time.
"use strict";
(function () {
const box = document.getElementById("film");
const films = JSON.parse(document.getElementById("film-data").textContent);
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
function starts(counts) {
  const first = [0];
  for (const count of counts) first.push(first[first.length - 1] + count);
  return first;
}
let film, rows, columns, first, frames, links, firstLink;  // of the film that is shown

// One shape, drawn once for each particle
const renderer = new THREE.WebGLRenderer({ canvas: canvas, context: context, antialias: true, alpha: true });
renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(24, 1, 1, 10);
const colours = films[0].colours;
const palette = new THREE.DataTexture(new Uint8Array(colours), colours.length / 3, 1, THREE.RGBFormat);
palette.minFilter = palette.magFilter = THREE.LinearFilter;
palette.needsUpdate = true;
function instances(shape, attributes, most) {
  const geometry = new THREE.InstancedBufferGeometry().copy(shape);
  for (const [name, width] of attributes) geometry.setAttribute(name, new THREE.InstancedBufferAttribute(new Float32Array(width * most), width));
  return geometry;
}
function draw_only(geometry, count) {
  for (const name of Object.keys(geometry.attributes)) if (geometry.attributes[name].isInstancedBufferAttribute) geometry.attributes[name].needsUpdate = true;
  geometry.maxInstancedCount = geometry.instanceCount = count;  // one of them, by the version of three.js
}
const paper = new THREE.Color(0xf4f6f8);  // behind everything
const balls = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.ShaderMaterial({
  uniforms: { palette: { value: palette }, paper: { value: paper }, pale: { value: 0 }, lift: { value: 0 } },
  vertexShader: `attribute vec4 place; attribute float shade; varying vec3 n, eye; varying float s;
    void main() { vec4 at = modelViewMatrix * vec4(place.xyz + place.w * position, 1.0);
      n = normalMatrix * position; eye = -at.xyz; s = shade; gl_Position = projectionMatrix * at; }`,
  fragmentShader: `uniform sampler2D palette; uniform vec3 paper; uniform float pale, lift; varying vec3 n, eye; varying float s;
    void main() { vec3 m = normalize(n); float lit = max(0.0, dot(m, normalize(vec3(-0.5, 0.7, 1.0))));
      float rim = smoothstep(0.05, 0.35, dot(m, normalize(eye)));
      vec3 colour = texture2D(palette, vec2(s, 0.5)).rgb * (0.75 + 0.45 * lit) * (0.4 + 0.6 * rim) + 0.06 * lit + 0.10 * pow(lit, 24.0) + lift;
      gl_FragColor = vec4(mix(colour, paper, pale), 1.0); }`,
}));
balls.frustumCulled = false;
scene.add(balls);

// Force chains: a tube a contact, from centre to centre or to the wall, as wide as the force that presses; drawn over pale spheres
const pull = new THREE.Color(0x1f78c8), press = new THREE.Color(0x1d2733);
const tubes = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.ShaderMaterial({
  uniforms: { press: { value: press }, pull: { value: pull } }, transparent: true,
  vertexShader: `attribute vec3 one, other; attribute float force; varying vec3 n; varying float f;
    void main() { vec3 along = normalize(other - one), side = normalize(cross(along, abs(along.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
      vec3 out_ = position.x * side + position.z * cross(along, side);
      n = normalMatrix * out_; f = force;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(mix(one, other, position.y + 0.5) + abs(force) * out_, 1.0); }`,
  fragmentShader: `uniform vec3 press, pull; varying vec3 n; varying float f;
    void main() { float lit = max(0.0, dot(normalize(n), normalize(vec3(-0.5, 0.7, 1.0))));
      gl_FragColor = vec4((f < 0.0 ? pull : press) * (0.75 + 0.35 * lit) + 0.12 * lit, 1.0); }`,
}));
tubes.frustumCulled = false;
tubes.visible = false;
tubes.renderOrder = 9;
tubes.onBeforeRender = (renderer) => renderer.clearDepth();
scene.add(tubes);
const thickest = 0.3;  // of the largest particle's radius: the strongest force

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
const glassColour = new THREE.Color(0x5c6e80), edgeColour = new THREE.Color(0x1d2733);
const channel = new THREE.Group();
scene.add(channel);
function build_walls(walls) {
  for (const part of channel.children.slice()) { channel.remove(part); part.geometry.dispose(); part.material.dispose(); }
  if (!walls) return;
  const glass = new THREE.BufferGeometry();
  glass.setAttribute("position", new THREE.BufferAttribute(corners(walls), 3));
  glass.computeVertexNormals();
  channel.add(new THREE.Mesh(glass, new THREE.ShaderMaterial({
    transparent: true, depthWrite: false, side: THREE.DoubleSide, uniforms: { colour: { value: glassColour } },
    vertexShader: `varying vec3 n, eye; void main() { vec4 at = modelViewMatrix * vec4(position, 1.0);
      n = normalMatrix * normal; eye = -at.xyz; gl_Position = projectionMatrix * at; }`,
    fragmentShader: `uniform vec3 colour; varying vec3 n, eye; void main() { float along = 1.0 - abs(dot(normalize(n), normalize(eye)));
      gl_FragColor = vec4(colour, 0.05 + 0.28 * along * along); }`,
  })));
  const edges = new THREE.LineSegments(new THREE.EdgesGeometry(glass, 25), new THREE.LineBasicMaterial({ transparent: true, opacity: 0.55 }));
  edges.material.color = edgeColour;
  channel.add(edges);
}

// View
const low = new THREE.Vector3(), high = new THREE.Vector3();
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
  const count = film.counts[frame], place = balls.geometry.attributes.place.array, shade = balls.geometry.attributes.shade.array;
  for (let p = 0; p < count; ++p) {
    const row = columns * (first[frame] + p);
    for (let c = 0; c < 3; ++c) place[4 * p + c] = film.low[c] + rows[row + c] * film.step[c];
    shade[p] = Math.min(1, rows[row + 3] / 65535);
    place[4 * p + 3] = columns > 4 ? rows[row + 4] * film.radius : film.radius;
  }
  draw_only(balls.geometry, count);
  if (tubes.visible) show_links(place);
  slider.value = frame;
  const words = "t = " + film.times[frame] + " ms" + (film.stages[frame] ? ", " + film.stages[frame] : "");
  slider.setAttribute("aria-valuetext", words);
  find(".moment").textContent = words;
  for (const button of find(".stages").children) button.setAttribute("aria-current", button.textContent === film.stages[frame]);
  box.dataset.frame = frame;
  dirty = true;
}
function show_links(place) {
  const { one, other, force } = tubes.geometry.attributes, count = film.contacts.counts[frame];
  const widest = thickest * (columns > 4 ? 65535 : 1) * film.radius;
  for (let k = 0; k < count; ++k) {
    const link = 4 * (firstLink[frame] + k), a = 4 * links[link], b = 4 * links[link + 1];
    for (let c = 0; c < 3; ++c) one.array[3 * k + c] = place[a + c];
    if (links[link + 1] < 65535) for (let c = 0; c < 3; ++c) other.array[3 * k + c] = place[b + c];
    else {  // a wall: at the end of the radius against its normal, whose height and turn are bytes
      const z = (links[link + 3] >> 8) / 127.5 - 1, turn = (links[link + 3] & 255) / 128 * Math.PI, flat = Math.sqrt(Math.max(0, 1 - z * z));
      [flat * Math.cos(turn), flat * Math.sin(turn), z].forEach((n, c) => { other.array[3 * k + c] = place[a + c] - place[a + 3] * n; });
    }
    force.array[k] = widest * Math.max(-1, Math.min(1, (links[link + 2] - 32768) / 32767));
  }
  draw_only(tubes.geometry, count);
  box.dataset.links = count;
}
function show_chains(wanted) {
  tubes.visible = wanted && !!film.contacts;
  balls.material.uniforms.pale.value = tubes.visible ? 0.62 : 0;
  find(".chains").setAttribute("aria-pressed", tubes.visible);
  find(".force").hidden = !tubes.visible;
  show(frame);
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
slider.oninput = () => { play(false); show(+slider.value); };
playButton.onclick = () => play(!playing);
find(".back").onclick = () => step(-1);
find(".on").onclick = () => step(1);
find(".reset").onclick = reset;
find(".chains").onclick = () => show_chains(!tubes.visible);
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
  Home: () => { play(false); show(0); }, End: () => { play(false); show(frames - 1); }, 0: reset, f: () => show_chains(!tubes.visible), Escape: () => stage.blur() };
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

// Another film
function clear(parent) { while (parent.firstChild) parent.removeChild(parent.firstChild); }
function put_ticks() {
  const ticks = find(".ticks"), rough = film.fastest / 4, ten = Math.pow(10, Math.floor(Math.log10(rough)));
  const interval = ten * [1, 2, 5, 10].find((each) => each * ten >= rough);
  clear(ticks);
  for (let value = 0; value <= film.fastest * 1.0001; value += interval) {
    const mark = document.createElement("span");
    mark.textContent = +value.toPrecision(6);
    mark.style.left = 100 * value / film.fastest + "%";
    ticks.appendChild(mark);
  }
}
function put_stages() {
  clear(find(".stages"));
  film.stages.forEach((name, k) => {
    if (!name || name === film.stages[k - 1]) return;
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = name;
    button.onclick = () => { play(false); show(k); };
    find(".stages").appendChild(button);
  });
}
function load(k) {
  film = films[k];
  rows = new Uint16Array(bytes(film.data));
  columns = film.columns.length;
  first = starts(film.counts);
  frames = film.counts.length;
  const most = Math.max.apply(null, film.counts), fine = most < 3000;
  balls.geometry.dispose();
  balls.geometry = instances(new THREE.SphereBufferGeometry(1, fine ? 28 : 12, fine ? 18 : 8), [["place", 4], ["shade", 1]], most);
  if (film.contacts) {
    links = new Uint16Array(bytes(film.contacts.data));
    firstLink = starts(film.contacts.counts);
    tubes.geometry.dispose();
    tubes.geometry = instances(new THREE.CylinderBufferGeometry(1, 1, 1, 10, 1, true), [["one", 3], ["other", 3], ["force", 1]],
      Math.max(1, Math.max.apply(null, film.contacts.counts)));
    find(".strongest").textContent = film.contacts.strongest;
  }
  find(".chains").hidden = !film.contacts;
  build_walls(film.walls);
  low.fromArray(film.box[0]);
  high.fromArray(film.box[1]);
  slider.max = frames - 1;
  find(".caption").textContent = film.caption;
  put_ticks();
  put_stages();
  reset();
  box.dataset.film = k;
  frame = Math.min(film.begin, frames - 1);
  show_chains(tubes.visible);
}
const which = find(".which");
if (films.length > 1) {
  films.forEach((each, k) => which.appendChild(new Option(each.label, k)));
  which.parentNode.hidden = false;
  which.onchange = () => { const played = playing; load(+which.value); show(played ? 0 : film.begin); play(played); };
}

// Light or dark, as the page is
const stops = [];
for (let k = 0; k < colours.length; k += 3) stops.push("rgb(" + colours.slice(k, k + 3).join(",") + ")");
find(".scale i").style.background = "linear-gradient(to right, " + stops.join(",") + ")";
function dress() {
  const style = getComputedStyle(document.documentElement), dark = style.getPropertyValue("--dark").trim() === "1";
  paper.set(style.getPropertyValue("--stage").trim() || "#f4f6f8");
  glassColour.set(dark ? 0x9fb2c6 : 0x5c6e80);
  edgeColour.set(dark ? 0xd5dde6 : 0x1d2733);
  balls.material.uniforms.lift.value = dark ? 0.09 : 0;
  press.set(dark ? 0xffffff : 0x1d2733);
  pull.set(dark ? 0x6cb6ff : 0x1f78c8);
  dirty = true;
}
dress();
document.addEventListener("dress", dress);

load(0);
resize();
if (window.ResizeObserver) new ResizeObserver(resize).observe(stage); else window.addEventListener("resize", resize);
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
