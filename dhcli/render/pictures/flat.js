// Paper: shapes, the placer of labels, and what they become; dhcli/scene does the same, so that a page needs no server.
const far = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
const esc = (s) => String(s).replace(/[&<>"']/g, (c) => "&#" + c.charCodeAt(0) + ";");
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

const LIGHT = new Set(["plate", "hatch", "halo", "ground-sheet", "cloud"]);
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
const path = (s) => s.dots ? s.points.map((p) => `M${p[0] - 1} ${p[1] - 1}h2v2h-2Z`).join("") : "M" + s.points.map((p) => f1(p[0]) + " " + f1(p[1])).join("L") + (s.closed ? "Z" : "");
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
const D = JSON.parse($("model").textContent), svg = $("figure"), W = 820, H = 640;
function savePng(svg, name) {
  const css = getComputedStyle(document.documentElement), text = new XMLSerializer().serializeToString(svg), sheetText = $("looks").textContent.replace(/var\((--[\w-]+)\)/g, (_, v) => css.getPropertyValue(v).trim());
  const [, , w, h] = svg.getAttribute("viewBox").split(" ").map(Number), img = new Image();
  img.onload = () => { const c = document.createElement("canvas"); c.width = 2 * w; c.height = 2 * h; const g = c.getContext("2d"); g.fillStyle = css.getPropertyValue("--paper").trim(); g.fillRect(0, 0, c.width, c.height); g.drawImage(img, 0, 0, c.width, c.height); const a = document.createElement("a"); a.download = name + ".png"; a.href = c.toDataURL(); a.click(); };
  img.src = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(text.replace(/^<svg[^>]*>/, (t) => `<svg xmlns="http://www.w3.org/2000/svg" width="${2 * w}" height="${2 * h}" viewBox="0 0 ${w} ${h}"><style>${sheetText}</style>`));
}
