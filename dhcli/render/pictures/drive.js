// The controls of a linkage: what moves it, how far, traces and the table of its points.
function signed(v, k) { const t = v.toFixed(k); return (+t === 0 ? t.replace("-", "") : t).replace("-", "−"); }
function told() {
  const s = driver ? driver.read(X) : 0;
  $("pins").innerHTML = "<tr><th></th>" + [..."xyz"].slice(0, D.points.length ? spotOf(D.points[0]).length : 2).map((c) => `<th>${c}</th>`).join("") + "</tr>" + D.points.map((p) => `<tr><td>${htmlOf(p[0])}</td>` + spotOf(p).map((c) => `<td>${signed(c, 4)}</td>`).join("") + "</tr>").join("");
  $("far").textContent = driver ? (driver.slide ? `${signed(s * D.size, 4)} m` : `${signed((s * 180) / Math.PI, 1)}°`) + " from the drawing" : "";
  if (document.activeElement !== $("drive") || note) $("drive").value = driver ? (driver.slide ? s * 360 : (s * 180) / Math.PI) : 0;
  $("note").textContent = note;
}
$("driver").innerHTML = drivers.map((d, i) => `<option value="${i}">${d.slide ? "slide" : "turn"} ${esc(d.name)}</option>`).join("");
$("driver").onchange = () => { driver = drivers[$("driver").value]; draw(); };
$("drive").oninput = () => { const v = parseFloat($("drive").value); if (driver) driveTo(driver.slide ? v / 360 : (v * Math.PI) / 180); draw(); };
$("home").onclick = () => { homed(); draw(); };
$("on-names").onchange = () => draw();
$("trace").innerHTML = "<option value=''>none</option>" + D.points.map((p, i) => `<option value="${i}">${esc(p[0].map((r) => r[0]).join(""))}</option>`).join("");
$("trace").onchange = () => { trail = []; last = null; draw(); };
$("png").onclick = () => savePng(svg, D.name);
$("play").onclick = () => { const go = (playing = playing ? 0 : 1), tick = () => { if (!playing) return; driveTo(driver.read(X) + (playing * Math.PI) / 90); if (note === DEAD) { note = ""; playing = -playing; } draw(); requestAnimationFrame(tick); }; if (go && F && driver) tick(); };
const begin = drivers.findIndex((d) => d.name === "crank") + 1 || drivers.findIndex((d) => d.tied) + 1; if (begin > 1) { driver = drivers[begin - 1]; $("driver").value = begin - 1; }
const out = D.points.findIndex((p) => p[2] === D.output); if (out >= 0) $("trace").value = out;
$("seen").textContent = F ? `${F} freedom${F > 1 ? "s" : ""} here` : "rigid"; draw();
