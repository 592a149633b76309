// The page of a linkage in space whose motion it does not know: it can be turned.
const HOME = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]], states = () => D.links.map(() => HOME), under = () => [], lines = () => [], more = () => [], grab = () => null, pull = () => false, letGo = () => 0;
function above(P, cam, ink, over, wishes) { for (const [words, p, l] of D.points) wishes.push({ p: [cam.flat(P.at(l, p))], words, look: "mark", away: [0, 0] }); return []; }
function told() { $("seen").textContent = `azimuth ${view[0].toFixed(0)}°, elevation ${view[1].toFixed(0)}°`; }
on.body = true; draw(true);
