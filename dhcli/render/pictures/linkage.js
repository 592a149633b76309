// The page of a planar linkage: Newton on the poses of its links, along the curve that its joints leave free.
const D = JSON.parse($("model").textContent), svg = $("figure"), W = 820, H = 640, L = D.size, G = D.ground, N = D.links.length;
const moving = D.links.map((_, i) => i).filter((i) => i !== G), slot = new Map(moving.map((l, k) => [l, 3 * k])), n = 3 * moving.length;
const unitOf = (p) => p && [p[0] / L, p[1] / L], joints = D.joints.map((j) => ({ ...j, p: unitOf(j.p), o: unitOf(j.o), rest: j.o && far(j.p, j.o) / L, u: j.u && [j.u[0] / Math.hypot(...j.u), j.u[1] / Math.hypot(...j.u)] }));
let X = new Array(n).fill(0), trail = [], last = null, playing = 0, note = "";

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
function svd(rows) { // one-sided Jacobi: rows = U S V', for small systems, also rank deficient ones
  const m = rows.length, A = Array.from({ length: n }, (_, j) => rows.map((r) => r[j])), V = Array.from({ length: n }, (_, j) => Array.from({ length: n }, (_, i) => +(i === j)));
  for (let sweep = 0; sweep < 40; sweep++) {
    let off = 0;
    for (let p = 0; p < n; p++) for (let q = p + 1; q < n; q++) {
      let a = 0, b = 0, c = 0; const P = A[p], Q = A[q];
      for (let i = 0; i < m; i++) { a += P[i] * P[i]; b += Q[i] * Q[i]; c += P[i] * Q[i]; }
      if (Math.abs(c) <= 1e-15 * Math.sqrt(a * b) || c === 0 || Math.abs(c) < 1e-300) continue;
      off = 1; const z = (b - a) / (2 * c), t = Math.sign(z || 1) / (Math.abs(z) + Math.sqrt(1 + z * z)), k = 1 / Math.sqrt(1 + t * t), s = k * t;
      for (const M of [A, V]) { const u = M[p], v = M[q]; for (let i = 0; i < u.length; i++) { const w = u[i]; u[i] = k * w - s * v[i]; v[i] = s * w + k * v[i]; } }
    }
    if (!off) break;
  }
  const S = A.map((c) => Math.hypot(...c)), order = S.map((_, i) => i).sort((i, j) => S[j] - S[i]);
  return { S: order.map((i) => S[i]), V: order.map((i) => V[i]), U: order.map((i) => A[i].map((c) => (S[i] > 0 ? c / S[i] : 0))) };
}
const dotn = (a, b) => a.reduce((s, v, i) => s + v * b[i], 0);
function least({ S, V, U }, r, rank) { const d = new Array(n).fill(0); for (let k = 0; k < rank; k++) { const c = dotn(U[k], r) / S[k]; for (let i = 0; i < n; i++) d[i] += c * V[k][i]; } return d; }
const first = svd(demands(X)[1]), RANK = first.S.filter((s) => s > 1e-7 * first.S[0]).length, F = n - RANK;

function settle(x) { // Newton back onto what the joints demand; null if it does not come home
  let y = x.slice();
  for (let k = 0; k < 14; k++) {
    const [R, J] = demands(y), worst = Math.max(0, ...R.map(Math.abs));
    if (!Number.isFinite(worst)) return null;
    if (worst < 2e-15 || (k > 6 && worst < 1e-13)) return y;
    if (!R.length) return y;
    const d = least(svd(J), R, RANK); y = y.map((v, i) => v - d[i]);
    if (Math.max(...d.map(Math.abs)) < 1e-15) break;
  }
  return Math.max(0, ...demands(y)[0].map(Math.abs)) < 1e-11 ? y : null;
}
function track() { // what the point to be traced has come by, step for step
  const t = D.points[$("trace").value]; if (!t) return;
  const p = moved(X, t[2], unitOf(t[1])).map((v) => v * L); if (last && far(p, last) < 0.002 * L) return;
  trail.push(p); last = p; if (trail.length > 4000) trail.shift();
}
const SHORT = 0.02, THIN = 0.0015;
function step(want) { // move along the freedom towards a wanted displacement of all links, a short way; false at a dead position
  for (let h = SHORT; h > 1e-4; h /= 2) {
    const { V } = svd(demands(X)[1]), free = V.slice(RANK), d = new Array(n).fill(0);
    for (const z of free) { const c = dotn(z, want); for (let i = 0; i < n; i++) d[i] += c * z[i]; }
    const size = Math.max(...d.map(Math.abs)); if (size < 1e-12) return false;
    const k = Math.min(1, h / size), go = d.map((v) => v * k), y = settle(X.map((v, i) => v + go[i])); if (!y) continue;
    const jump = y.map((v, i) => v - X[i]), long = Math.hypot(...jump); if (long > 3 * Math.hypot(...go) + 1e-12) continue;
    const after = svd(demands(y)[1]); if (RANK && after.S[RANK - 1] < THIN * after.S[0]) { const over = leap(go); if (over) { X = over; track(); return true; } return false; }
    const back = after.V.slice(RANK).reduce((s, z) => s + dotn(z, jump) ** 2, 0); if (long > 1e-9 && back < 0.9 * long * long) continue; // another branch
    X = y; track(); return true;
  }
  return false;
}
function leap(go) { // past a position where branches meet, straight on, to the first sound one beyond
  let d = go; const g = Math.hypot(...go);
  for (let k = 2; k < 12; k++) {
    const y = settle(X.map((v, i) => v + k * d[i])); if (!y) return null;
    const jump = y.map((v, i) => v - X[i]), long = Math.hypot(...jump), after = svd(demands(y)[1]);
    if (dotn(jump, go) < 0.985 * long * g || long > 1.5 * k * g) return null;
    if (after.S[RANK - 1] >= THIN * after.S[0]) { const back = after.V.slice(RANK).reduce((s, z) => s + dotn(z, jump) ** 2, 0); return back > 0.97 * long * long ? y : null; }
  }
  return null;
}
const DEAD = "further it cannot go: a dead position";
function wantAt(l, p, to) { // the displacement of all links that brings a point nearer to where it is wanted
  const u = moved(X, l, p), d = [to[0] - u[0], to[1] - u[1]], s = slope(X, l, p), rows = [rowOf(), rowOf()];
  put(rows[0], l, s[0]); put(rows[1], l, s[1]);
  const free = svd(demands(X)[1]).V.slice(RANK), seen = free.map((z) => [dotn(rows[0], z), dotn(rows[1], z)]), want = new Array(n).fill(0);
  let a = 1e-9, b = 0, c = 1e-9; for (const [x, y] of seen) { a += x * x; b += x * y; c += y * y; }
  const D2 = a * c - b * b, e = [(c * d[0] - b * d[1]) / D2, (a * d[1] - b * d[0]) / D2];
  seen.forEach(([x, y], k) => { const t = x * e[0] + y * e[1]; for (let i = 0; i < n; i++) want[i] += t * free[k][i]; });
  return want;
}
function dragTo(l, p, to) {
  note = F ? "" : "it is rigid: nothing can move";
  for (let k = 0; k < 60 && F; k++) {
    const before = far(moved(X, l, p), to), want = wantAt(l, p, to); if (before < 1e-6 || Math.max(...want.map(Math.abs)) < 1e-6) break;
    const kept = X.slice(); if (!step(want)) { note = DEAD; break; }
    if (far(moved(X, l, p), to) > before - 1e-9) { X = kept; break; }
  }
}
// What can be driven: the turn of a link, or the way of a slider on the ground.
const drivers = moving.map((l) => ({ l, slide: joints.find((j) => j.t === "prismatic" && ((j.a === G && j.b === l) || (j.b === G && j.a === l))) })).map((d) => ({ ...d, read: (x) => (d.slide ? dotn(pose(x, d.l), [...d.slide.u, 0]) : pose(x, d.l)[2]), row: () => { const r = rowOf(); put(r, d.l, d.slide ? [...d.slide.u, 0] : [0, 0, 1]); return r; } }));
let driver = drivers[0];
function driveTo(value) { // turn a link to an angle, or slide it; where it cannot, as far as it goes
  note = F ? "" : "it is rigid: nothing can move";
  const row = driver.row();
  for (let k = 0; k < 2000 && F; k++) {
    const left = value - driver.read(X); if (Math.abs(left) < 1e-11) return;
    const free = svd(demands(X)[1]).V.slice(RANK), seen = free.map((z) => dotn(row, z)), s = dotn(seen, seen);
    if (s < 1e-7) { note = DEAD; return; }
    const want = new Array(n).fill(0); seen.forEach((c, i) => { for (let q = 0; q < n; q++) want[q] += (c * left * free[i][q]) / s; });
    const kept = X.slice(), was = Math.abs(left); if (!step(want)) { note = DEAD; return; }
    if (Math.abs(value - driver.read(X)) > was - 1e-15 && was > 1e-9) { X = kept; note = DEAD; return; }
  }
}
window.dhcli = { drive: (name, v) => { driver = drivers.find((d) => D.links[d.l][0] === name); driveTo(v); draw(); return driver.read(X); }, drag: (name, to) => { const p = D.points.find((q) => q[0].map((r) => r[0]).join("") === name); dragTo(p[2], unitOf(p[1]), unitOf(to)); draw(); }, at: (name) => { const p = D.points.find((q) => q[0].map((r) => r[0]).join("") === name); return moved(X, p[2], unitOf(p[1])).map((v) => v * L); }, gap: () => Math.max(0, ...demands(X)[0].map(Math.abs)) * L, freedom: F, state: () => X.slice(), home: () => { X = X.map(() => 0); draw(); }, note: () => note };

const signed = (v, k) => { const t = v.toFixed(k); return (+t === 0 ? t.replace("-", "") : t).replace("-", "−"); };
const every = D.links.flatMap((l) => l[1]).concat(D.joints.map((j) => j.p), D.circles.flatMap(([, c, r]) => [[c[0] - r, c[1] - r], [c[0] + r, c[1] + r]]));
const span = [0, 1].map((i) => [Math.min(...every.map((p) => p[i])), Math.max(...every.map((p) => p[i]))]);
let K = Math.min((W - 180) / Math.max(span[0][1] - span[0][0], 1e-9), (H - 180) / Math.max(span[1][1] - span[1][0], 1e-9), 460 / (0.5 * L)), O = [W / 2 - (K * (span[0][0] + span[0][1])) / 2, H / 2 + (K * (span[1][0] + span[1][1])) / 2];
const flat = (p) => [O[0] + K * p[0], O[1] - K * p[1]], there = (l, p) => flat(moved(X, l, unitOf(p)).map((v) => v * L));
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
    if (l === G) { let [p, q] = [b.ends[0], b.ends[b.ends.length - 1]]; if (p[0] > q[0]) [p, q] = [q, p]; const m = far(p, q), o = [(-(q[1] - p[1]) / m) * 7.5, ((q[0] - p[0]) / m) * 7.5]; shapes.push(...hatching([p[0] + o[0], p[1] + o[1]], [q[0] + o[0], q[1] + o[1]], 9)); }
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
  $("pins").innerHTML = "<tr><th></th><th>x</th><th>y</th></tr>" + D.points.map(([words, p, l]) => { const v = moved(X, l, unitOf(p)); return `<tr><td>${htmlOf(words)}</td>` + v.map((c) => `<td>${signed(c * L, 4)}</td>`).join("") + "</tr>"; }).join("");
  const s = driver ? driver.read(X) : 0; $("far").textContent = driver ? (driver.slide ? `${signed(s * L, 4)} m` : `${signed((s * 180) / Math.PI, 1)}°`) + " from the drawing" : "";
  if (document.activeElement !== $("drive") || note) $("drive").value = driver ? (driver.slide ? s * 360 : (s * 180) / Math.PI) : 0;
  $("note").textContent = note;
}
const onDrive = () => { const v = parseFloat($("drive").value); driveTo(driver.slide ? v / 360 : (v * Math.PI) / 180); draw(); };
let grabbed = null;
const spot = (e) => { const r = svg.getBoundingClientRect(), k = Math.min(r.width / W, r.height / H), x = (e.clientX - r.left - (r.width - W * k) / 2) / k, y = (e.clientY - r.top - (r.height - H * k) / 2) / k; return [(x - O[0]) / K, (O[1] - y) / K]; };
svg.addEventListener("pointerdown", (e) => {
  const m = spot(e); let best = [28 / K];
  for (const l of moving) {
    const pts = D.links[l][1].concat(D.circles.filter((c) => c[0] === l).map((c) => [c[1][0] + 0.8 * c[2], c[1][1]])), now = pts.map((p) => moved(X, l, unitOf(p)).map((v) => v * L));
    now.forEach((p, i) => { if (far(p, m) < best[0]) best = [far(p, m), l, pts[i]]; const o = now[(i + 1) % now.length], w = [o[0] - p[0], o[1] - p[1]], s = w[0] * w[0] + w[1] * w[1], t = s ? ((m[0] - p[0]) * w[0] + (m[1] - p[1]) * w[1]) / s : -1; if (t > 0 && t < 1) { const d = far([p[0] + t * w[0], p[1] + t * w[1]], m); if (d + 6 / K < best[0]) { const a = pts[i], b = pts[(i + 1) % pts.length]; best = [d + 6 / K, l, [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]]; } } });
  }
  if (best[1] !== undefined) { grabbed = best; playing = 0; svg.setPointerCapture(e.pointerId); svg.style.cursor = "grabbing"; }
});
svg.addEventListener("pointermove", (e) => { if (grabbed) { dragTo(grabbed[1], unitOf(grabbed[2]), unitOf(spot(e))); draw(); } });
for (const t of ["pointerup", "pointercancel"]) svg.addEventListener(t, () => { grabbed = null; svg.style.cursor = ""; });
svg.addEventListener("keydown", (e) => { const k = { ArrowRight: 2, ArrowUp: 2, ArrowLeft: -2, ArrowDown: -2 }[e.key]; if (k && driver) { driveTo(driver.read(X) + (k * Math.PI) / 180); draw(); e.preventDefault(); } });
$("driver").innerHTML = drivers.map((d, i) => `<option value="${i}">${d.slide ? "slide" : "turn"} ${esc(D.links[d.l][0])}</option>`).join("");
$("driver").onchange = () => { driver = drivers[$("driver").value]; draw(); };
$("drive").oninput = onDrive;
$("home").onclick = () => { X = X.map(() => 0); trail = []; last = null; note = ""; playing = 0; draw(); };
$("on-names").onchange = draw;
$("trace").innerHTML = "<option value=''>none</option>" + D.points.map((p, i) => `<option value="${i}">${esc(p[0].map((r) => r[0]).join(""))}</option>`).join("");
$("trace").onchange = () => { trail = []; last = null; draw(); };
$("png").onclick = () => savePng(svg, D.name);
$("play").onclick = () => { const go = (playing = playing ? 0 : 1), tick = () => { if (!playing) return; const was = driver.read(X); driveTo(was + (playing * Math.PI) / 90); if (note === DEAD) { note = ""; playing = -playing; } draw(); requestAnimationFrame(tick); }; if (go && F) tick(); };
const tied = new Set(D.joints.flatMap((j) => (j.a === G ? [j.b] : j.b === G ? [j.a] : []))), crank = drivers.findIndex((d) => D.links[d.l][0] === "crank"), begin = crank >= 0 ? crank : drivers.findIndex((d) => tied.has(d.l)); if (begin > 0) { driver = drivers[begin]; $("driver").value = begin; }
const out = D.points.findIndex((p) => p[2] === D.output); if (out >= 0) $("trace").value = out;
$("seen").textContent = F ? `${F} freedom${F > 1 ? "s" : ""} here` : "rigid"; draw();
