// Motion of a linkage: Newton back onto what its joints demand, along the freedom that they leave; in the plane and in space.
// A page brings n, demands(x), applied(x, d), jumpOf(y, x), drivers, spotOf(point), seenAt(link, point).
const dotn = (a, b) => { let s = 0; for (let i = 0; i < a.length; i++) s += a[i] * b[i]; return s; };
const most = (v) => v.reduce((m, c) => Math.max(m, Math.abs(c)), 0);
function local(x, rank) { // what is demanded here, how to fulfil it, what is left free: by a pivoted Cholesky factor of J J'
  const [R, J] = demands(x), size = J.map((r) => Math.sqrt(dotn(r, r)) || 1), A = J.map((r, i) => r.map((v) => v / size[i])), m = A.length;
  const order = A.map((_, i) => i), left = A.map((r) => dotn(r, r)), F = [];
  for (let k = 0; k < Math.min(m, rank); k++) {
    let p = k; for (let i = k + 1; i < m; i++) if (left[order[i]] > left[order[p]]) p = i;
    [order[k], order[p]] = [order[p], order[k]]; const a = order[k]; if (!(left[a] > 1e-11)) break;
    const f = new Float64Array(m), root = Math.sqrt(left[a]); f[a] = root;
    for (let i = k + 1; i < m; i++) { const b = order[i]; let s = dotn(A[a], A[b]); for (const g of F) s -= g[a] * g[b]; f[b] = s / root; left[b] -= f[b] * f[b]; }
    F.push(f);
  }
  const r = F.length, solve = (rhs) => { // the shortest displacement that changes the chosen rows so
    const y = new Array(r), d = new Array(n).fill(0);
    for (let k = 0; k < r; k++) { let s = rhs(order[k]); for (let j = 0; j < k; j++) s -= F[j][order[k]] * y[j]; y[k] = s / F[k][order[k]]; }
    for (let k = r - 1; k >= 0; k--) { let s = y[k]; for (let j = k + 1; j < r; j++) s -= F[k][order[j]] * y[j]; y[k] = s / F[k][order[k]]; }
    for (let k = 0; k < r; k++) { const row = A[order[k]]; for (let i = 0; i < n; i++) d[i] += y[k] * row[i]; }
    return d;
  };
  return {
    R, rank: r, thin: r ? F[r - 1][order[r - 1]] : 1,
    back: () => solve((i) => R[i] / size[i]),
    free: (w) => { const d = solve((i) => dotn(A[i], w)); return w.map((v, i) => v - d[i]); },
  };
}
let X = home(), trail = [], last = null, playing = 0, note = "";
const RANK = local(X, Infinity).rank, F = n - RANK, SHORT = 0.02, THIN = 0.003, DEAD = "further it cannot go: a dead position", RIGID = "it is rigid: nothing can move";

function settle(x) { // Newton back onto what the joints demand; null if it does not come home
  let y = x;
  for (let k = 0; k < 14; k++) {
    const here = local(y, RANK), worst = most(here.R);
    if (!Number.isFinite(worst)) return null;
    if (worst < 2e-15 || (k > 6 && worst < 1e-13)) return y;
    const d = here.back(); y = applied(y, d.map((v) => -v));
    if (most(d) < 1e-15) break;
  }
  return most(demands(y)[0]) < 1e-11 ? y : null;
}
function take(y) { X = y; for (const d of drivers) d.value = d.read(X); track(); }
function track() { // what the point to be traced has come by, step for step
  const t = D.points[$("trace").value]; if (!t) return;
  const p = spotOf(t); if (last && Math.hypot(...p.map((v, i) => v - last[i])) < 0.002 * D.size) return;
  trail.push(p); last = p; if (trail.length > 4000) trail.shift();
}
function step(want) { // move along the freedom towards a wanted displacement of all links, a short way; false at a dead position
  const d = local(X, RANK).free(want), size = most(d); if (size < 1e-12) return false;
  for (let h = SHORT; h > 1e-4; h /= 2) {
    const k = Math.min(1, h / size), go = d.map((v) => v * k), y = settle(applied(X, go)); if (!y) continue;
    const jump = jumpOf(y, X), long = Math.hypot(...jump); if (long > 3 * Math.hypot(...go) + 1e-12) continue;
    const after = local(y, RANK); if (RANK && (after.rank < RANK || after.thin < THIN)) { const over = leap(go); if (over) { take(over); return true; } return false; }
    const kept = after.free(jump); if (long > 1e-9 && dotn(kept, kept) < 0.9 * long * long) continue; // another branch
    take(y); return true;
  }
  return false;
}
function leap(go) { // past a position where branches meet, straight on, to the first sound one beyond
  const g = Math.hypot(...go);
  for (let k = 2; k < 12; k++) {
    const y = settle(applied(X, go.map((v) => v * k))); if (!y) return null;
    const jump = jumpOf(y, X), long = Math.hypot(...jump), after = local(y, RANK);
    if (dotn(jump, go) < 0.985 * long * g || long > 1.5 * k * g) return null;
    if (after.rank === RANK && after.thin >= THIN) { const kept = after.free(jump); return dotn(kept, kept) > 0.97 * long * long ? y : null; }
  }
  return null;
}
function dragTo(l, p, to) { // bring a point of a link, as it is seen, to where it is wanted, as far as that goes
  note = F ? "" : RIGID;
  for (let k = 0; k < 60 && F; k++) {
    const { at: u, rows } = seenAt(l, p), d = [to[0] - u[0], to[1] - u[1]], before = Math.hypot(...d); if (before < 1e-6) break;
    const here = local(X, RANK), [f, g] = rows.map(here.free), a = dotn(f, f) + 1e-9, b = dotn(f, g), c = dotn(g, g) + 1e-9, e = a * c - b * b;
    const s = (c * d[0] - b * d[1]) / e, t = (a * d[1] - b * d[0]) / e, want = f.map((v, i) => s * v + t * g[i]); if (most(want) < 1e-6) break;
    const kept = X; if (!step(want)) { note = DEAD; break; }
    if (far(seenAt(l, p).at, to) > before - 1e-9) { take(kept); break; }
  }
}
let driver = drivers[0];
function driveTo(value) { // turn or slide to a value; where it cannot, as far as it goes
  note = F ? "" : RIGID;
  for (let k = 0; k < 2000 && F; k++) {
    const left = value - driver.read(X); if (Math.abs(left) < 1e-11) return;
    const free = local(X, RANK).free(driver.row(X)), s = dotn(free, driver.row(X));
    if (s < 1e-7) { note = DEAD; return; }
    const kept = X, was = Math.abs(left); if (!step(free.map((v) => (v * left) / s))) { note = DEAD; return; }
    if (Math.abs(value - driver.read(X)) > was - 1e-15 && was > 1e-9) { take(kept); note = DEAD; return; }
  }
}
function homed() { X = home(); trail = []; last = null; note = ""; playing = 0; for (const d of drivers) d.value = 0; }
const pointOf = (name) => D.points.find((q) => q[0].map((r) => r[0]).join("") === name);
window.dhcli = {
  drive: (name, v) => { driver = drivers.find((d) => d.name === name) || driver; driveTo(v); draw(); return driver.read(X); },
  drag: (name, to) => { const p = pointOf(name), goal = inUnits(to); dragTo(p[2], inUnits(p[1]), goal.length > 2 ? onPaper(goal) : goal); draw(); },
  at: (name) => spotOf(pointOf(name)), gap: () => most(demands(X)[0]) * D.size, freedom: F, home: () => { homed(); draw(); },
  state: () => jumpOf(X, home()), note: () => note, drivers: drivers.map((d) => d.name),
};
