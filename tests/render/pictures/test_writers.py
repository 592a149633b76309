"""Files of figures: well-formed, the same bytes for the same figure, and nothing in them that a name could break."""

from __future__ import annotations

import itertools
import re
import shutil
import subprocess
import sys
import zlib
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import accumulate
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli import DhcliError, Robot, draw, load_robot
from dhcli.errors import RobotError
from dhcli.files.yaml.linkages import load_linkage
from dhcli.mobility.linkage import Linkage
from dhcli.render.paper import Paper
from dhcli.render.pictures.looks import LOOKS, TEXTS
from dhcli.render.pictures.pdf import pdf
from dhcli.render.pictures.picture import Picture
from dhcli.render.pictures.svg import svg
from dhcli.render.pictures.terminal import terminal
from dhcli.render.pictures.tikz import tikz
from dhcli.scene.shapes import Figure, Shape, Text
from dhcli.scene.table import cells as table_cells
from dhcli.scene.words import Run
from tests.nightly import paired
from tests.scene.examples import LINKAGES, long_robot, odd_robots

NAMES = ("puma560", "planar-2r", "spherical-wrist", "stanford", "planar-four-bar", "planetary-gear", "stewart-gough")
MARKUP = "</title></script><b>&'\"\u202e\x07 $%_{}\\ A"


def _picture(name: str, **options: object) -> Picture:
    if name not in LINKAGES:
        return draw(load_robot(name), **options)  # type: ignore[arg-type]
    linkage = load_linkage(name)
    assert isinstance(linkage, Linkage)
    return draw(linkage, **options)  # type: ignore[arg-type]


@cache
def _twins() -> tuple[Picture, Picture]:
    """The same picture, made twice."""
    return _picture("stanford"), _picture("stanford")


@pytest.mark.parametrize("name", NAMES)
def test_svg_is_well_formed_and_plain(name: str) -> None:
    """Every class has a look, every gradient exists once, and nothing is used that some readers of SVG lack."""
    text = _picture(name).svg()
    root = ET.fromstring(text)  # noqa: S314  our own text
    classes = {each.get("class", "").removeprefix("t-") for each in root.iter() if each.tag.endswith(("path", "text"))}
    assert classes - {""} <= LOOKS.keys() | TEXTS.keys()
    used = re.findall(r"url\(#(\w+)\)", text)
    assert sorted(used) == sorted(each.get("id") for each in root.iter() if each.tag.endswith("linearGradient"))
    assert not re.search("baseline-shift|paint-order|<image|<use|href|var\\(", text)
    assert len(text.encode()) < 80_000


@given(
    points=st.lists(st.tuples(st.floats(-900, 900), st.floats(-900, 900)), min_size=1, max_size=9), closed=st.booleans()
)
def test_a_path_written_as_steps_is_where_its_corners_are(points: list[tuple[float, float]], *, closed: bool) -> None:
    """To a tenth of a pixel, however many there are: added up, the steps lose nothing."""
    text = svg(Figure(100.0, 100.0, (Shape(tuple(points), "edge", closed=closed),), ()))
    (path,) = re.findall(r'class="edge" d="([^"]*)"', text)
    numbers = [Fraction(number) for number in re.findall(r"-?(?:\d+\.?\d*|\.\d+)", path)]
    xs, ys = (list(accumulate(numbers[axis::2])) for axis in (0, 1))
    assert [(x, y) for x, y in zip(xs, ys, strict=True)] == [
        (Fraction(round(10 * x), 10), Fraction(round(10 * y), 10)) for x, y in points
    ]
    assert path.endswith("z") == closed


def test_a_figure_grows_with_its_joints_by_less_than_four_kilobytes_each() -> None:
    """Twenty joints, each with a drum, a turn arrow, two axes, two lengths and six labels."""
    text = draw(long_robot(20)).svg()
    assert len(text.encode()) < 20 * 4_000


@pytest.mark.parametrize("kind", ["svg", "tikz", "pdf", "page", "terminal"])
def test_the_same_picture_is_the_same_bytes(kind: str) -> None:
    """Nothing depends on the clock, on chance or on the order of a set."""
    first, second = _twins()
    assert first.rendered(kind) == second.rendered(kind)


def test_another_process_with_another_seed_writes_the_same_svg() -> None:
    """The order of sets changes with the seed of hashes."""
    program = "import dhcli, sys; sys.stdout.write(dhcli.draw(dhcli.load_robot('ur5e')).svg())"
    done = subprocess.run(
        [sys.executable, "-c", program],
        env={"PYTHONHASHSEED": "1", "PYTHONIOENCODING": "utf-8"},
        capture_output=True,
        encoding="utf-8",
        check=True,
    )
    assert done.stdout == draw(load_robot("ur5e")).svg() != ""


def test_an_animation_shows_one_moment_at_a_time_and_the_last_where_nothing_may_move() -> None:
    """Each in a group of its own, in turn; all but the last are hidden but for the animation."""
    text = _picture("scara", pose="zero", to="pick").animated()
    root = ET.fromstring(text)  # noqa: S314  our own text
    groups = [each for each in root if each.tag.endswith("}g") and each.get("style")]
    assert len(groups) == 25
    assert [group.get("visibility") for group in groups] == ["hidden"] * 24 + [None]
    delays = [float(re.findall(r"-?[\d.]+", group.get("style") or "")[0]) for group in groups]
    assert delays == sorted(delays)
    assert delays[0] == -3
    assert delays[-1] < 0
    assert "prefers-reduced-motion:no-preference" in text
    assert text == _picture("scara", pose="zero", to="pick").animated()
    fills = set(re.findall(r"url\(#(f\w+g\d+)\)", text))
    assert fills == set(re.findall(r'<linearGradient id="(\w+)"', text))


def test_only_a_motion_can_be_animated_and_rows_have_a_number_for_each_joint() -> None:
    """The row is named."""
    with pytest.raises(DhcliError, match="nothing moves"):
        _picture("scara").animated()
    for rows in ([[0.1, 0.2]], [[0, 0, 0], [0, 0, float("nan")]]):
        with pytest.raises(RobotError, match=f"row {len(rows) - 1} of the path"):
            draw(load_robot("scara"), path=rows)
    with pytest.raises(DhcliError, match="the rows say where all joints are"):
        draw(load_robot("scara"), [0, 0, 0], path=[[0, 0, 0]]).svg()


def test_two_figures_on_one_page_do_not_meddle_with_each_other() -> None:
    """Rules and gradients carry a key of the figure."""
    one, other = _picture("puma560").svg(), _picture("puma560", dark=True).svg()
    keys = [re.search(r'class="(f[0-9a-f]{8})"', text) for text in (one, other)]
    assert keys[0]
    assert keys[1]
    assert keys[0][1] != keys[1][1]
    style = re.search(r"<style>(.*?)</style>", one, re.DOTALL)
    assert style
    assert all(
        part.strip().startswith((f".{keys[0][1]} ", "@media", "}")) for part in re.findall(r"[^{}]+(?=\{)", style[1])
    )


def test_light_and_dark_follow_the_reader_unless_dark_is_asked_for() -> None:
    """By the reader's colour scheme."""
    assert "prefers-color-scheme:dark" in _picture("scara").svg()
    assert "prefers-color-scheme" not in _picture("scara", dark=True).svg()


@pytest.mark.parametrize("kind", ["svg", "tikz", "pdf", "page", "terminal"])
def test_markup_in_a_title_stays_text(kind: str) -> None:
    """And what would steer a terminal or turn the direction of writing does not get through."""
    robot = replace(load_robot("planar-2r"), title=MARKUP, name="n</script>")
    content = Picture(robot).rendered(kind)
    text = content.partition(b"stream")[0].decode("latin-1") if isinstance(content, bytes) else content
    assert "\u202e" not in text
    assert "\x07" not in text
    if kind == "svg":
        root = ET.fromstring(text)  # noqa: S314  our own text
        assert not [each for each in root.iter() if each.tag.endswith("}b")]
    if kind == "page":
        assert text.count("</script>") == 2
        assert "<b>" not in text


def test_pdf_tells_where_its_objects_stand() -> None:
    """Each offset of the table points at its object, and the page's stream unpacks to whole operators."""
    content = _picture("puma560").pdf()
    start = int(re.findall(rb"startxref\n(\d+)\n%%EOF\n$", content)[0])
    assert content[start:].startswith(b"xref\n0 6\n")
    for number, place in enumerate(re.findall(rb"(\d{10}) 00000 n ", content), 1):
        assert content[int(place) :].startswith(b"%d 0 obj\n" % number)
    length = int(re.findall(rb"/Length (\d+)", content)[0])
    begin = content.index(b"stream\n") + 7
    stream = zlib.decompress(content[begin : begin + length]).decode("latin-1")
    assert stream.count("BT") == stream.count("ET") > 40
    assert stream.count("q ") == stream.count(" Q ")
    assert "(q) Tj" in stream  # the theta of the font Symbol


@pytest.mark.skipif(not shutil.which("pdflatex"), reason="no pdflatex: apt-get install texlive-pictures")
@pytest.mark.parametrize("kind", ["plain", "input"])
def test_tikz_compiles_alone_and_inside_a_document(kind: str, tmp_path: Path) -> None:
    """With nothing but tikz; a title full of LaTeX's own signs does no harm."""
    robot = replace(load_robot("puma560"), title=MARKUP)
    Picture(robot, table=True).save(tmp_path / "arm.tex")
    (tmp_path / "whole.tex").write_text(
        "\\documentclass{article}\\usepackage{tikz}\\begin{document}See: \\input{arm.tex}\\end{document}", "utf-8"
    )
    program = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "arm.tex" if kind == "plain" else "whole.tex"]
    done = subprocess.run(program, cwd=tmp_path, capture_output=True, check=False)
    assert done.returncode == 0, done.stdout.decode("latin-1")[-2000:]
    assert b"1 page" in done.stdout


def test_png_is_an_image_of_the_size_asked_for() -> None:
    """Twice the figure where none is."""
    pytest.importorskip("resvg_py")
    content = _picture("planar-2r", size=(410, 320)).png()
    assert content.startswith(b"\x89PNG\r\n\x1a\n")
    assert (int.from_bytes(content[16:20]), int.from_bytes(content[20:24])) == (410, 320)
    assert int.from_bytes(_picture("planar-2r").png()[16:20]) == 1640


def test_png_without_resvg_says_what_brings_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """And which formats need nothing."""
    monkeypatch.setitem(sys.modules, "resvg_py", None)
    with pytest.raises(DhcliError, match="resvg") as caught:
        _picture("planar-2r").png()
    assert "dhcli[draw]" in caught.value.problems[0].hint


@pytest.mark.parametrize(
    ("told", "columns"), paired([*itertools.product(["puma560", "scissor"], [True, False])], [16, 20, 33, 80, 120])
)
def test_no_line_in_the_terminal_is_wider_than_asked(told: tuple[str, bool], columns: int) -> None:
    """Whatever the paper knows; without Unicode all of it is ASCII."""
    name, unicode = told
    text = _picture(name).terminal(Paper(columns, unicode=unicode), columns)
    assert all(len(line) <= columns for line in text.split("\n"))
    assert text.isascii() != unicode
    assert all(line == line.rstrip() for line in text.split("\n"))


def test_labels_in_the_terminal_stand_whole_and_beside_each_other() -> None:
    """Indices are lowered where there are letters for them, and spelled out where there are not."""
    text = _picture("puma560").terminal(Paper(100))
    for label in ("z₀, z₁", "x₅, x₆", "θ₁", "d₄", "a₂"):
        assert label in text
    plain = _picture("scara").terminal(Paper(100, unicode=False))
    for label in ("theta1", "l1", "z0", "x2"):
        assert label in plain


@pytest.mark.parametrize("unicode", [True, False])
def test_an_axis_of_both_tables_differs_from_that_of_one_in_letters_too(*, unicode: bool) -> None:
    """Also without colour: one between the two sides of a wide one, or a dash for every second colon."""
    looks = {"theirs": ("theirs-axis",), "ours": ("x",), "both": ("theirs-axis", "x")}
    letters = {}
    for name, own in looks.items():
        shapes = tuple(Shape(((20.0, 69.0), (180.0, 69.0)), look) for look in own)
        letters[name] = terminal(Figure(200, 160, shapes, ()), Paper(25, unicode=unicode)).strip()
    assert len(set(letters.values())) == 3
    if not unicode:
        assert set(letters["both"]) == set(letters["theirs"]) | set(letters["ours"]) == {":", "-"}


def test_the_strokes_of_a_second_table_stand_in_every_format() -> None:
    """x₂′ is no x₂: in LaTeX a prime, in PDF that of the font Symbol, in plain letters an apostrophe."""
    figure = draw(load_robot("zhou-3r"), beside=load_robot("zhou-3r-modified"), pose="elbow").figure()
    stroked = Text((50.0, 50.0), (Run("x"), Run("2′", below=True)), "theirs", 17.0)
    figure = replace(figure, shapes=(), texts=(stroked,))
    assert "$x_{2'}$" in tikz(figure)
    written = zlib.decompress(pdf(figure).partition(b"stream\n")[2].partition(b"\nendstream")[0])
    assert b"\\242" in written
    assert b"(?)" not in written
    assert "x2'" in terminal(replace(figure, width=160.0, height=160.0), Paper(20, unicode=False))


def test_colour_is_only_where_the_paper_has_it() -> None:
    """X red, z cyan; and the same letters without."""
    inked = _picture("puma560").terminal(Paper(80, colour=True))
    assert "\x1b[31m" in inked
    assert "\x1b[36m" in inked
    assert re.sub(r"\x1b\[[0-9;]*m", "", inked) == _picture("puma560").terminal(Paper(80))


def test_fifteen_columns_are_too_few() -> None:
    """And so are seven rows."""
    with pytest.raises(DhcliError, match="15 x 8 letters are too few"):
        _picture("puma560").terminal(Paper(15))


def test_a_picture_shows_itself_in_a_notebook_and_saves_itself_by_suffix(tmp_path: Path) -> None:
    """A suffix that stands for nothing is refused with those that do."""
    picture = _picture("planar-2r", q=[0.3, 0.5])
    assert picture._repr_svg_().startswith("<svg")
    assert picture._repr_svg_() in picture._repr_html_()
    for suffix, begins in {"svg": b"<svg", "tex": b"% ", "pdf": b"%PDF", "html": b"<!DOCTYPE"}.items():
        picture.save(tmp_path / f"arm.{suffix}")
        assert (tmp_path / f"arm.{suffix}").read_bytes().startswith(begins)
    with pytest.raises(DhcliError, match="does not say which format"):
        picture.save(tmp_path / "arm.jpg")


def test_the_table_beside_has_the_columns_of_the_convention() -> None:
    """A and α with the index before in the modified one."""

    def cells(name: str) -> set[str]:
        texts = _picture(name, table=True).figure().texts
        return {"".join(run.text for run in text.words) for text in texts if text.look == "cell"}

    assert {"ai−1", "αi−1", "di", "θi", "a2", "−90°"} <= cells("puma560")
    assert {"ai", "αi", "di", "θi", "d2"} <= cells("stanford")
    assert "ai−1" not in cells("stanford")


@pytest.mark.parametrize("between", [" ", " * ", "*", ""])
def test_moves_of_a_product_have_a_dot_between_them_beside_a_figure(between: str) -> None:
    """However they were typed."""
    links = f"links: ['Rot(z, q1){between}Trans(0.3, 0, 0){between}[1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1]']"
    robot = Robot.from_text(f"format: 1\ntitle: x\nsource: x\nconvention: product\nvariables: [q1]\n{links}\n")
    (cell,) = ("".join(run.text for run in words) for words in table_cells(robot, robot.links[0]))
    assert cell.startswith("Rot(z,q1)·Trans(0.3,0,0)·[1")


def test_what_is_no_robot_a_size_that_is_none_and_a_linkage_with_joint_values_are_refused() -> None:
    """With what would be right."""
    with pytest.raises(RobotError, match="a Robot or a Linkage is wanted"):
        draw("puma560")  # type: ignore[arg-type]
    with pytest.raises(DhcliError, match="10 x 10 pixels"):
        _picture("scara", size=(10, 10))
    with pytest.raises(DhcliError, match="a size is a width and a height, not 800"):
        _picture("scara", size=800)
    with pytest.raises(RobotError, match="a path is rows of joint values in numbers, not 5"):
        _picture("scara", path=5)
    with pytest.raises(DhcliError, match="is a linkage"):
        _picture("bennett", q=[1]).svg()


@pytest.mark.parametrize("name", list(odd_robots()))
def test_every_writer_takes_an_odd_robot(name: str) -> None:
    """Fifty joints, no length at all, a millionth beside a million."""
    picture = draw(odd_robots()[name])
    figure = picture.figure()
    assert "nan" not in svg(figure)
    assert "nan" not in tikz(figure)
    assert pdf(figure).startswith(b"%PDF")
    assert picture.terminal(Paper(60))
    assert "NaN" not in picture.page()
