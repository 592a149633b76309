// The page of a linkage in space: a frame for each link, what its joints demand of them, and a hand that drags.
const L = D.size, C = D.centre, G = D.ground, N = D.links.length, HOME = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]];
const moving = D.links.map((_, i) => i).filter((i) => i !== G), slot = new Map(moving.map((l, k) => [l, 6 * k])), n = 6 * moving.length;
const inUnits = (p) => p && mul(sub(p, C), 1 / L), spun = (v, w) => { // turned by a rotation vector
  const a = norm(w); if (a < 1e-300) return v; const u = mul(w, 1 / a), k = cross(u, v), c = Math.cos(a), s = Math.sin(a);
  return add(add(mul(v, c), mul(k, s)), mul(u, dot(u, v) * (1 - c)));
};
const home = () => D.links.map(() => HOME), applied = (x, d) => x.map((f, l) => { if (l === G) return f; const k = slot.get(l), w = d.slice(k, k + 3), v = d.slice(k + 3, k + 6); return [spun(f[0], w), spun(f[1], w), spun(f[2], w), add(spun(f[3], w), v)]; });
function jumpOf(y, x) { // the displacements that lead from one state to another, 6 for each link
  return moving.flatMap((l) => {
    const a = x[l], b = y[l], w = mul([0, 1, 2].map((i) => cross(a[i], b[i])).reduce(add), 0.5), s = norm(w), c = ([0, 1, 2].reduce((t, i) => t + dot(a[i], b[i]), 0) - 1) / 2;
    const turn = s > 1e-12 ? mul(w, Math.atan2(s, c) / s) : w; return [...turn, ...sub(b[3], spun(a[3], turn))];
  });
}
const SQUARE = (u) => { const a = unit(Math.abs(u[0]) < 0.6 ? cross(u, [1, 0, 0]) : cross(u, [0, 1, 0])); return [a, cross(u, a)]; };
const joints = D.ties.map((j) => { const u = j.u && unit(j.u), o = j.o && inUnits(j.o), at0 = j.p.length ? j.p : D.points[j.p][1], p = inUnits(at0); return { ...j, at0, p, o, u, v: j.v && unit(j.v), rest: o && norm(sub(o, p)), m: u && SQUARE(u), value: 0 }; });
const E3 = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], minus = (v) => mul(v, -1);
function rowOf() { return new Array(n).fill(0); }
function put(row, l, w, v) { if (l !== G) { const k = slot.get(l); for (let i = 0; i < 3; i++) { row[k + i] += w[i]; row[k + 3 + i] += v[i]; } } }
const along = (row, l, p, e, k) => put(row, l, mul(cross(p, e), k), mul(e, k)); // of a point of a link, now at p, along e
function relativeOf(x, j) { // how far a joint has turned, to the nearest of what it was, or slid
  const u = dir(x[j.a], j.u); if (j.t === "prismatic") return dot(sub(point(x[j.b], j.p), point(x[j.a], j.p)), u);
  const s = dir(x[j.a], j.m[0]), t = dir(x[j.b], j.m[0]), raw = Math.atan2(dot(cross(s, t), u), dot(s, t)); return raw + 2 * Math.PI * Math.round((j.value - raw) / (2 * Math.PI));
}
function demands(x) {
  const R = [], J = [], push = (r, f) => { const row = rowOf(); f(row); R.push(r); J.push(row); };
  for (const j of joints) {
    const { a, b } = j, fa = x[a], fb = x[b], pa = point(fa, j.p), pb = point(fb, j.p);
    const meet = (e) => push(dot(sub(pb, pa), e), (row) => { along(row, b, pb, e, 1); along(row, a, pa, e, -1); });
    const offset = (m) => { const e = dir(fa, m); push(dot(sub(pb, pa), e), (row) => { along(row, b, pb, e, 1); along(row, a, pb, e, -1); }); }; // e turns with a
    const angle = (m, k) => { const s = dir(fa, m), t = dir(fb, k), w = cross(t, s); push(dot(s, t) - dot(m, k), (row) => { put(row, b, w, [0, 0, 0]); put(row, a, minus(w), [0, 0, 0]); }); };
    const parallel = () => j.m.forEach((m) => angle(m, j.u));
    if (["revolute", "spherical", "universal", "fixed"].includes(j.t)) E3.forEach(meet);
    if (["revolute", "prismatic", "cylindrical", "helical", "planar", "slot"].includes(j.t)) parallel();
    if (j.t === "fixed") { angle(E3[0], E3[1]); angle(E3[1], E3[2]); angle(E3[2], E3[0]); }
    if (j.t === "prismatic") angle(j.m[0], j.m[1]);
    if (["prismatic", "cylindrical", "helical", "ball-in-tube"].includes(j.t)) j.m.forEach(offset);
    if (j.t === "planar" || j.t === "line-contact") offset(j.u);
    if (j.t === "slot") { offset(j.u); offset(unit(cross(j.u, j.s))); }
    if (j.t === "universal" || j.t === "line-contact") angle(j.u, j.v);
    if (j.t === "helical") { const e = dir(fa, j.u), h = j.h / L / (2 * Math.PI), w = mul(e, h); push(dot(sub(pb, pa), e) - h * relativeOf(x, j), (row) => { along(row, b, pb, e, 1); along(row, a, pb, e, -1); put(row, b, minus(w), [0, 0, 0]); put(row, a, w, [0, 0, 0]); }); }
    if (j.t === "bar" || j.t === "cam") { const q = point(fb, j.o), d = sub(q, pa), s = norm(d) || 1e-9, e = mul(d, 1 / s); push(s - j.rest, (row) => { along(row, b, q, e, 1); along(row, a, pa, e, -1); }); }
  }
  return [R, J];
}
// What can be driven: every joint that turns or slides, those on the ground first.
const drivers = joints.filter((j) => j.t === "revolute" || j.t === "prismatic").map((j) => ({
  name: j.name, slide: j.t === "prismatic", tied: j.a === G || j.b === G, get value() { return j.value; }, set value(v) { j.value = v; }, read: (x) => relativeOf(x, j),
  row: (x) => { const r = rowOf(), u = dir(x[j.a], j.u); if (j.t === "prismatic") { const p = point(x[j.b], j.p); along(r, j.b, p, u, 1); along(r, j.a, p, u, -1); } else { put(r, j.b, u, [0, 0, 0]); put(r, j.a, minus(u), [0, 0, 0]); } return r; },
})).sort((a, b) => b.tied - a.tied);
const spotOf = (t) => add(mul(point(X[t[2]], inUnits(t[1])), L), C);
// Frames of the links as the scene wants them: in metres, seen from where they were drawn.
const states = () => X.map((f) => [f[0], f[1], f[2], sub(add(mul(f[3], L), C), dir(f, C))]), under = () => [], more = () => [];
const lines = (cam) => (trail.length > 1 ? [line(trail.map(cam.flat), "trace")] : []);
let eye = null, grabbed = null; // the camera of the last drawing: a point is dragged in the plane of the paper
function above(P, cam, ink, over, wishes) {
  eye = cam; if ($("on-names").checked) for (const [words, p, l] of D.points) wishes.push({ p: [cam.flat(P.at(l, p))], words, look: "mark", away: [0, 0] });
  return [];
}
function seenAt(l, p) {
  const q = point(X[l], p), rows = [eye.right, eye.up].map((e) => { const r = rowOf(); along(r, l, q, e, 1); return r; });
  return { at: onPaper(q), rows };
}
const onPaper = (p) => [dot(p, eye.right), dot(p, eye.up)];
function grab(x, y) { // the nearest point of a moving link, if one is near
  let best = [30, null]; const st = states();
  for (const [l, p] of joints.flatMap((j, i) => [[j.a, j.at0], [j.b, D.ties[i].o || j.at0]]).concat(D.points.map((t) => [t[2], t[1]]))) { if (l === G) continue; const [u, v] = eye.flat(point(st[l], p)), d = Math.hypot(u - x, v - y); if (d < best[0]) best = [d, [l, inUnits(p)]]; }
  grabbed = best[1]; if (grabbed) playing = 0; return grabbed;
}
function pull(x, y) { // where the pointer is, in the plane of the paper
  if (!grabbed) return false;
  const c = onPaper(C); dragTo(...grabbed, [((x - eye.o[0]) / eye.k - c[0]) / L, ((eye.o[1] - y) / eye.k - c[1]) / L]); draw(false); return true;
}
const letGo = () => { grabbed = null; };
on.body = true; S.rods.push(...joints.flatMap((j) => (j.t === "prismatic" ? [[j.a, j.at0, j.b, j.at0, 0.2 * S.unit]] : []))); // what comes out of a slider
