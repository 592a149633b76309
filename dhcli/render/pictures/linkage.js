// The page of a planar linkage: the poses of its links, x, y and angle each, what its joints demand, and the drawing.
const L = D.size, G = D.ground, N = D.links.length;
const moving = D.links.map((_, i) => i).filter((i) => i !== G), slot = new Map(moving.map((l, k) => [l, 3 * k])), n = 3 * moving.length;
const inUnits = (p) => p && [p[0] / L, p[1] / L], joints = D.joints.map((j) => ({ ...j, p: inUnits(j.p), o: inUnits(j.o), rest: j.o && far(j.p, j.o) / L, u: j.u && [j.u[0] / Math.hypot(...j.u), j.u[1] / Math.hypot(...j.u)] }));
const home = () => new Array(n).fill(0), applied = (x, d) => x.map((v, i) => v + d[i]), jumpOf = (y, x) => y.map((v, i) => v - x[i]);
const spotOf = (t) => moved(X, t[2], inUnits(t[1])).map((v) => v * L);
function seenAt(l, p) { const s = slope(X, l, p), rows = [rowOf(), rowOf()]; put(rows[0], l, s[0]); put(rows[1], l, s[1]); return { at: moved(X, l, p), rows }; }
const pose = (x, l) => (l === G ? [0, 0, 0] : x.slice(slot.get(l), slot.get(l) + 3));
const spun = (v, t) => [v[0] * Math.cos(t) - v[1] * Math.sin(t), v[0] * Math.sin(t) + v[1] * Math.cos(t)];
const moved = (x, l, p) => { const [a, b, t] = pose(x, l), r = spun(p, t); return [a + r[0], b + r[1]]; };
function rowOf() { return new Array(n).fill(0); }
function put(row, l, v) { if (l !== G) { const k = slot.get(l); for (let i = 0; i < 3; i++) row[k + i] += v[i]; } }
const slope = (x, l, p) => { const [, , t] = pose(x, l), r = spun(p, t); return [[1, 0, -r[1]], [0, 1, r[0]]]; }; // of a point's coordinates

function demands(x) { // what the joints demand: residuals and their slopes
  const R = [], J = [], push = (r, f) => { const row = rowOf(); f(row); R.push(r); J.push(row); };
  const minus = (v) => v.map((c) => -c), mix = (d, c, s) => d[0].map((_, i) => c * d[0][i] + s * d[1][i]);
  for (const j of joints) {
    const { a, b, p } = j;
    if (j.t === "revolute" || j.t === "fixed") {
      const u = moved(x, a, p), v = moved(x, b, p), da = slope(x, a, p), db = slope(x, b, p);
      for (const i of [0, 1]) push(v[i] - u[i], (row) => { put(row, b, db[i]); put(row, a, minus(da[i])); });
    }
    if (j.t === "prismatic" || j.t === "fixed") push(pose(x, b)[2] - pose(x, a)[2], (row) => { put(row, b, [0, 0, 1]); put(row, a, [0, 0, -1]); });
    if (j.t === "prismatic" || j.t === "slot") {
      const t = pose(x, a)[2], m = spun([-j.u[1], j.u[0]], t), u = moved(x, a, p), v = moved(x, b, p), d = [v[0] - u[0], v[1] - u[1]], turned = [-m[1], m[0]];
      push(m[0] * d[0] + m[1] * d[1], (row) => { put(row, b, mix(slope(x, b, p), m[0], m[1])); put(row, a, minus(mix(slope(x, a, p), m[0], m[1]))); put(row, a, [0, 0, turned[0] * d[0] + turned[1] * d[1]]); });
    }
    if (j.t === "cam" || j.t === "bar" || j.t === "rolling") {
      const u = moved(x, a, p), v = moved(x, b, j.o), d = [v[0] - u[0], v[1] - u[1]], s = Math.hypot(...d) || 1e-9, e = [d[0] / s, d[1] / s];
      push(s - j.rest, (row) => { put(row, b, mix(slope(x, b, j.o), e[0], e[1])); put(row, a, minus(mix(slope(x, a, p), e[0], e[1]))); });
      if (j.t === "rolling") {
        const w0 = Math.atan2(j.o[1] - p[1], j.o[0] - p[0]), w = Math.atan2(d[1], d[0]) - w0, f = w - 2 * Math.PI * Math.round(w / (2 * Math.PI)), [r1, r2] = j.r.map((r) => r / L), g = j.n ? -1 : 1, q = [-e[1] / s, e[0] / s];
        push(r1 * (pose(x, a)[2] - f) + g * r2 * (pose(x, b)[2] - f), (row) => { put(row, a, [0, 0, r1]); put(row, b, [0, 0, g * r2]); const k = -(r1 + g * r2); put(row, b, mix(slope(x, b, j.o), k * q[0], k * q[1])); put(row, a, minus(mix(slope(x, a, p), k * q[0], k * q[1]))); });
      }
    }
    if (j.t === "gear") {
      const [r1, r2] = j.r.map((r) => r / L), g = j.n ? -1 : 1, t = (l) => (l < 0 ? 0 : pose(x, l)[2]);
      push(r1 * (t(a) - t(j.c)) + g * r2 * (t(b) - t(j.c)), (row) => { put(row, a, [0, 0, r1]); put(row, b, [0, 0, g * r2]); if (j.c >= 0) put(row, j.c, [0, 0, -(r1 + g * r2)]); });
    }
  }
  return [R, J];
}
// What can be driven: the turn of a link, or the way of a slider on the ground.
const tied = new Set(D.joints.flatMap((j) => (j.a === G ? [j.b] : j.b === G ? [j.a] : [])));
const drivers = moving.map((l) => { const slide = joints.find((j) => j.t === "prismatic" && ((j.a === G && j.b === l) || (j.b === G && j.a === l))), dir = slide ? [...slide.u, 0] : [0, 0, 1]; return { l, slide, name: D.links[l][0], tied: tied.has(l), value: 0, read: (x) => dotn(pose(x, l), dir), row: () => { const r = rowOf(); put(r, l, dir); return r; } }; });
const every = D.links.flatMap((l) => l[1]).concat(D.joints.map((j) => j.p), D.circles.flatMap(([, c, r]) => [[c[0] - r, c[1] - r], [c[0] + r, c[1] + r]]));
const span = [0, 1].map((i) => [Math.min(...every.map((p) => p[i])), Math.max(...every.map((p) => p[i]))]);
let K = Math.min((W - 180) / Math.max(span[0][1] - span[0][0], 1e-9), (H - 180) / Math.max(span[1][1] - span[1][0], 1e-9), 460 / (0.5 * L)), O = [W / 2 - (K * (span[0][0] + span[0][1])) / 2, H / 2 + (K * (span[1][0] + span[1][1])) / 2];
const flat = (p) => [O[0] + K * p[0], O[1] - K * p[1]], there = (l, p) => flat(moved(X, l, inUnits(p)).map((v) => v * L));
function hatching(a, b, s) {
  const m = far(a, b), k = Math.max(2, Math.round(m / (1.1 * s))), dx = (b[0] - a[0]) / m, dy = (b[1] - a[1]) / m;
  return Array.from({ length: k }, (_, i) => { const t = ((i + 1) / k) * m, x = a[0] + dx * t, y = a[1] + dy * t; return line([[x, y], [x - s * dx - s * dy, y - s * dy + s * dx]], "hatch-line"); });
}
function bar(l, pts) {
  const f = pts.map((p) => there(l, p)); let ends = f;
  if (f.length > 2) {
    let best = [0]; f.forEach((a) => f.forEach((b) => { const d = far(a, b); if (d > best[0]) best = [d, a, b]; }));
    const [d, a, b] = best, off = Math.max(...f.map((p) => Math.abs(turn(a, b, p)) / d));
    if (off < 0.01) ends = [a, b]; else return { ends: f, shape: poly(hull(f).length === f.length ? hull(f.flatMap((p) => ring(p, 7.5, 20))) : around(f), "bar") };
  }
  return { ends, shape: poly(hull(ends.flatMap((p) => ring(p, 7.5, 20))), "bar") };
}
function around(f) { const c = [0, 1].map((i) => f.reduce((s, p) => s + p[i], 0) / f.length); return f.slice().sort((a, b) => Math.atan2(a[1] - c[1], a[0] - c[0]) - Math.atan2(b[1] - c[1], b[0] - c[0])); }
function outer(f) { // the side of a plate that is farthest from the middle of the paper, with the plate on the left as one goes
  const g = around(f), o = g.map((a, i) => [a, g[(i + 1) % g.length]]), away = ([a, b]) => Math.hypot((a[0] + b[0] - W) / 2, (a[1] + b[1] - H) / 2), [a, b] = o.reduce((m, s) => (away(s) > away(m) + 1e-6 ? s : m)), c = [0, 1].map((i) => f.reduce((s, p) => s + p[i], 0) / f.length);
  return turn(a, b, c) < 0 ? [a, b] : [b, a];
}
function slider(j, at0, angle, ground) {
  let [dx, dy] = spun(j.u, angle); dy = -dy; if (dx < 0 || (dx === 0 && dy > 0)) { dx = -dx; dy = -dy; }
  const nx = -dy, ny = dx, w = 21, h = 14, g = ground || at0, a = [g[0] - 62 * dx + h * nx, g[1] - 62 * dy + h * ny], b = [g[0] + 62 * dx + h * nx, g[1] + 62 * dy + h * ny];
  const reach = Math.max(0, far(g, at0) - 40), s = (at0[0] - g[0]) * dx + (at0[1] - g[1]) * dy > 0 ? b : a; s[0] += (s === b ? 1 : -1) * reach * dx; s[1] += (s === b ? 1 : -1) * reach * dy;
  return [line([a, b], "ground-line"), ...(ground ? hatching(a, b, 9) : []), poly([[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([s, t]) => [at0[0] + s * w * dx + t * h * nx, at0[1] + s * w * dy + t * h * ny]), "bar")];
}
function draw() {
  const shapes = [], seen = [], same = (p) => seen.some((q) => far(p, q) < 0.5) || !seen.push(p), centres = new Map();
  if (!D.bar) for (const j of D.joints) if ((j.a === G || j.b === G) && ["revolute", "bar", "cam"].includes(j.t)) {
    const [x, y] = flat(j.p); if (same([x, y])) continue; const s = 11, low = y + 1.7 * s;
    shapes.push(poly([[x, y], [x + 0.95 * s, low], [x - 0.95 * s, low]], "pin-ground"), line([[x - 1.5 * s, low], [x + 1.5 * s, low]], "ground-line"), ...hatching([x - 1.5 * s, low], [x + 1.5 * s, low], s / 2));
  }
  for (const [l, c, r] of D.circles) { const p = there(l, c), m = pose(X, l)[2], e = [c[0] + r, c[1]]; centres.set(l, [p, r * K]); shapes.push(poly(ring(p, r * K, 60), "wheel"), poly(ring(p, 2, 8), "axis-dot"), line([p, there(l, e)], "extension")); const hub = D.links[l][1].find((q) => far(q, c) > 1e-9 * L); if (hub) shapes.push(line([there(l, hub), p], "axis")); }
  const ends = new Map();
  D.links.forEach(([, pts], l) => {
    if (pts.length < 2 || (l === G && !D.bar)) return;
    const b = bar(l, pts); ends.set(l, b.ends); shapes.push(b.shape);
    if (l === G) { const [p, q] = b.ends.length > 2 ? outer(b.ends) : b.ends[0][0] > b.ends[1][0] ? [b.ends[1], b.ends[0]] : b.ends; const m = far(p, q), o = [(-(q[1] - p[1]) / m) * 7.5, ((q[0] - p[0]) / m) * 7.5]; shapes.push(...hatching([p[0] + o[0], p[1] + o[1]], [q[0] + o[0], q[1] + o[1]], 9)); }
  });
  for (const j of joints) {
    if (j.t === "prismatic") { const ground = j.a === G || j.b === G, l = j.a === G ? j.b : j.a; shapes.push(...slider(j, there(l, [j.p[0] * L, j.p[1] * L]), pose(X, j.a)[2], ground ? flat([j.p[0] * L, j.p[1] * L]) : null)); }
    if (j.t === "slot") { const c = there(j.a, [j.p[0] * L, j.p[1] * L]); let [dx, dy] = spun(j.u, pose(X, j.a)[2]); shapes.push(poly(hull([-1, 1].flatMap((s) => ring([c[0] + s * 46 * dx, c[1] - s * 46 * dy], 8.5, 20))), "pin")); }
    if (j.t === "bar") shapes.push(line([there(j.a, [j.p[0] * L, j.p[1] * L]), there(j.b, [j.o[0] * L, j.o[1] * L])], "edge"));
  }
  seen.length = 0;
  for (const j of D.joints) if (["revolute", "slot", "bar"].includes(j.t)) { const p = there(j.t === "slot" || j.a === G ? j.b : j.a, j.p); if (!same(p)) shapes.push(poly(ring(p, 5.5, 20), "pin")); }
  if ($("trace").value !== "") { track(); if (trail.length > 1) shapes.push(line(trail.map(flat), "trace")); }
  const ink = Ink(W, H); ink.add(shapes); const wishes = [];
  if ($("on-names").checked) {
    for (const [words, p, l] of D.points) wishes.push({ p: [there(l, p)], words, look: "mark", away: [0.6, -1] });
    if (moving.length < 10) for (const l of moving) { const c = centres.get(l), e = ends.get(l), words = [[D.links[l][0], 0]]; if (c) wishes.push({ p: [0.9, 2.3, -0.8, -2.3].map((a) => [c[0][0] + c[1] * Math.cos(a), c[0][1] + c[1] * Math.sin(a)]), words, look: "dim", away: [0, 0] }); else if (e) wishes.push({ p: e.map((a, i) => { const b = e[(i + 1) % e.length]; return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]; }), words, look: "dim", away: [0, 0] }); else if (D.links[l][1][0]) wishes.push({ p: [there(l, D.links[l][1][0])], words, look: "dim", away: [0, 1] }); }
  }
  const [leaders, texts] = placed(wishes, ink, [3, 3, W - 3, H - 3]);
  svg.innerHTML = svgOf(shapes.concat(leaders), texts);
  told();
}
let grabbed = null;
const spot = (e) => { const r = svg.getBoundingClientRect(), k = Math.min(r.width / W, r.height / H), x = (e.clientX - r.left - (r.width - W * k) / 2) / k, y = (e.clientY - r.top - (r.height - H * k) / 2) / k; return [(x - O[0]) / K, (O[1] - y) / K]; };
svg.addEventListener("pointerdown", (e) => {
  const m = spot(e); let best = [28 / K];
  for (const l of moving) {
    const pts = D.links[l][1].concat(D.circles.filter((c) => c[0] === l).map((c) => [c[1][0] + 0.8 * c[2], c[1][1]])), now = pts.map((p) => moved(X, l, inUnits(p)).map((v) => v * L));
    now.forEach((p, i) => { if (far(p, m) < best[0]) best = [far(p, m), l, pts[i]]; const o = now[(i + 1) % now.length], w = [o[0] - p[0], o[1] - p[1]], s = w[0] * w[0] + w[1] * w[1], t = s ? ((m[0] - p[0]) * w[0] + (m[1] - p[1]) * w[1]) / s : -1; if (t > 0 && t < 1) { const d = far([p[0] + t * w[0], p[1] + t * w[1]], m); if (d + 6 / K < best[0]) { const a = pts[i], b = pts[(i + 1) % pts.length]; best = [d + 6 / K, l, [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]]; } } });
  }
  if (best[1] !== undefined) { grabbed = best; playing = 0; svg.setPointerCapture(e.pointerId); svg.style.cursor = "grabbing"; }
});
svg.addEventListener("pointermove", (e) => { if (grabbed) { dragTo(grabbed[1], inUnits(grabbed[2]), inUnits(spot(e))); draw(); } });
for (const t of ["pointerup", "pointercancel"]) svg.addEventListener(t, () => { grabbed = null; svg.style.cursor = ""; });
svg.addEventListener("keydown", (e) => { const k = { ArrowRight: 2, ArrowUp: 2, ArrowLeft: -2, ArrowDown: -2 }[e.key]; if (k && driver) { driveTo(driver.read(X) + (k * Math.PI) / 180); draw(); e.preventDefault(); } });
