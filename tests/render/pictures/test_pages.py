"""Pages in a real browser: they ask for nothing, compute as dhcli does, and move linkages without breaking them."""

from __future__ import annotations

import html
import itertools
import json
import math
import random
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from dhcli import draw, forward, load_robot
from dhcli.files.yaml.linkages import load_linkage, read_linkage
from dhcli.mobility.finding import mobility_of
from dhcli.mobility.linkage import Linkage
from dhcli.render.pictures.picture import Picture
from dhcli.scene.places import Places
from dhcli.scene.words import named as words_of
from tests.nightly import NIGHT, in_turn
from tests.scene.examples import LINKAGES, ROBOTS, odd_robots

if TYPE_CHECKING:
    from selenium.webdriver import Chrome as WebDriver

REAL = tuple(name for name in ROBOTS if not name.startswith("dh-link"))
MOVING = ("planar-four-bar", "peaucellier", "slider-crank", "watt", "planetary-gear", "cam-follower", "scissor")
HELD = ("revolute", "spherical", "universal")
COUNT_PATHS = "return document.querySelectorAll('svg path').length"
IN_SPACE = ("bennett", "bricard", "goldberg", "sarrus", "hooke-coupling", "shaft-coupling", "delta", "stewart-gough")
MOVED = (*MOVING, *IN_SPACE)


def _linkage(name: str) -> Linkage:
    found = load_linkage(name)
    assert isinstance(found, Linkage)
    return found


def _open(browser: WebDriver, picture: Picture, folder: Path, name: str = "page") -> None:
    path = folder / f"{name}.html"
    picture.save(path)
    browser.get_log("performance")
    browser.get(path.as_uri())


LOADED = """
const [done] = arguments;
document.readyState === 'complete' ? done() : addEventListener('load', () => done());
"""


def _open_all(browser: WebDriver, pictures: Iterable[Picture], folder: Path) -> None:
    """Many pages side by side, each in a frame of its own: a browser takes longer over a page than over a frame."""
    frames = "".join(f'<iframe srcdoc="{html.escape(picture.page())}"></iframe>' for picture in pictures)
    path = folder / "pages.html"
    path.write_text(f"<!DOCTYPE html><style>iframe {{ width: 1200px; height: 800px }}</style>{frames}", "utf-8")
    browser.get_log("performance")
    browser.get(path.as_uri())
    browser.execute_async_script(LOADED)  # a driver waits for the page, and not always for the frames


def _check_silent(browser: WebDriver) -> None:
    """No error and no word on the console, and no request but that for the page itself."""
    asked = _asked(browser)
    assert asked
    assert all(url.startswith(("file:///", "data:")) for url in asked)


def _asked(browser: WebDriver) -> list[str]:
    """What was asked for since the last look, without an error or a word on the console."""
    assert browser.get_log("browser") == []
    events = [json.loads(entry["message"])["message"] for entry in browser.get_log("performance")]
    return [e["params"]["request"]["url"] for e in events if e["method"] == "Network.requestWillBeSent"]


@pytest.mark.parametrize("name", in_turn([*ROBOTS, *LINKAGES], 0, 3))
def test_a_page_names_no_address_but_those_of_namespaces(name: str) -> None:
    """Read as text, with no browser: nothing that could be fetched."""
    text = draw(_linkage(name) if name in LINKAGES else load_robot(name)).page()
    addresses = set(re.findall(r"(?:https?:)?//[\w.]+[^\s\"'<>`]*", text))
    assert addresses <= {"http://www.w3.org/2000/svg"}
    assert not re.search(r"<link|<img|\ssrc=|@import|fetch\(|XMLHttp|url\((?!#)", text)
    assert len(text.encode()) < 40_000


def test_pages_compute_what_dhcli_computes(browser: WebDriver, tmp_path: Path) -> None:
    """Every robot, random joint values, every frame from the first: within 1e-12 of forward."""
    rng = random.Random(18)  # noqa: S311  no secret
    robots = [load_robot(name) for name in REAL]
    asked = []
    for robot in robots:
        turning = [joint.kind == "revolute" for joint in robot.joints]
        poses = [
            [rng.uniform(-3, 3) if turns else rng.uniform(-1, 1) for turns in turning]
            for _ in range(50 if NIGHT else 10)
        ]
        asked.append([poses, robot.frames[1], robot.frames[-2]])
    _open_all(browser, map(draw, robots), tmp_path)
    computed = browser.execute_script(
        "return arguments[0].map(([poses, i, j], k) => poses.map(q => frames[k].dhcli.fk(q, i, j)))", asked
    )
    for robot, (poses, _, _), found in zip(robots, asked, computed, strict=True):
        for q, rows in zip(poses, found, strict=True):
            known = forward(robot, q).rows
            worst = max(
                abs(a - b) for ours, theirs in zip(known, rows, strict=True) for a, b in zip(ours, theirs, strict=True)
            )
            assert worst < 1e-12, robot.name
    _check_silent(browser)


def test_base_and_tool_frames_are_there_too(browser: WebDriver, tmp_path: Path) -> None:
    """zhou-6r has a tool."""
    robot = load_robot("zhou-6r")
    _open(browser, draw(robot), tmp_path)
    q = [0.1, -0.2, 0.3, 0.4, -0.5, 0.6]
    found = browser.execute_script("return dhcli.fk(arguments[0], '2', 'tool')", q)
    assert [x for row in found for x in row] == pytest.approx(
        [x for row in forward(robot, q, start=2, end="tool").rows for x in row], abs=1e-12
    )


def test_roll_pitch_and_yaw_follow_the_rule_of_dhcli_also_at_90_degrees(browser: WebDriver, tmp_path: Path) -> None:
    """There only one of roll and yaw can be told, and roll is 0."""
    _open(browser, draw(load_robot("spherical-wrist")), tmp_path)
    for q in ([0.3, 0.4, -0.5], [0.0, math.pi / 2, 0.2], [0.7, 0.0, 0.0]):
        pose = forward(load_robot("spherical-wrist"), q)
        roll, pitch, yaw, locked = browser.execute_script("return dhcli.rpy(dhcli.fk(arguments[0], '3', '6'))", q)
        assert (roll, pitch, yaw, locked) == pytest.approx(
            (pose.rpy.roll, pose.rpy.pitch, pose.rpy.yaw, pose.rpy.locked), abs=1e-9
        )


def test_a_slider_moves_the_arm_the_matrix_and_the_table_and_a_limit_is_marked(
    browser: WebDriver, tmp_path: Path
) -> None:
    """As a person drags it; the number field takes what is beyond the limits, marked."""
    _open(browser, draw(load_robot("puma560")), tmp_path)
    before = browser.execute_script("return [figure.innerHTML, matrix.innerText]")
    script = (
        "const e = document.getElementById(arguments[0]); e.value = arguments[1]; e.dispatchEvent(new Event('input'));"
    )
    browser.execute_script(script, "s1", "-30")
    after = browser.execute_script("return [figure.innerHTML, matrix.innerText, $('f1').value, $('f1').className]")
    assert after[0] != before[0]
    assert after[1] != before[1]
    assert after[2:] == ["-30", ""]
    known = forward(load_robot("puma560"), "0, -30°, 0, 0, -45°, 0")
    shown = [float(cell) for cell in after[1].replace("−", "-").split()]
    assert shown == pytest.approx([x for row in known.rows for x in row], abs=6e-5)
    browser.execute_script(script, "f1", "60")
    assert browser.execute_script("return [$('f1').className, $('b1').textContent]") == ["beyond", "beyond its limit"]
    browser.execute_script(
        "[...document.querySelectorAll('#poses button')].find(b => b.textContent === 'ready').click()"
    )
    assert browser.execute_script("return [$('f1').value, $('f2').value]") == ["-90", "-90"]
    _check_silent(browser)


def test_keys_turn_the_view_and_switches_take_parts_away(browser: WebDriver, tmp_path: Path) -> None:
    """Orbit needs no mouse; frames, dimensions, body and turns can be left out."""
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys

    _open(browser, draw(load_robot("stanford")), tmp_path)
    figure = browser.find_element(By.ID, "figure")
    seen = browser.execute_script("return seen.textContent")
    figure.send_keys(Keys.ARROW_LEFT)
    figure.send_keys(Keys.ARROW_UP)
    assert browser.execute_script("return seen.textContent") != seen
    for name, look in {"frames": "x", "dimensions": "dim", "turns": "turn", "body": "drum"}.items():
        count = f"return figure.querySelectorAll('.{look}').length"
        assert browser.execute_script(count) > 0
        browser.find_element(By.ID, f"on-{name}").click()
        assert browser.execute_script(count) == 0
    browser.find_element(By.ID, "on-frames").click()
    browser.find_element(By.ID, "on-y").click()
    assert browser.execute_script("return figure.querySelectorAll('.y').length") > 0
    _check_silent(browser)


def _pictures() -> Iterator[Picture]:
    """Every robot and linkage; at night each robot at all of its poses and from three sides."""
    for name in ROBOTS:
        robot = load_robot(name)
        yield draw(robot)
        for pose in robot.poses if NIGHT else ():
            for view in (None, "iso", "front"):
                yield draw(robot, pose=pose, view=view)
    for name in LINKAGES:
        yield draw(_linkage(name))


OVERLAPS = """
const figure = new DOMParser().parseFromString(arguments[0], 'image/svg+xml').documentElement;
document.body.replaceChildren(figure);
const texts = figure.querySelectorAll('text:not(.halo-text, .halo-text *, .t-caption)');
const boxes = [...texts].map(t => t.getBBox());
let n = 0;
boxes.forEach((a, i) => boxes.slice(i + 1).forEach(b => {
  if (a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height) n++;
}));
return [boxes.length, n];
"""


def test_no_label_overlaps_another_in_the_letters_of_a_browser(browser: WebDriver) -> None:
    """By the boxes that Chromium gives them: every robot and linkage, as a figure."""
    browser.get("about:blank")
    for picture in in_turn([*_pictures()], 0, 3):
        count, overlaps = browser.execute_script(OVERLAPS, picture.svg())
        assert count > 0
        assert overlaps == 0, picture


@pytest.fixture(scope="module")
def together(browser: WebDriver, tmp_path_factory: pytest.TempPathFactory) -> None:
    """The pages of all linkages that are moved, for all that is done there."""
    _open_all(browser, (draw(_linkage(name)) for name in MOVED), tmp_path_factory.mktemp("moved"))
    _check_silent(browser)


@pytest.fixture(params=MOVED, scope="module")
def moved(request: pytest.FixtureRequest, browser: WebDriver, together: None) -> Linkage:
    """A linkage whose page is looked at."""
    browser.switch_to.default_content()
    browser.switch_to.frame(MOVED.index(request.param))
    assert browser.execute_script(COUNT_PATHS) > 0
    return _linkage(request.param)


DRIVEN = """
dhcli.home();
const name = driver.name;
const reached = arguments[0].map((angle) => [dhcli.drive(name, angle), dhcli.gap(), dhcli.note()]);
dhcli.drive(name, 0);
const back = dhcli.state();
dhcli.home();
return [dhcli.freedom, reached, back, dhcli.state()];
"""


def test_a_driven_linkage_keeps_together_and_comes_back(moved: Linkage, browser: WebDriver) -> None:
    """Out to both sides and back: all joints within 1e-9, and the drawing as it was where it has one freedom."""
    angles = (0.3, -0.4, 0.2)
    free, driven, back, home = browser.execute_script(DRIVEN, angles)
    assert free == mobility_of(moved).instantaneous
    for angle, (reached, gap, note) in zip(angles, driven, strict=True):
        assert gap < 1e-9
        assert note or reached == pytest.approx(angle, abs=1e-9)
    if free == 1:
        assert max(map(abs, back)) < 1e-9
    assert not any(home)
    assert _asked(browser) == []


def test_points_of_a_link_keep_their_distances_however_it_is_dragged(moved: Linkage, browser: WebDriver) -> None:
    """To 1e-9, each point pulled somewhere in turn."""
    places = Places(moved)
    named = dict(places.named())
    held = {
        link: [joint.point for joint in moved.joints if link in joint.links and joint.pair.name in HELD and joint.point]
        for link in moved.links
    }
    pairs = [
        pair
        for points in held.values()
        for pair in itertools.combinations([n for n, at in named.items() if any(places.same(at, p) for p in points)], 2)
    ]
    assert pairs or moved.name in ("cam-follower", "hooke-coupling", "shaft-coupling")
    goals = [[x + 0.2 * places.size * ((-1) ** k) for k, x in enumerate(at)] for at in named.values()]
    script = (
        "dhcli.home(); for (const [name, goal] of arguments[0]) dhcli.drag(name, goal);"
        "return [dhcli.gap(), Object.fromEntries(arguments[1].map(n => [n, dhcli.at(n)]))]"
    )
    flat = 2 if moved.space.is_planar else 3
    pulled = [[_plain(n), goal[:flat]] for n, goal in zip(named, goals, strict=True)][-6:]
    gap, found = browser.execute_script(script, pulled, [_plain(n) for n in named])
    assert gap < 1e-9
    ways = [math.dist(found[_plain(n)], at[:flat]) for n, at in named.items()]
    assert max(ways) > 1e-3 * places.size or len(named) == 1
    for one, other in pairs:
        now = math.dist(found[_plain(one)], found[_plain(other)])
        assert now == pytest.approx(math.dist(named[one], named[other]), abs=1e-9 * places.size)
    assert _asked(browser) == []


def _plain(name: str) -> str:
    """A name as a page calls it."""
    return "".join(run.text for run in words_of(name))


def test_a_cross_turns_its_shafts_as_the_equation_of_the_universal_joint_says(
    browser: WebDriver, tmp_path: Path
) -> None:
    """The tangents of both angles, from where the forks stand across, are as the cosine of the bend."""
    _open(browser, draw(_linkage("hooke-coupling")), tmp_path)
    names = browser.execute_script("return dhcli.drivers")
    for angle in (0.3, 0.9, 1.4, -0.7):
        browser.execute_script("dhcli.drive(arguments[0], arguments[1])", names[0], angle)
        driven = browser.execute_script("return drivers[1].value")
        ratios = math.tan(driven) / math.tan(angle)
        bend = math.cos(math.radians(25))
        assert min(abs(abs(ratios) - bend), abs(abs(ratios) - 1 / bend)) < 1e-9


def test_the_plate_of_a_sarrus_linkage_goes_straight(browser: WebDriver, tmp_path: Path) -> None:
    """Without turning, while its legs fold."""
    _open(browser, draw(_linkage("sarrus")), tmp_path)
    out = browser.execute_script("return D.links.indexOf(arguments[0])", _linkage("sarrus").output)
    frames = []
    for angle in (0.0, 0.2, 0.4, -0.3):
        browser.execute_script("dhcli.drive(dhcli.drivers[0], arguments[0])", angle)
        frames.append(browser.execute_script("return X[arguments[0]]", out))
    ways = [[a - b for a, b in zip(frame[3], frames[0][3], strict=True)] for frame in frames[1:]]
    for frame, way in zip(frames[1:], ways, strict=True):
        assert [x for axis in frame[:3] for x in axis] == pytest.approx([1, 0, 0, 0, 1, 0, 0, 0, 1], abs=1e-9)
        across = [way[(i + 1) % 3] * ways[0][(i + 2) % 3] - way[(i + 2) % 3] * ways[0][(i + 1) % 3] for i in range(3)]
        assert math.hypot(*across) < 1e-9
        assert math.hypot(*way) > 1e-3


def test_the_mouse_drags_a_linkage_in_space_by_a_point_and_turns_it_elsewhere(
    browser: WebDriver, tmp_path: Path
) -> None:
    """By events as a hand makes them."""
    from selenium.webdriver import ActionChains
    from selenium.webdriver.common.by import By

    _open(browser, draw(_linkage("bennett")), tmp_path)
    figure = browser.find_element(By.ID, "figure")
    script = """
      const r = figure.getBoundingClientRect(), k = Math.min(r.width / W, r.height / H);
      const p = eye.flat(spotOf(D.points[1]));
      return [p[0] * k - W * k / 2, p[1] * k - H * k / 2, 30 * k];
    """
    x, y, _ = browser.execute_script(script)
    view = browser.execute_script("return view")
    ActionChains(browser).move_to_element_with_offset(figure, int(x), int(y)).click_and_hold().move_by_offset(
        0, -40
    ).release().perform()
    assert browser.execute_script("return view") == view
    assert max(map(abs, browser.execute_script("return dhcli.state()"))) > 0.01
    state = browser.execute_script("return dhcli.state()")
    ActionChains(browser).move_to_element_with_offset(figure, 0, 0).click_and_hold().move_by_offset(
        60, 20
    ).release().perform()
    assert browser.execute_script("return view") != view
    assert browser.execute_script("return dhcli.state()") == state
    _check_silent(browser)


def test_a_dragged_pin_goes_where_it_can_and_bars_keep_their_lengths(browser: WebDriver, tmp_path: Path) -> None:
    """The crank of a four-bar follows the hand around its circle."""
    _open(browser, draw(_linkage("planar-four-bar")), tmp_path)
    for goal in ((0.9, 0.7), (1.0, 0.3), (-0.2, 1.05), (5.0, 5.0)):
        browser.execute_script("dhcli.drag('B', arguments[0])", list(goal))
        a, b, c, d = (browser.execute_script(f"return dhcli.at('{pin}')") for pin in "ABCD")
        for one, other, length in ((a, b, (0.4, 1.0)), (b, c, (1.8, 0.7)), (c, d, (0.4, 1.7))):
            assert math.dist(one, other) == pytest.approx(math.hypot(*length), abs=1e-9)
    browser.execute_script("dhcli.home(); dhcli.drag('B', [0.9, 0.6])")
    x, y = browser.execute_script("return dhcli.at('B')")
    assert math.atan2(y, x) == pytest.approx(math.atan2(0.6, 0.9), abs=0.02)


def test_peaucelliers_point_stays_on_its_line_through_all_that_the_crank_can_do(
    browser: WebDriver, tmp_path: Path
) -> None:
    """To 1e-9, from one dead position to the other; there the page says that it goes no further."""
    _open(browser, draw(_linkage("peaucellier")), tmp_path)
    line = browser.execute_script("return dhcli.at('T')")[0]
    ends = []
    script = """
      const places = [];
      dhcli.home();
      for (let step = 1; step < 60 && !dhcli.note(); step++) {
        dhcli.drive('crank', arguments[0] * step * 0.05);
        places.push(dhcli.at('T')[0]);
      }
      return [places, note, driver.read(X)];
    """
    for side in (1, -1):
        places, note, end = browser.execute_script(script, side)
        assert places
        assert places == pytest.approx([line] * len(places), abs=1e-9)
        assert "dead position" in note
        ends.append(end)
    limit = 2 * math.acos((3 - 1.25) / 2)  # where the rhombus lies flat, OP = l - s
    start = math.radians(35)
    assert ends[0] == pytest.approx(limit - start, abs=0.01)
    assert ends[1] == pytest.approx(-limit - start, abs=0.01)


def test_pages_of_odd_robots_and_of_all_linkages_open_without_a_word(browser: WebDriver, tmp_path: Path) -> None:
    """A name with markup among them; those that are moved are open there."""
    linkages = [_linkage(name) for name in set(LINKAGES).difference(MOVED)]
    _open_all(browser, map(draw, (*linkages, *odd_robots().values())), tmp_path)
    drawn = browser.execute_script(
        "return Array.from(frames, each => each.document.querySelectorAll('svg path').length)"
    )
    assert len(drawn) == len(linkages) + len(odd_robots())
    assert all(drawn)
    _check_silent(browser)


def test_a_page_fits_a_phone(browser: WebDriver, tmp_path: Path) -> None:
    """Nothing is wider than the window; the figure stays in sight over the controls."""
    browser.set_window_size(500, 800)
    _open(browser, draw(load_robot("panda")), tmp_path)
    wide, window = browser.execute_script("return [document.documentElement.scrollWidth, innerWidth]")
    top = browser.execute_script("return document.querySelector('.stage').getBoundingClientRect().top")
    browser.set_window_size(1280, 800)
    assert wide <= window
    assert top == 0


def test_a_finger_turns_the_view_and_two_fingers_zoom(browser: WebDriver, tmp_path: Path) -> None:
    """By touches as a phone sends them; the page itself does not scroll away under them."""
    _open(browser, draw(load_robot("scara")), tmp_path)
    x, y = browser.execute_script(
        "const r = figure.getBoundingClientRect(); return [r.left + r.width / 2, r.top + r.height / 2]"
    )
    view, zoom = browser.execute_script("return [view, zoom]")
    _touch(browser, "touchStart", [(x, y)])
    _touch(browser, "touchMove", [(x + 40, y + 20)])
    _touch(browser, "touchEnd", [])
    turned = browser.execute_script("return view")
    assert turned != view
    _touch(browser, "touchStart", [(x - 20, y), (x + 20, y)])
    for apart in (30, 60, 90):
        _touch(browser, "touchMove", [(x - apart, y), (x + apart, y)])
    _touch(browser, "touchEnd", [])
    assert browser.execute_script("return zoom") > 1.5 * zoom
    assert browser.execute_script("return view") == turned
    assert browser.execute_script("return [scrollX, scrollY]") == [0, 0]
    _check_silent(browser)


def test_a_finger_drags_a_linkage(browser: WebDriver, tmp_path: Path) -> None:
    """The crank follows it."""
    _open(browser, draw(_linkage("planar-four-bar")), tmp_path)
    script = """
      const r = figure.getBoundingClientRect(), k = Math.min(r.width / W, r.height / H), [x, y] = flat(dhcli.at('B'));
      return [r.left + (r.width - W * k) / 2 + x * k, r.top + (r.height - H * k) / 2 + y * k];
    """
    x, y = browser.execute_script(script)
    _touch(browser, "touchStart", [(x, y)])
    _touch(browser, "touchMove", [(x + 30, y + 10)])
    _touch(browser, "touchEnd", [])
    assert max(map(abs, browser.execute_script("return dhcli.state()"))) > 0.01
    assert browser.execute_script("return dhcli.gap()") < 1e-9
    _check_silent(browser)


def _touch(browser: WebDriver, kind: str, points: list[tuple[float, float]]) -> None:
    """A touch of some fingers."""
    touches = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(points)]
    browser.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": touches})


def _media(browser: WebDriver, scheme: str, media: str = "") -> None:
    """What the reader prefers, and on what the page is shown."""
    features = [{"name": "prefers-color-scheme", "value": scheme}]
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": media, "features": features})


def test_a_page_is_light_or_dark_as_the_reader_prefers_and_light_on_paper(browser: WebDriver, tmp_path: Path) -> None:
    """Letters stand out from the ground; what cannot be pressed is not printed."""
    script = """
      const style = getComputedStyle(document.body), button = document.querySelector('button');
      const light = (c) => c.match(/\\d+/g).slice(0, 3).reduce((s, v) => s + +v, 0) / 765;
      return [light(style.backgroundColor), light(style.color), getComputedStyle(button).display];
    """
    pictures = (draw(load_robot("scara")), draw(_linkage("bennett")), draw(_linkage("watt")))
    try:
        for picture in pictures:
            _open(browser, picture, tmp_path)
            _media(browser, "light")
            paper, letters, _ = browser.execute_script(script)
            assert (paper > 0.9, letters < 0.2) == (True, True)
            _media(browser, "dark")
            paper, letters, button = browser.execute_script(script)
            assert (paper < 0.2, letters > 0.8, button != "none") == (True, True, True)
            _media(browser, "dark", "print")
            paper, letters, button = browser.execute_script(script)
            assert (paper > 0.9, letters < 0.2, button) == (True, True, "none")
            assert browser.execute_script("return figure.getBoundingClientRect().height") > 200
    finally:
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "", "features": []})


def test_a_page_plays_a_motion_there_and_back(browser: WebDriver, tmp_path: Path) -> None:
    """From the pose of the picture to the one it goes to."""
    _open(browser, draw(load_robot("scara"), pose="zero", to="pick"), tmp_path)
    goal = browser.execute_script("return D.path[0]")
    assert goal == pytest.approx([math.radians(30), math.radians(45), 0.1], abs=1e-12)
    assert browser.execute_script("return q") == [0, 0, 0]
    browser.execute_script("window.requestAnimationFrame = f => { window.next = f; }; $('play').click();")
    browser.execute_script("for (let k = 1; k < 120; k++) window.next();")
    assert browser.execute_script("return q") == pytest.approx(goal, abs=1e-12)
    browser.execute_script("for (let k = 0; k < 120; k++) window.next();")
    assert browser.execute_script("return q") == [0, 0, 0]
    _check_silent(browser)


def test_a_page_plays_the_rows_of_a_path_and_shows_their_way(browser: WebDriver, tmp_path: Path) -> None:
    """Through every row, exactly, and the way of the end is that of forward."""
    robot = load_robot("puma560")
    rows = [[0.1 * k, -0.5, 0.4 + 0.05 * k, 0.2, -0.3, 0.1 * k * k] for k in range(7)]
    _open(browser, draw(robot, path=rows), tmp_path)
    trace = browser.execute_script("return TRACE")
    for row, place in zip(rows, trace, strict=True):
        assert place == pytest.approx(forward(robot, row).position, abs=1e-9)
    browser.execute_script("window.requestAnimationFrame = f => { window.next = f; }; $('play').click();")
    browser.execute_script("for (let k = 1; k < 120; k++) window.next();")
    assert browser.execute_script("return q") == pytest.approx(rows[-1], abs=1e-9)
    assert browser.execute_script("return figure.querySelectorAll('.trace').length") == 1
    _check_silent(browser)


def test_the_mouse_turns_an_arm_and_drags_a_pin(browser: WebDriver, tmp_path: Path) -> None:
    """By events as a hand makes them, not by a call."""
    from selenium.webdriver import ActionChains
    from selenium.webdriver.common.by import By

    _open(browser, draw(load_robot("puma560")), tmp_path)
    seen = browser.execute_script("return [view.slice(), q]")
    figure = browser.find_element(By.ID, "figure")
    ActionChains(browser).move_to_element(figure).click_and_hold().move_by_offset(60, 30).release().perform()
    turned = browser.execute_script("return [view.slice(), q]")
    assert turned[0] == pytest.approx([seen[0][0] - 30, seen[0][1] + 12])
    assert turned[1] == seen[1]

    _open(browser, draw(_linkage("planar-four-bar")), tmp_path)
    spot = """
      const r = svg.getBoundingClientRect(), k = Math.min(r.width / W, r.height / H), p = there(2, [0.4, 1.0]);
      return [(p[0] - W / 2) * k, (p[1] - H / 2) * k];
    """
    x, y = browser.execute_script(spot.replace("2,", "D.links.findIndex(l => l[0] === 'crank'),"))
    figure = browser.find_element(By.ID, "figure")
    hand = ActionChains(browser).move_to_element_with_offset(figure, round(x), round(y))
    hand.click_and_hold().move_by_offset(40, 10).move_by_offset(40, 20).release().perform()
    bx, by = browser.execute_script("return dhcli.at('B')")
    assert bx > 0.5
    assert math.hypot(bx, by) == pytest.approx(math.hypot(0.4, 1.0), abs=1e-9)
    _check_silent(browser)


def test_the_button_makes_a_png_of_what_is_seen(browser: WebDriver, tmp_path: Path) -> None:
    """Twice as large, on the paper's colour; nothing is fetched for it."""
    for picture in (draw(load_robot("scara")), draw(_linkage("watt"))):
        _open(browser, picture, tmp_path)
        script = """
          const done = arguments[arguments.length - 1];
          HTMLAnchorElement.prototype.click = function () {
            const made = new Image();
            made.onload = () => done([this.download, made.width, made.height, this.href.length]);
            made.src = this.href;
          };
          document.getElementById('png').click();
        """
        name, wide, high, size = browser.execute_async_script(script)
        assert (name, wide, high) == (f"{picture.what.name}.png", 1640, 1280)
        assert size > 20_000
        _check_silent(browser)


def test_a_linkage_in_space_whose_motion_a_page_does_not_know_can_be_turned(browser: WebDriver, tmp_path: Path) -> None:
    """Two wheels that mesh: there is nothing to drive, and no word of it on the console."""
    text = (
        "format: 1\ntitle: Wheels\nsource: made for a test\nspace: spatial\npoints: {O: [0, 0, 0], P: [3, 0, 0]}\n"
        "joints:\n  - {type: R, links: [ground, one], point: O, axis: z}\n"
        "  - {type: R, links: [ground, two], point: P, axis: z}\n"
        "  - {type: gear, links: [one, two], carrier: ground, radii: [1, 2]}\n"
    )
    found = read_linkage(text, "wheels.yaml", "wheels")
    assert isinstance(found, Linkage)
    _open(browser, draw(found), tmp_path)
    seen = browser.execute_script("return seen.textContent")
    browser.execute_script("document.querySelector('#views button:last-child').click()")
    assert browser.execute_script("return seen.textContent") != seen
    assert browser.execute_script("return [...figure.querySelectorAll('.t-mark')].length") == 2
    _check_silent(browser)


def test_the_order_of_moves_has_its_indices_below_the_line() -> None:
    """A page writes them as indices, not as a terminal does."""
    page = draw(load_robot("puma560")).page()
    assert "Rot(x, α<sub>i-1</sub>) Trans(x, a<sub>i-1</sub>) Trans(z, d<sub>i</sub>) Rot(z, θ<sub>i</sub>)" in page
    assert "θ_i" not in page
