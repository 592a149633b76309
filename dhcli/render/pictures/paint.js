// Vectors, the camera, bodies, the painter and the label placer: what dhcli/scene does, so that a page needs no server.
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const mul = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
const at = (p, d, k) => [p[0] + k * d[0], p[1] + k * d[1], p[2] + k * d[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(a[0], a[1], a[2]);
const unit = (a) => { const n = norm(a); return n > 1e-12 ? mul(a, 1 / n) : [0, 0, 0]; };
const mid = (a, b) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
const far = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
const dir = (f, v) => [0, 1, 2].map((i) => f[0][i] * v[0] + f[1][i] * v[1] + f[2][i] * v[2]);
const point = (f, v) => add(dir(f, v), f[3]);
const esc = (s) => String(s).replace(/[&<>"']/g, (c) => "&#" + c.charCodeAt(0) + ";");

function camera(az, el) {
  const c = (d) => (d % 90 ? Math.cos((d * Math.PI) / 180) : [1, 0, -1, 0][(((d / 90) % 4) + 4) % 4]);
  const ca = c(az), sa = c(az - 90), ce = c(el), se = c(el - 90);
  const cam = { az, el, right: [-sa, ca, 0], up: [-se * ca, -se * sa, ce], to: [ce * ca, ce * sa, se], k: 1, o: [0, 0] };
  cam.fd = (v) => [dot(v, cam.right), -dot(v, cam.up)];
  cam.flat = (p) => [cam.o[0] + cam.k * dot(p, cam.right), cam.o[1] - cam.k * dot(p, cam.up)];
  cam.depth = (p) => dot(p, cam.to);
  return cam;
}
function fit(cam, points, room, most) {
  const f = points.map(cam.fd), xs = f.map((p) => p[0]), ys = f.map((p) => p[1]);
  const l = Math.min(...xs), r = Math.max(...xs), t = Math.min(...ys), b = Math.max(...ys);
  cam.k = Math.min((room[2] - room[0]) / Math.max(r - l, 1e-300), (room[3] - room[1]) / Math.max(b - t, 1e-300), most);
  cam.o = [(room[0] + room[2]) / 2 - (cam.k * (l + r)) / 2, (room[1] + room[3]) / 2 - (cam.k * (t + b)) / 2];
}
function between(low, high, h, climb, half) {
  if (Math.abs(climb) > 1e-9) {
    const a = (-half - h) / climb, b = (half - h) / climb;
    low = Math.max(low, Math.min(a, b)); high = Math.min(high, Math.max(a, b));
  } else if (Math.abs(h) > half) return null;
  return low < high ? [low, high] : null;
}
const level = (a) => { const f = cross([0, 0, 1], a); return norm(f) > 1e-6 ? unit(f) : [1, 0, 0]; };
function turn(a, b, c) { return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]); }
function hull(points) {
  const p = points.slice().sort((a, b) => a[0] - b[0] || a[1] - b[1]), half = (row) => {
    const h = [];
    for (const q of row) { while (h.length > 1 && turn(h[h.length - 2], h[h.length - 1], q) <= 0) h.pop(); h.push(q); }
    h.pop(); return h;
  };
  return half(p).concat(half(p.slice().reverse()));
}
const ring = (c, r, n) => Array.from({ length: n }, (_, i) => [c[0] + r * Math.cos((2 * Math.PI * i) / n), c[1] + r * Math.sin((2 * Math.PI * i) / n)]);
const poly = (points, look, shade) => ({ points, look, closed: true, shade });
const line = (points, look) => ({ points, look });
function head(tip, tail, size) {
  let dx = tip[0] - tail[0], dy = tip[1] - tail[1]; const n = Math.hypot(dx, dy) || 1; dx /= n; dy /= n;
  const b = [tip[0] - size * dx, tip[1] - size * dy], h = 0.36 * size;
  return [tip, [b[0] - h * dy, b[1] + h * dx], [b[0] + h * dy, b[1] - h * dx]];
}

function drum(c, a, r, h) {
  const u = level(a), v = cross(a, u), N = 32;
  const rim = (e) => { const m = at(c, a, e * h); return Array.from({ length: N }, (_, i) => at(at(m, u, r * Math.cos((2 * Math.PI * i) / N)), v, r * Math.sin((2 * Math.PI * i) / N))); };
  return {
    centre: c, axis: a, r, drum: true,
    span(p, to) {
      const rel = sub(p, c), H = dot(rel, a), C = dot(to, a), q = sub(rel, mul(a, H)), d = sub(to, mul(a, C));
      const A = dot(d, d), B = dot(q, d), K = dot(q, q) - r * r * 0.98; let lo = -1e300, hi = 1e300;
      if (A > 1e-9) { const s = B * B - A * K; if (s <= 0) return null; lo = (-B - Math.sqrt(s)) / A; hi = (-B + Math.sqrt(s)) / A; } else if (K > 0) return null;
      return between(lo, hi, H, C, h);
    },
    samples() { const s = [...rim(1), ...rim(-1)].filter((_, i) => i % 4 === 0); return s.concat(s.slice(0, 8).map((p) => at(p, a, -h))); },
    shapes(cam) {
      const n = dot(a, cam.to) >= 0 ? 1 : -1, f = rim(n).map(cam.flat), [x, y] = cam.fd(a), seen = Math.hypot(x, y);
      if (seen < 1e-6) return [poly(f, "cap")];
      const [cx, cy] = cam.flat(c), w = r * cam.k; let sx = (-y / seen) * w, sy = (x / seen) * w;
      if (sx < 0 || (sx === 0 && sy < 0)) { sx = -sx; sy = -sy; }
      return [poly(hull(f.concat(rim(-n).map(cam.flat))), "drum", [cx - sx, cy - sy, cx + sx, cy + sy]), poly(f, "cap")];
    },
  };
}
function box(c, a, h) {
  const s = level(a), axes = [a, s, cross(a, s)], halves = [h, h * 0.8, h * 0.8];
  const corner = (g) => axes.reduce((p, x, i) => at(p, x, g[i] * halves[i]), c);
  return {
    centre: c,
    span(p, to) {
      const rel = sub(p, c); let cut = [-1e300, 1e300];
      for (let i = 0; i < 3 && cut; i++) cut = between(cut[0], cut[1], dot(rel, axes[i]), dot(to, axes[i]), halves[i] * 0.98);
      return cut;
    },
    samples: () => [0, 1, 2, 3, 4, 5, 6, 7].map((b) => corner([b & 1 ? 1 : -1, b & 2 ? 1 : -1, b & 4 ? 1 : -1])).concat(axes.flatMap((x, i) => [at(c, x, halves[i]), at(c, x, -halves[i])])),
    shapes(cam) {
      return axes.flatMap((x, n) => {
        const f = dot(x, cam.to); if (Math.abs(f) < 1e-9) return [];
        const g = f > 0 ? 1 : -1, pts = [[-1, -1], [-1, 1], [1, 1], [1, -1]].map((ij) => { const q = ij.slice(); q.splice(n, 0, g); return cam.flat(corner(q)); });
        const l = dot(mul(x, g), cam.up);
        return [poly(pts, l > 0.5 ? "face-light" : l > -0.2 ? "face" : "face-dark")];
      });
    },
  };
}
function ball(c, r) {
  return {
    centre: c,
    span(p, to) { const q = sub(p, c), b = dot(q, to), s = b * b - dot(q, q) + r * r * 0.98; return s > 0 ? [-b - Math.sqrt(s), -b + Math.sqrt(s)] : null; },
    samples: () => [0, 1, 2].flatMap((i) => [1, -1].map((g) => at(c, [0, 1, 2].map((j) => +(i === j)), g * r))),
    shapes(cam) { const [x, y] = cam.flat(c), k = r * cam.k; return [poly(ring([x, y], k, 24), "ball", [x - k, y - k, x + k, y + k])]; },
  };
}
function sheet(pts, look) {
  const c = mul(pts.reduce(add), 1 / pts.length), n = unit(cross(sub(pts[1], pts[0]), sub(pts[2], pts[0])));
  return {
    centre: c,
    span(p, to) {
      const s = dot(to, n); if (Math.abs(s) < 1e-6) return null;
      const t = dot(sub(pts[0], p), n) / s, hit = at(p, to, t);
      const signs = new Set(pts.map((q, i) => dot(cross(sub(pts[(i + 1) % pts.length], q), sub(hit, q)), n) >= 0));
      return signs.size === 1 ? [t, t] : null;
    },
    samples: () => pts.map((p) => add(mul(p, 0.8), mul(c, 0.2))).concat([c]),
    shapes: (cam) => [poly(pts.map(cam.flat), look)],
  };
}
function ordered(bodies, cam) {
  const behind = (a, b) => {
    let v = 0;
    for (const [p, q, g] of [[a, b, 1], [b, a, -1]]) for (const s of p.samples()) { const k = q.span(s, cam.to); if (k) v += k[0] + k[1] > 0 ? g : -g; }
    return v > 0;
  };
  const before = bodies.map((a) => bodies.map((b) => a !== b && behind(a, b))), left = new Set(bodies.keys()), out = [];
  while (left.size) {
    let free = [...left].filter((i) => ![...left].some((j) => j !== i && before[j][i])); if (!free.length) free = [...left];
    const f = free.reduce((m, i) => (cam.depth(bodies[i].centre) < cam.depth(bodies[m].centre) ? i : m));
    left.delete(f); out.push(bodies[f]);
  }
  return out;
}
function arc(b, cam) {
  const front = sub(cam.to, mul(b.axis, dot(cam.to, b.axis))), f = norm(front) > 0.05 ? unit(front) : unit(cross(cam.up, b.axis)), s = cross(b.axis, f), R = 1.42 * b.r;
  return Array.from({ length: 23 }, (_, i) => { const t = ((-215 + (277 * i) / 22) * Math.PI) / 180; return at(at(b.centre, f, R * Math.cos(t)), s, R * Math.sin(t)); });
}
function painted(S, P, cam, on) {
  const bodies = on.body ? P.bodies : [], pieces = [];
  const inside = (p) => bodies.some((b) => { const k = b.span(p, cam.to); return k && k[0] < 0 && k[1] > 0; });
  if (on.body) {
    S.rods.forEach((rod, n) => {
      const a = P.at(rod[0], rod[1]), b = P.at(rod[2], rod[3]), L = norm(sub(b, a)); if (!L) return;
      const w = Math.max(2 * rod[4] * cam.k, 3), d = unit(sub(b, a)), look = rod[5] ? "ground-link" : "link"; let parts = [[0, L]];
      for (const q of bodies) { const k = q.span(a, d); if (k && k[0] !== k[1]) parts = parts.flatMap(([l, h]) => [[l, Math.min(h, k[0])], [Math.max(l, k[1]), h]].filter((x) => x[1] - x[0] > 1e-9 * L)); }
      for (const [l, h] of parts) {
        const c = Math.max(1, Math.min(80, Math.ceil((h - l) / (0.4 * S.unit))));
        for (let i = 0; i < c; i++) { const p = at(a, d, l + ((h - l) * i) / c), q = at(a, d, l + ((h - l) * (i + 1)) / c); pieces.push({ m: mid(p, q), l: [cam.flat(p), cam.flat(q)], look, id: n, w }); }
      }
      for (const p of [a, b]) if (!inside(p)) pieces.push({ m: at(p, cam.to, -0.02 * S.unit), l: [cam.flat(p)], look, id: n, w });
    });
    if (S.hand) {
      const h = S.hand, o = P.at(h[0], h[1]), f = mul(P.dir(h[0], h[2]), h[4]), x = mul(P.dir(h[0], h[3]), h[4]), palm = at(o, f, 0.3), sides = [at(palm, x, -0.38), at(palm, x, 0.38)];
      for (const [p, q] of [[o, palm], sides, [sides[0], at(sides[0], f, 0.7)], [sides[1], at(sides[1], f, 0.7)]]) pieces.push({ m: mid(p, q), l: [cam.flat(p), cam.flat(q)], look: "hand", id: -1e3, w: 0 });
    }
  }
  if (on.turns) P.bodies.forEach((b, n) => {
    if (!b.drum) return;
    const a = arc(b, cam);
    for (let i = 0; i + 1 < a.length; i++) pieces.push({ m: mid(a[i], a[i + 1]), l: [cam.flat(a[i]), cam.flat(a[i + 1])], look: "turn", id: -1 - n, w: 0 });
    pieces.push({ m: a[22], l: head(cam.flat(a[22]), cam.flat(a[20]), 9), look: "turn-head", id: -1 - n, w: 0 });
  });
  const order = ordered(bodies, cam), slots = Array.from({ length: order.length + 1 }, () => []);
  for (const p of pieces) {
    let lo = 0, hi = order.length;
    order.forEach((b, n) => { const k = b.span(p.m, cam.to); if (k) { if (k[0] + k[1] > 0) hi = Math.min(hi, n); else lo = Math.max(lo, n + 1); } });
    let s = lo; if (lo < hi) { s = hi; const d = cam.depth(p.m); for (let n = lo; n < hi; n++) if (cam.depth(order[n].centre) > d) { s = n; break; } }
    slots[s].push(p);
  }
  const out = [];
  slots.forEach((slot, n) => {
    slot.sort((a, b) => cam.depth(a.m) - cam.depth(b.m));
    let run = [], last = null;
    const flush = () => { if (last) drawPiece(last, run, out); };
    for (const p of slot) {
      if (last && p.id === last.id && p.look === last.look && p.l.length === 2 && run.length > 1 && p.look !== "hand") {
        if (far(run[run.length - 1], p.l[0]) < 0.01) { run.push(p.l[1]); continue; }
        if (far(run[0], p.l[1]) < 0.01) { run.unshift(p.l[0]); continue; }
      }
      flush(); run = p.l.slice(); last = p;
    }
    flush();
    if (n < order.length) out.push(...order[n].shapes(cam));
  });
  const g = on.body && S.plate ? plate(S.plate, P, cam) : [];
  return cam.el < 0 && S.plate && !S.plate[4] ? out.concat(g) : g.concat(out);
}
function drawPiece(p, run, out) {
  if (run.length === 1) return out.push(poly(ring(run[0], p.w / 2, 16), "knob"));
  if (!p.w) return out.push({ points: run, look: p.look, closed: p.look.endsWith("head") });
  const a = run[0], b = run[run.length - 1], n = far(a, b); if (n < 1e-9) return 0;
  const ux = (b[0] - a[0]) / n, uy = (b[1] - a[1]) / n, w = p.w / 2, q = (c, g, e) => [c[0] - g * uy * w + e * 0.4 * ux, c[1] + g * ux * w + e * 0.4 * uy];
  const c = [q(a, 1, -1), q(b, 1, 1), q(b, -1, 1), q(a, -1, -1)];
  return out.push(poly(c, p.look), line([c[0], c[1]], "edge"), line([c[3], c[2]], "edge"));
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

const LIGHT = new Set(["plate", "hatch", "halo", "ground-sheet"]);
function Ink(W, H) {
  const C = Math.ceil(W / 4) + 1, R = Math.ceil(H / 4) + 1, cells = new Uint8Array(C * R); let sums = null;
  const amount = (l, t, r, b) => {
    if (!sums) { sums = new Int32Array((C + 1) * (R + 1)); for (let j = 0; j < R; j++) { let s = 0; for (let i = 0; i < C; i++) { s += cells[j * C + i]; sums[(j + 1) * (C + 1) + i + 1] = s + sums[j * (C + 1) + i + 1]; } } }
    const i = Math.max(0, Math.trunc(l / 4)), j = Math.max(0, Math.trunc(t / 4)), k = Math.min(C, Math.trunc(r / 4) + 1), m = Math.min(R, Math.trunc(b / 4) + 1), w = C + 1;
    return i >= k || j >= m ? 0 : sums[m * w + k] - sums[j * w + k] - sums[m * w + i] + sums[j * w + i];
  };
  return {
    amount,
    add(shapes) {
      sums = null;
      for (const s of shapes) {
        if (LIGHT.has(s.look)) continue;
        if (s.closed) area(s.points);
        if (s.look === "link" || s.look === "ground-link") continue;
        const p = s.closed ? s.points.concat([s.points[0]]) : s.points;
        for (let n = 0; n + 1 < p.length; n++) {
          const a = p[n], b = p[n + 1], k = Math.max(1, Math.min(4000, Math.trunc(far(a, b) / 2.4) + 1));
          for (let q = 0; q <= k; q++) { const i = Math.floor((a[0] + ((b[0] - a[0]) * q) / k) / 4), j = Math.floor((a[1] + ((b[1] - a[1]) * q) / k) / 4); if (i >= 0 && i < C && j >= 0 && j < R) cells[j * C + i] = 6; }
        }
      }
    },
    along(a, b) { const k = Math.max(2, Math.trunc(far(a, b) / 6)); let t = 0; for (let n = 0; n <= k; n++) { const x = a[0] + ((b[0] - a[0]) * n) / k, y = a[1] + ((b[1] - a[1]) * n) / k; t += amount(x - 5, y - 5, x + 5, y + 5); } return t; },
  };
  function area(p) {
    const ys = p.map((q) => q[1]), t = Math.max(0, Math.trunc(Math.min(...ys) / 4)), b = Math.min(R, Math.trunc(Math.max(...ys) / 4) + 1);
    for (let j = t; j < b; j++) {
      const y = (j + 0.5) * 4, cuts = [];
      p.forEach((a, i) => { const c = p[(i + 1) % p.length]; if (a[1] <= y !== c[1] <= y) cuts.push(a[0] + ((y - a[1]) * (c[0] - a[0])) / (c[1] - a[1])); });
      cuts.sort((a, c) => a - c);
      for (let i = 0; i + 1 < cuts.length; i += 2) for (let x = Math.max(0, Math.round(cuts[i] / 4)); x < Math.min(C, Math.round(cuts[i + 1] / 4)); x++) if (!cells[j * C + x]) cells[j * C + x] = 1;
    }
  }
}
const DIRS = Array.from({ length: 16 }, (_, i) => [Math.cos((i * Math.PI) / 8), Math.sin((i * Math.PI) / 8)]);
const RINGS = [[2, 7, 14, 23, 34, 48], [66, 90, 120, 160, 210, 270, 340, 420, 520, 640]], SIZE = 17;
const boxOf = (words) => [words.reduce((n, r) => n + r[0].length * (r[1] ? 0.72 : 1), 0) * 0.66 * SIZE + 2, 1.42 * SIZE];
const meets = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
function cuts(r, a, b) {
  let lo = 0, hi = 1;
  for (const i of [0, 1]) {
    const w = b[i] - a[i];
    if (Math.abs(w) < 1e-9) { if (!(r[i] < a[i] && a[i] < r[i + 2])) return false; continue; }
    const p = (r[i] - a[i]) / w, q = (r[i + 2] - a[i]) / w; lo = Math.max(lo, Math.min(p, q)); hi = Math.min(hi, Math.max(p, q));
  }
  return lo < hi;
}
const clampTo = (p, r, e, g) => [Math.min(Math.max(p[0], r[0] + e), r[2] - e), Math.min(Math.max(p[1], r[1] + g), r[3] - g)];
function placed(wishes, ink, room) {
  const taken = [], leaders = [], texts = [];
  const crowd = (w) => wishes.filter((o) => far(o.p[0], w.p[0]) < 50).length * 100 + ink.amount(w.p[0][0] - 30, w.p[0][1] - 30, w.p[0][0] + 30, w.p[0][1] + 30) / 10 - 40 * w.p.length;
  for (const w of wishes.map((w, i) => [crowd(w), i, w]).sort((a, b) => b[0] - a[0] || a[1] - b[1]).map((x) => x[2])) {
    const [bw, bh] = boxOf(w.words), want = Math.hypot(...w.away); let best = null;
    for (const rings of RINGS) {
      w.p.forEach((p, n) => { for (const g of rings) for (const [dx, dy] of DIRS) {
        const k = g + Math.min(bw / 2 / Math.max(Math.abs(dx), 1e-9), (bh * 0.4) / Math.max(Math.abs(dy), 1e-9)), x = p[0] + dx * k, y = p[1] + dy * k, r = [x - bw / 2, y - bh / 2, x + bw / 2, y + bh / 2];
        if (r[0] < room[0] || r[1] < room[1] || r[2] > room[2] || r[3] > room[3]) continue;
        let c = 0.16 * g + 0.01 * n + (want > 1e-9 ? 2.2 * (1 - (dx * w.away[0] + dy * w.away[1]) / want) : 0);
        if ((best && c >= best[0]) || taken.some((o) => meets(r, o))) continue;
        const e = clampTo(p, r, 0, 0);
        c += (10 * ink.amount(r[0] + 2, r[1] + 4, r[2] - 2, r[3] - 4)) / 6 / Math.sqrt(Math.max((bw * bh) / 16, 1)) + 6 * leaders.filter((l) => cuts(r, l[0], l[1])).length + 6 * taken.filter((o) => cuts(o, p, e)).length;
        if (!best || c < best[0] - 1e-9) best = [c, r, p];
      } });
      if (best) break;
    }
    if (!best) continue;
    const [, r, p] = best; taken.push(r);
    texts.push({ at: [(r[0] + r[2]) / 2, (r[1] + r[3]) / 2 + 0.26 * SIZE], words: w.words, look: w.look });
    const e = clampTo(p, r, 1, 4); if (far(e, p) > 10) leaders.push([p, e]);
  }
  return [leaders.map((l) => line(l, "leader")), texts];
}
const f1 = (v) => { const t = v.toFixed(1).replace(/\.0$/, ""); return t === "-0" ? "0" : t; };
const path = (s) => "M" + s.points.map((p) => f1(p[0]) + " " + f1(p[1])).join("L") + (s.closed ? "Z" : "");
const spans = (words, size) => { let low = false; return words.map(([t, below]) => { const d = f1(0.24 * size), o = below ? `<tspan dy="${d}" font-size="${f1(0.7 * size)}">${esc(t)}</tspan>` : low ? `<tspan dy="-${d}">${esc(t)}</tspan>` : esc(t); low = below; return o; }).join(""); };
const htmlOf = (words) => words.map(([t, below]) => (below ? `<sub>${esc(t)}</sub>` : `<i>${esc(t)}</i>`)).join("");
function svgOf(shapes, texts) {
  let defs = "", n = 0, body = "";
  for (const s of shapes) {
    let fill = "";
    if (s.shade) { const [a, b, c, d] = s.shade.map(f1); defs += `<linearGradient id="g${n}" gradientUnits="userSpaceOnUse" x1="${a}" y1="${b}" x2="${c}" y2="${d}"><stop class="s-shadow" offset="0"/><stop class="s-shine" offset=".42"/><stop class="s-metal" offset="1"/></linearGradient>`; fill = ` fill="url(#g${n++})"`; }
    body += `<path class="${s.look}"${fill} d="${path(s)}"/>`;
  }
  for (const t of texts) { const w = spans(t.words, SIZE), a = `x="${f1(t.at[0])}" y="${f1(t.at[1])}" font-size="${SIZE}"`; body += `<text class="halo-text" aria-hidden="true" ${a}>${w}</text><text class="t-${t.look}" ${a}>${w}</text>`; }
  return `<defs>${defs}</defs>${body}`;
}
const $ = (id) => document.getElementById(id);
function savePng(svg, name) {
  const css = getComputedStyle(document.documentElement), text = new XMLSerializer().serializeToString(svg), sheetText = $("looks").textContent.replace(/var\((--[\w-]+)\)/g, (_, v) => css.getPropertyValue(v).trim());
  const [, , w, h] = svg.getAttribute("viewBox").split(" ").map(Number), img = new Image();
  img.onload = () => { const c = document.createElement("canvas"); c.width = 2 * w; c.height = 2 * h; const g = c.getContext("2d"); g.fillStyle = css.getPropertyValue("--paper").trim(); g.fillRect(0, 0, c.width, c.height); g.drawImage(img, 0, 0, c.width, c.height); const a = document.createElement("a"); a.download = name + ".png"; a.href = c.toDataURL(); a.click(); };
  img.src = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(text.replace(/^<svg[^>]*>/, (t) => `<svg xmlns="http://www.w3.org/2000/svg" width="${2 * w}" height="${2 * h}" viewBox="0 0 ${w} ${h}"><style>${sheetText}</style>`));
}
