// The page of a robot: joints, frames and lengths over it, live matrices, and the way it plays.
let q = D.joints.map((j) => j.q);

function turned(f, axis, c, s) {
  const [x, y, z, o] = f, m = (a, b, k, l) => add(mul(a, k), mul(b, l));
  if (axis === "x") return [x, m(y, z, c, s), m(z, y, c, -s), o];
  if (axis === "y") return [m(x, z, c, -s), y, m(z, x, c, s), o];
  return [m(x, y, c, s), m(y, x, c, -s), z, o];
}
function fold(values) {
  let f = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]]; const out = [f];
  for (const m of D.moves) {
    if (m[0] === "r") {
      let a = m[3]; for (const [j, k] of m[4]) a += k * values[j];
      let c = Math.cos(a), s = Math.sin(a); if (a === 0) { c = 1; s = 0; }
      for (let n = 0; n < m[2]; n++) [c, s] = [-s, c];
      f = turned(f, m[1], c, s);
    } else {
      const t = m[2].slice(); for (const [j, k] of m[3]) for (const i of [0, 1, 2]) t[i] += k[i] * values[j];
      const o = point(f, t); f = m[1] ? [dir(f, m[1][0]), dir(f, m[1][1]), dir(f, m[1][2]), o] : [f[0], f[1], f[2], o];
    }
    out.push(f);
  }
  return out;
}
function relative(a, b) { // the pose of frame b in frame a
  const inv = (v) => [dot(v, a[0]), dot(v, a[1]), dot(v, a[2])], c = [inv(b[0]), inv(b[1]), inv(b[2]), inv(sub(b[3], a[3]))];
  return [0, 1, 2].map((i) => c.map((k) => k[i])).concat([[0, 0, 0, 1]]);
}
const stateOf = (name) => D.frames.find((f) => f[0] === name)[1];
window.dhcli = { fk: (values, i, j) => { const s = fold(values); return relative(s[stateOf(i)], s[stateOf(j)]); }, frames: D.frames.map((f) => f[0]), rpy };

const PATH = D.path && D.path.length ? [q.slice(), ...D.path] : [], TRACE = PATH.flatMap((p, i) => { const n = PATH.length === 2 && i ? 24 : 1; return Array.from({ length: n }, (_, k) => { const s = fold(p.map((v, j) => (n > 1 ? PATH[0][j] + ((k + 1) / n) * (v - PATH[0][j]) : v))); return s[s.length - 1][3]; }); });
const states = () => fold(q), dots = (cam) => { const s = new Set(D.cloud.map((p) => cam.flat(p).map(Math.round).join(" "))); return s.size ? [{ points: [...s].map((t) => t.split(" ").map(Number)), look: "cloud", dots: true }] : []; };
const under = (P, cam) => dots(cam).concat(S.pinned.flatMap((p) => bearing(cam.flat(P.at(p[0], p[1])), Math.max(9, S.unit * cam.k))));
const lines = (cam) => (TRACE.length ? [line(TRACE.map(cam.flat), "trace")] : []), more = (P) => D.frames.flatMap(([, s]) => [0, 2].map((i) => at(P.st[s][3], P.st[s][i], 3 * S.unit))).concat(TRACE, D.cloud);
const grab = () => null, pull = () => false, letGo = () => 0;
function arc(b, cam) {
  const front = sub(cam.to, mul(b.axis, dot(cam.to, b.axis))), f = norm(front) > 0.05 ? unit(front) : unit(cross(cam.up, b.axis)), s = cross(b.axis, f), R = 1.42 * b.r;
  return Array.from({ length: 23 }, (_, i) => { const t = ((-215 + (277 * i) / 22) * Math.PI) / 180; return at(at(b.centre, f, R * Math.cos(t)), s, R * Math.sin(t)); });
}
function plate(pl, P, cam) {
  const [s, c0, n0, half, broken] = pl, c = P.at(s, c0), n = P.dir(s, n0), out = [];
  if (broken) {
    const [x, y] = cam.flat(c), [fx, fy] = cam.fd(n), L = Math.hypot(fx, fy) || 1, w = 0.75 * half * cam.k;
    return [line(Array.from({ length: 17 }, (_, i) => { const t = (i - 8) / 8, b = Math.sin(t * Math.PI) * w * 0.35; return [x - (fy / L) * t * w + (fx / L) * b, y + (fx / L) * t * w + (fy / L) * b]; }), "break")];
  }
  const u = Math.abs(n[1]) < 0.9 ? unit(cross([0, 1, 0], n)) : [1, 0, 0], v = cross(n, u), f = (a, b) => cam.flat(at(at(c, u, a * half), v, b * half));
  out.push(poly([f(-1, -1), f(1, -1), f(1, 1), f(-1, 1)], "plate"));
  for (let i = 1; i < 26; i++) { const q = -2 + (2 * i) / 13, lo = Math.max(-1, q - 1), hi = Math.min(1, q + 1); out.push(line([f(lo, q - lo), f(hi, q - hi)], "hatch")); }
  return out;
}
function arrows(P) {
  const found = [], same = (a, b, t) => norm(sub(a, b)) < t;
  for (const [name, state] of D.frames) {
    const f = P.st[state];
    for (const [i, letter] of [[0, "x"], [1, "y"], [2, "z"]]) {
      if (letter === "y" && !on.y) continue;
      const old = found.find((a) => a.letter === letter && same(a.d, f[i], 1e-7) && same(a.o, f[3], 1e-7 * S.unit)), words = [[letter, 0], [name, 1]];
      if (old) old.words.push([", ", 0], ...words); else found.push({ o: f[3], d: f[i], letter, words, len: 3 * S.unit });
    }
  }
  for (const a of found) if (a.letter === "x" && found.some((b) => b.letter !== "x" && same(a.d, b.d, 1e-7) && same(a.o, b.o, 1e-7 * S.unit))) a.len *= 0.62;
  return found;
}
function bearing([x, y], s) {
  const low = y + 1.7 * s, out = [poly([[x, y], [x + 0.95 * s, low], [x - 0.95 * s, low]], "pin-ground"), line([[x - 1.5 * s, low], [x + 1.5 * s, low]], "ground-line")];
  for (let i = 1; i < 6; i++) out.push(line([[x - 1.5 * s + i * 0.6 * s, low], [x - 2 * s + i * 0.6 * s, low + s / 2]], "hatch-line"));
  return out;
}
function above(P, cam, ink, over, wishes) {
  const axes = [];
  if (on.frames) for (const a of arrows(P).sort((a, b) => b.len - a.len || cam.depth(at(a.o, a.d, a.len)) - cam.depth(at(b.o, b.d, b.len)))) {
    const t = cam.flat(a.o), p = cam.flat(at(a.o, a.d, a.len));
    if (far(t, p) < 0.13 * a.len * cam.k) {
      axes.push(poly(ring(t, 6.5, 20), a.letter + "-ring"));
      if (dot(a.d, cam.to) > 0) axes.push(poly(ring(t, 2, 10), a.letter + "-head")); else for (const g of [1, -1]) axes.push(line([[t[0] - g * 4.2, t[1] - 4.2], [t[0] + g * 4.2, t[1] + 4.2]], a.letter));
      wishes.push({ p: [t], words: a.words, look: a.letter, away: [1, 1] }); continue;
    }
    const h = head(p, t, 10), neck = [(h[1][0] + h[2][0]) / 2, (h[1][1] + h[2][1]) / 2];
    axes.push(line([t, neck], "halo"), line([t, neck], a.letter), poly(h, a.letter + "-head"));
    wishes.push({ p: [p], words: a.words, look: a.letter, away: [p[0] - t[0], p[1] - t[1]] });
  }
  ink.add(axes);
  if (on.dimensions) for (const d of S.dims) dimension(d, P, cam, ink, over, wishes);
  if (on.turns) P.bodies.forEach((b, i) => { if (b.drum) { const a = arc(b, cam).map(cam.flat), c = cam.flat(b.centre); wishes.push({ p: [a[22], a[19], a[16], a[13]], words: S.solids[i][6], look: "turn", away: [a[19][0] - c[0], a[19][1] - c[1]] }); } });
  return axes;
}
function dimension([s1, p1, s2, p2, words, variable, direct], P, cam, ink, over, wishes) {
  const a = cam.flat(P.at(s1, p1)), b = cam.flat(P.at(s2, p2)), n = far(a, b), look = variable ? "slide" : "dim";
  if (n < 4) { wishes.push({ p: [[(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]], words, look, away: [0, 0] }); return; }
  const dx = (b[0] - a[0]) / n, dy = (b[1] - a[1]) / n; let best = [1e300];
  for (const g of [1, -1]) for (const o of [24, 31, 38, 46, 58]) { const x = -dy * g * o, y = dx * g * o, c = ink.along([a[0] + x, a[1] + y], [b[0] + x, b[1] + y]) / (n + 20) + o * 0.02; if (c < best[0] - 1e-9) best = [c, x, y]; }
  const [, x, y] = direct ? [0, -dy, dx] : best, c = [a[0] + x, a[1] + y], d = [b[0] + x, b[1] + y], k = 1 + 4 / Math.hypot(x, y);
  const out = [line([a, [a[0] + x * k, a[1] + y * k]], "extension"), line([b, [b[0] + x * k, b[1] + y * k]], "extension")];
  if (n < 22) { const e = [c[0] - dx * 14, c[1] - dy * 14], f = [d[0] + dx * 14, d[1] + dy * 14]; out.push(line([e, f], look), poly(head(c, e, 7), look + "-head"), poly(head(d, f, 7), look + "-head")); }
  else out.push(line([c, d], look), poly(head(c, d, 8), look + "-head"), poly(head(d, c, 8), look + "-head"));
  ink.add(out); over.push(...out);
  wishes.push({ p: [0.5, 0.38, 0.62].map((t) => [c[0] + (d[0] - c[0]) * t, c[1] + (d[1] - c[1]) * t]), words, look, away: [x, y] });
}
function rpy(R) {
  const h = Math.hypot(R[0][0], R[1][0]), pitch = Math.atan2(-R[2][0], h);
  return h < 1e-9 ? [0, pitch, Math.atan2(-R[0][1], R[1][1]), true] : [Math.atan2(R[2][1], R[2][2]), pitch, Math.atan2(R[1][0], R[0][0]), false];
}
const fix = (v) => { const t = v.toFixed(4); return (t === "-0.0000" ? "0.0000" : t).replace("-", "−"); };
const deg = (v) => { const t = ((v * 180) / Math.PI).toFixed(2); return (t === "-0.00" ? "0.00" : t).replace("-", "−") + "°"; };
function told(P) {
  $("seen").textContent = `azimuth ${view[0].toFixed(0)}°, elevation ${view[1].toFixed(0)}°`;
  const i = $("from").value, j = $("to").value, T = relative(P.st[stateOf(i)], P.st[stateOf(j)]), n = D.frames.findIndex((f) => f[0] === i), [r, p, y, locked] = rpy(T);
  $("matrix").innerHTML = T.map((row, k) => "<tr>" + row.map((v) => `<td>${k < 3 ? fix(v) : v}</td>`).join("") + "</tr>").join("");
  $("isA").textContent = D.frames[n + 1] && D.frames[n + 1][0] === j && /^\d+$/.test(j) ? `= A${j}` : "";
  $("place").textContent = `position ${fix(T[0][3])}, ${fix(T[1][3])}, ${fix(T[2][3])} m · roll ${deg(r)}, pitch ${deg(p)}, yaw ${deg(y)}` + (locked ? " (pitch ±90°: only one of roll and yaw can be told; roll is 0)" : "");
  D.table.rows.forEach((row, k) => row.forEach((c, m) => { if ("v" in c) { let v = c.v; for (const [jj, f] of c.j) v += f * q[jj]; const e = $(`c${k}-${m}`); if (e) e.textContent = c.angle ? deg(v) : fix(v); } }));
}
const shown = (j, v) => (D.joints[j].kind === "revolute" ? (v * 180) / Math.PI : v * 1000);
const typed = (j, v) => (D.joints[j].kind === "revolute" ? (v * Math.PI) / 180 : v / 1000);
function setJoint(j, v, from) {
  q[j] = v; const s = shown(j, v), { lo, hi } = D.joints[j], r = $("s" + j), f = $("f" + j);
  if (from !== r) r.value = s; if (from !== f) f.value = +s.toFixed(3);
  const beyond = v < lo - 1e-9 || v > hi + 1e-9;
  f.classList.toggle("beyond", beyond); f.setAttribute("aria-invalid", beyond); $("b" + j).textContent = beyond ? "beyond its limit" : "";
}
function build() {
  $("joints").innerHTML = D.joints.map((j, n) => { const lo = shown(n, j.lo ?? j.from), hi = shown(n, j.hi ?? j.till), u = j.kind === "revolute" ? "°" : "mm"; return `<label for="s${n}">${htmlOf(j.words)}</label><input type="range" id="s${n}" min="${lo}" max="${hi}" step="any" aria-label="${esc(j.name)}"><span><input type="number" id="f${n}" step="1" aria-label="${esc(j.name)} in ${u}"> ${u}</span><small id="b${n}"></small>`; }).join("");
  D.joints.forEach((_, n) => { for (const id of ["s", "f"]) { const e = $(id + n); e.addEventListener("input", () => { const v = parseFloat(e.value); if (Number.isFinite(v)) { setJoint(n, typed(n, v), e); draw(false); } }); e.addEventListener("change", () => { setJoint(n, q[n]); draw(true); }); } setJoint(n, q[n]); });
  for (const [name, values] of D.poses) { const b = document.createElement("button"); b.textContent = name; b.onclick = () => { values.forEach((v, n) => setJoint(n, v)); draw(true); }; $("poses").append(b); }
  for (const id of ["frames", "dimensions", "y", "body", "turns"]) { const e = $("on-" + id); on[id] = e.checked; e.onchange = () => { on[id] = e.checked; draw(false); }; }
  if (PATH.length > 1) { // there and back again, evenly from row to row
    const b = document.createElement("button"), ticks = Math.max(120, 2 * PATH.length - 2); let k = 0, way = 0; b.id = "play"; b.textContent = "play"; $("poses").append(b);
    const tick = () => { if (!way) return; k += way; if (k === 0 || k === ticks) way = -way; const t = (k / ticks) * (PATH.length - 1), i = Math.min(Math.floor(t), PATH.length - 2), p = PATH[i]; PATH[i + 1].forEach((v, n) => setJoint(n, t - i === 1 ? v : p[n] + (t - i) * (v - p[n]))); draw(false); requestAnimationFrame(tick); };
    b.onclick = () => { way = way ? 0 : k === ticks ? -1 : 1; tick(); };
  }
  for (const id of ["from", "to"]) { $(id).innerHTML = D.frames.map((f) => `<option>${esc(f[0])}</option>`).join(""); $(id).onchange = () => draw(false); }
  const plain = D.frames.filter((f) => /^\d+$/.test(f[0])); $("from").value = plain[0][0]; $("to").value = plain[plain.length - 1][0];
  $("table").innerHTML = "<thead><tr>" + D.table.heads.map((h) => `<th>${htmlOf(h)}</th>`).join("") + "</tr></thead><tbody>" + D.table.rows.map((r, k) => "<tr>" + r.map((c, m) => `<td>${htmlOf(c.words)}${"v" in c ? `<small id="c${k}-${m}"></small>` : ""}</td>`).join("") + "</tr>").join("") + "</tbody>";
}
build(); draw(true);
