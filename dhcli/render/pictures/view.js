// A scene in space on a page: what holds for arms and linkages alike, and orbit by mouse, touch and keys.
// A page says: states(), the frames of the scene; under and lines, what lies under it and on it; above, what lies over it;
// more, points that must be seen; told, what stands beside; grab, pull and letGo, a hand that moves something else.
const S = D.scene, on = {};
let view = D.view.slice(), zoom = 1, scale = null;
function placedScene() {
  const st = states(), P = { st, at: (s, p) => point(st[s], p), dir: (s, v) => dir(st[s], v) };
  P.bodies = S.solids.map((b) => (b[0] === "face" ? sheet(b[1].map((c) => P.at(c[0], c[1])), b[2] ? "ground-sheet" : "sheet") : b[0] === "drum" ? drum(P.at(b[1], b[2]), unit(P.dir(b[1], b[3])), b[4], b[5]) : b[0] === "box" ? box(P.at(b[1], b[2]), unit(P.dir(b[1], b[3])), b[4]) : ball(P.at(b[1], b[2]), b[3])));
  return P;
}
function extent(P) {
  const pts = S.rods.flatMap((r) => [P.at(r[0], r[1]), P.at(r[2], r[3])]), ax = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  for (const b of P.bodies) for (const a of ax) pts.push(at(b.centre, a, 2 * S.unit), at(b.centre, a, -2 * S.unit));
  if (S.plate) { const c = P.at(S.plate[0], S.plate[1]); for (const a of [-1, 1]) for (const b of [-1, 1]) pts.push([c[0] + a * S.plate[3], c[1] + b * S.plate[3], c[2]]); }
  if (S.hand) pts.push(at(P.at(S.hand[0], S.hand[1]), P.dir(S.hand[0], S.hand[2]), S.hand[4]));
  return pts.concat(more(P));
}
function aim(P, refit) {
  const cam = camera(view[0], view[1]), pts = extent(P), room = [62, 50, W - 62, H - 60];
  fit(cam, pts, room, (D.links ? 62 : 36) / S.unit);
  if (!refit && scale && scale.k <= cam.k * 1.35) { // keep the scale while a joint moves, unless something leaves the paper
    const k = cam.k, o = cam.o; cam.k = scale.k; cam.o = scale.o;
    if (pts.some((p) => { const [x, y] = cam.flat(p); return x < 20 || y < 20 || x > W - 20 || y > H - 20; })) { cam.k = k; cam.o = o; }
  }
  scale = { k: cam.k, o: cam.o };
  if (zoom !== 1) { cam.o = [W / 2 + (cam.o[0] - W / 2) * zoom, H / 2 + (cam.o[1] - H / 2) * zoom]; cam.k *= zoom; }
  return cam;
}
function draw(refit) {
  const P = placedScene(), cam = aim(P, refit), wishes = [], over = [], shapes = under(P, cam).concat(painted(S, P, cam, on), lines(cam));
  const ink = Ink(W, H); ink.add(shapes);
  const axes = above(P, cam, ink, over, wishes), [leaders, texts] = placed(wishes, ink, [3, 3, W - 3, H - 3]);
  svg.innerHTML = svgOf(shapes.concat(leaders, over, axes), texts);
  told(P);
}
for (const [name, v] of D.views) { const b = document.createElement("button"); b.textContent = name; b.onclick = () => { view = v.slice(); zoom = 1; draw(true); }; $("views").append(b); }
$("png").onclick = () => savePng(svg, D.name);
let held = new Map(), pinch = 0;
const spotted = (e) => { const r = svg.getBoundingClientRect(), k = Math.min(r.width / W, r.height / H); return [(e.clientX - r.left - (r.width - W * k) / 2) / k, (e.clientY - r.top - (r.height - H * k) / 2) / k]; };
svg.addEventListener("pointerdown", (e) => { svg.setPointerCapture(e.pointerId); if (!held.size && grab(...spotted(e))) return; held.set(e.pointerId, [e.clientX, e.clientY]); });
svg.addEventListener("pointermove", (e) => {
  if (pull(...spotted(e))) return;
  if (!held.has(e.pointerId)) return;
  const [x, y] = held.get(e.pointerId); held.set(e.pointerId, [e.clientX, e.clientY]);
  if (held.size === 2) { const [a, b] = [...held.values()], d = far(a, b); if (pinch) zoom = Math.min(8, Math.max(0.25, (zoom * d) / pinch)); pinch = d; draw(false); return; }
  view = [((view[0] - (e.clientX - x) * 0.5 + 540) % 360) - 180, Math.min(90, Math.max(-90, view[1] + (e.clientY - y) * 0.4))]; draw(true);
});
for (const t of ["pointerup", "pointercancel"]) svg.addEventListener(t, (e) => { held.delete(e.pointerId); pinch = 0; letGo(); });
svg.addEventListener("wheel", (e) => { e.preventDefault(); zoom = Math.min(8, Math.max(0.25, zoom * Math.exp(-e.deltaY * 0.001))); draw(false); }, { passive: false });
svg.addEventListener("keydown", (e) => {
  const step = { ArrowLeft: [5, 0], ArrowRight: [-5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] }[e.key];
  if (step) { view = [((view[0] + step[0] + 540) % 360) - 180, Math.min(90, Math.max(-90, view[1] + step[1]))]; draw(true); }
  else if (e.key === "+" || e.key === "-") { zoom = Math.min(8, Math.max(0.25, zoom * (e.key === "+" ? 1.15 : 0.87))); draw(false); } else return;
  e.preventDefault();
});
