// Space: vectors, the camera, bodies and the painter; dhcli/scene does the same, so that a page needs no server.
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const mul = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
const at = (p, d, k) => [p[0] + k * d[0], p[1] + k * d[1], p[2] + k * d[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(a[0], a[1], a[2]);
const unit = (a) => { const n = norm(a); return n > 1e-12 ? mul(a, 1 / n) : [0, 0, 0]; };
const mid = (a, b) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
const dir = (f, v) => [0, 1, 2].map((i) => f[0][i] * v[0] + f[1][i] * v[1] + f[2][i] * v[2]);
const point = (f, v) => add(dir(f, v), f[3]);

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
