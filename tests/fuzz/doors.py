"""Every door of dhcli: valid command lines and files, one word or one file of which is then mutated."""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from tests.fuzz.mutating import mutated, mutated_bytes

ROOT = Path(__file__).parents[2]
IDENTITY = "1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1"

LINES: tuple[tuple[str, ...], ...] = (
    ("fk", "scara", "--q", "0.3,30°,100mm", "--digits", "3", "--format", "json"),
    ("fk", "scara", "--q", "theta1=10, theta2=20, d3=0.1", "--deg", "--set", "l1=400 mm", "--set", "l2=1/3 m"),
    (
        "fk",
        "puma560",
        "--pose",
        "ready",
        "--as",
        "position,rpy,quaternion,axis-angle",
        "--from",
        "base",
        "--to",
        "tool",
    ),
    ("fk", "planar-2r", "-s", "--q", "theta1=90°", "--style", "full", "--let"),
    ("fk", "planar-2r", "-s", "--point", "1,a1,0", "--inverse"),
    ("fk", "planar-2r", "--code", "julia", "--with-values", "--q", "theta1=90°", "--inverse"),
    ("ik", "planar-2r", "--code", "matlab", "--with-values", "--set", "a1=0.5"),
    ("jacobian", "scara", "--code", "c", "--with-values", "--set", "l1=0.5", "--body"),
    ("fk", "planar-2r", "-s", "--factors", "1", "--format", "sympy"),
    ("fk", "stanford", "-s", "--frames"),
    ("fk", "stanford", "--links", "--q", "0,0,0.2,0,0,0", "--format", "csv"),
    ("fk", "scara", "--in", "q.csv", "--ignore-columns"),
    ("fk", "scara", "--rows", "q.csv", "--ignore-columns", "--skip-bad", "--index", "--deg", "--jobs", "2"),
    ("fk", "scara", "--pose", "pick", "-o", "out.m", "--overwrite"),
    (
        "sweep",
        "planar-2r",
        "--over",
        "theta1=-90°..90° step 30°",
        "--over",
        "theta2 n 4",
        "--point",
        "0,0,0",
        "--digits",
        "2",
        "--jobs",
        "2",
    ),
    ("sweep", "scara", "--over", "theta1=0..1 step 0.5", "--pose", "zero", "--set", "l1=1", "--from", "0", "--to", "3"),
    ("sweep", "scara", "--over", "theta1=0..1 step 0.5", "--pose", "zero", "--tool", "Trans(0.1,0,0)"),
    (
        "sweep",
        "scara",
        "--over",
        "d3=0..30mm step 10mm",
        "--q",
        "theta1=0,theta2=0",
        "--deg",
        "--format",
        "csv",
        "-o",
        "s.csv",
    ),
    ("transform", "Trans(8,-6,14) Rot(y,90°) Rot(z,a)^-1", "--set", "a=30°", "--point", "1,2,3", "--vector", "0,0,1"),
    ("transform", f"Rot(x,b) [{IDENTITY}]", "--steps", "--fixed", "-s", "--style", "full"),
    (
        "transform",
        "Rot(z,0.5 rad) Trans(0,0,400 mm)",
        "--as",
        "rpy",
        "--digits",
        "2",
        "--format",
        "json",
        "-o",
        "t.json",
    ),
    ("jacobian", "planar-2r", "-s", "--let", "--from", "0", "--to", "2", "--point", "0,0,0", "--format", "latex"),
    ("jacobian", "scara", "--q", "10,20,0.1", "--deg", "--set", "l1=1", "--digits", "3", "--style", "full"),
    (
        "jacobian",
        "scara",
        "--pose",
        "pick",
        "--part",
        "linear",
        "--order",
        "angular-first",
        "-o",
        "j.json",
        "--overwrite",
    ),
    ("jacobian", "scara", "--pose", "pick", "--analytic", "rpy"),
    ("jacobian", "scara", "--pose", "pick", "--space"),
    ("jacobian", "scara", "--pose", "pick", "--body"),
    ("jacobian", "scara", "--pose", "pick", "--in", "tool", "--tool", "Trans(0,0,l1) Rot(z,30°)"),
    ("jacobian", "scara", "--rows", "q.csv", "--skip-bad", "--ignore-columns", "--index", "--jobs", "2"),
    (
        "singularities",
        "planar-2r",
        "--from",
        "0",
        "--to",
        "2",
        "--part",
        "linear",
        "--point",
        "0,0,0",
        "--format",
        "json",
    ),
    (
        "singularities",
        "scara",
        "--q",
        "10,20,0.1",
        "--deg",
        "--set",
        "l1=1",
        "--style",
        "full",
        "-o",
        "s.json",
        "--overwrite",
    ),
    ("singularities", "scara", "--pose", "pick", "--tool", "Trans(0,0,l1)"),
    ("rates", "planar-2r", "--q", "10,20", "--deg", "--set", "a1=1", "--velocity", "1,0,0", "--angular", "0,0,1"),
    ("rates", "scara", "--pose", "pick", "--velocity", "1,0,0", "--damped", "0.1", "--digits", "3", "--style", "full"),
    ("rates", "planar-2r", "-s", "--rates", "1,2", "--from", "0", "--to", "2", "--in", "0", "--at", "0,0,0"),
    ("rates", "scara", "--pose", "pick", "--rates", "1,2,3", "--format", "json", "-o", "r.json", "--overwrite"),
    ("rates", "scara", "--pose", "pick", "--rates", "1,2,3", "--tool", "Trans(0.1,0,0)"),
    ("torques", "planar-2r", "--q", "10,20", "--deg", "--set", "a1=1", "--force", "1,0,0", "--moment", "0,0,1"),
    ("torques", "planar-2r", "-s", "--force", "1,0,0", "--from", "0", "--to", "2", "--in", "0", "--at", "0,0,0"),
    ("torques", "scara", "--pose", "pick", "--force", "1,0,0", "--style", "full", "--digits", "3"),
    ("torques", "scara", "--pose", "pick", "--force", "1,0,0", "--tool", "Trans(0.1,0,0)"),
    ("torques", "scara", "--pose", "pick", "--force", "1,0,0", "--format", "json", "-o", "t.json", "--overwrite"),
    ("draw", "scara", "--q", "10,20,0.1", "--deg", "--set", "l1=1", "--view", "top", "--size", "80x20"),
    ("draw", "scara", "--pose", "pick", "--dark", "--table", "-o", "a.svg", "--overwrite"),
    ("draw", "puma560", "--pose", "ready", "-o", "a.tex"),
    ("draw", "scara", "--pose", "pick", "--to", "zero", "-o", "film.svg"),
    ("draw", "puma560", "--pose", "ready", "--beside", "puma560-standard", "--tool", "Trans(0,0,0.1)"),
    ("draw", "./arm.urdf", "--base", "base_link", "--tip", "hand", "--as-typed"),
    ("dof", "./arm.urdf", "--base", "base_link", "--tip", "hand"),
    ("dof", "scara", "--q", "10,20,0.1", "--deg"),
    ("dof", "scara", "--pose", "pick"),
    ("transform", "Rot(z,phi) Trans(height,0,0)", "--symbols", "phi,height"),
    ("check", "scara", "--pose", "zero", "--entry", "1,4", "--answer", "0", "--tool", "Trans(0,0,0.1)"),
    (
        "check",
        "./arm.urdf",
        "--base",
        "base_link",
        "--tip",
        "hand",
        "--as-typed",
        "--q",
        "0,0,0",
        "--entry",
        "1,4",
        "--answer",
        "0",
    ),
    ("check", "scara", "--pose", "zero", "--as", "position", "--answer", "0, 0.5, 0.4"),
    ("show", "scara", "--draw"),
    ("fk", "./arm.urdf", "--base", "base_link", "--tip", "hand", "--as-typed", "-s"),
    ("fk", "scara", "--pose", "pick", "--tool", "Trans(0,0,l1) Rot(z,30°)"),
    ("show", "./arm.urdf", "--base", "base_link", "--tip", "hand", "--as-typed"),
    ("ik", "./arm.urdf", "--base", "base_link", "--tip", "hand", "--as-typed", "--q", "0,0,0"),
    ("jacobian", "./arm.urdf", "--base", "base_link", "--tip", "hand", "--as-typed", "-s"),
    ("rates", "./arm.urdf", "--base", "base_link", "--tip", "hand", "--as-typed", "-s", "--rates", "1,2,3"),
    ("torques", "./arm.urdf", "--base", "base_link", "--tip", "hand", "--as-typed", "-s", "--force", "1,0,0"),
    ("singularities", "./arm.urdf", "--base", "base_link", "--tip", "hand", "--as-typed"),
    (
        "sweep",
        "./arm.urdf",
        "--base",
        "base_link",
        "--tip",
        "hand",
        "--as-typed",
        "--over",
        "q1 n 3",
        "--q",
        "q2=0,q3=0",
    ),
    ("describe", "./arm.urdf", "--base", "base_link", "--tip", "hand", "--as-typed", "--as", "modified"),
    ("describe", "zhou-3r", "--as", "standard", "--steps", "--set", "a=0.3", "--numbers", "--format", "json"),
    ("describe", "puma560", "--as", "axes", "--pose", "ready", "-o", "d.yaml", "--overwrite"),
    ("describe", "./arm.urdf", "--tip", "hand", "--as", "screws", "--digits", "3"),
    ("describe", "puma560", "--as", "axes", "--tool", "Trans(0,0,0.1) Rot(z,45°)"),
    ("describe", "ur5e", "--as", "standard", "--choose", "next-d,previous-x"),
    ("fk", "./motors.yaml", "--motors", "--q", "0,31°,-33°"),
    ("ik", "./motors.yaml", "--motors", "--q", "0,31°,-33°", "--task", "position"),
    ("jacobian", "./motors.yaml", "--motors", "-s"),
    ("rates", "./motors.yaml", "--motors", "--pose", "folded", "--velocity", "0.1,0,0"),
    ("torques", "./motors.yaml", "--motors", "--pose", "folded", "--force", "1,0,0"),
    ("singularities", "./motors.yaml", "--motors"),
    ("sweep", "./motors.yaml", "--motors", "--over", "J2 n 3", "--q", "theta1=0,J3=0"),
    ("check", "./motors.yaml", "--motors", "--pose", "folded", "--entry", "1,4", "--answer", "0"),
    ("describe", "ur5e", "--as", "standard", "--straighten", "0.01°", "--format", "json"),
    ("describe", "./motors.yaml", "--as", "motors"),
    ("describe", "./motors.yaml", "--motors", "--as", "standard"),
    ("draw", "yim/planar-in-numbers", "--variant", "alice", "--solution", "--yes", "--worksheet", "-o", "w.svg"),
    ("ik", "planar-2r", "--q", "10,20", "--deg", "--set", "a1=1", "--task", "position", "--from", "0", "--to", "2"),
    ("ik", "puma560", "--pose", "ready", "--near", "ready", "--branch", "elbow up", "--within-limits", "--digits", "3"),
    ("ik", "puma560", "--target", "Trans(0.4,0.15,0.3) Rot(y,90°)", "--all-turns", "--format", "json", "-o", "i.json"),
    (
        "ik",
        "puma560",
        "--position",
        "0.4,0.15,0.3",
        "--rpy",
        "0,90,0",
        "--deg",
        "--format",
        "csv",
        "-o",
        "i.csv",
        "--overwrite",
    ),
    ("ik", "puma560", "--position", "0.4,0.15,0.3", "--quaternion", "1,0,0,0", "--tool", "Trans(0,0,0.1)"),
    ("ik", "panda", "--pose", "ready", "--hold", "theta7=0", "--family", "3"),
    ("ik", "puma560", "--position", "0.4,0.15,0.3", "--pointing", "0,0,-1"),
    ("ik", "planar-2r", "--derive"),
    ("ik", "puma560", "--position", "0.4,0.15,0.3", "--euler", "zyz 0,30°,1", "--why"),
    ("ik", "planar-2r", "Trans(0.4,0.15,0)", "--task", "position"),
    ("ik", "scara", "--in", "poses.csv"),
    ("ik", "scara", "--rows", "poses.csv", "--each", "first"),
    ("ik", "scara", "--rows", "poses.csv", "--skip-bad", "--jobs", "2"),
    ("ik", "scara", "--rows", "poses.csv", "--follow", "--near", "zero"),
    ("check", "planar-2r", "--ik", "--target", "Trans(0.7,0,0)", "--answer", "10, 20"),
    ("check", "planar-2r", "--ik", "--position", "0.5,0.3,0", "--branch", "elbow up", "--answer", "10, 20"),
    ("dof", "6-UPS", "--format", "json"),
    ("dof", "loop 4R", "--tol", "1e-3"),
    ("dof", "--links", "4", "--joints", "3R 1P", "--planar"),
    ("dof", "--links", "n", "--joints", "2R,1C", "--lambda", "6", "-o", "d.json", "--overwrite"),
    ("start", "yim/planar-in-numbers", "--variant", "alice", "-o", "-", "--overwrite"),
    ("start", "yim/planar-in-numbers", "--class", "q.csv", "--overwrite"),
    (
        "check",
        "yim/planar-in-numbers",
        "--part",
        "a1",
        "--answer",
        "[c1 -s1 0 0.4; s1 c1 0 0; 0 0 1 0; 0 0 0 1]",
        "--why",
    ),
    ("check", "yim/planar-in-numbers", "--variant", "alice", "--part", "middle", "--answer", "0.3852 0.3449 0"),
    ("check", "scara", "--q", "10,20,0.1", "--deg", "--set", "l1=1", "--answer", IDENTITY, "--tol-rotation", "0.01"),
    ("check", "scara", "--pose", "zero", "--answer", IDENTITY, "--tol-position", "0.5mm", "--decimals", "3"),
    (
        "check",
        "puma560",
        "-s",
        "--from",
        "4",
        "--to",
        "6",
        "--answer",
        "c5c6 -c5s6 -s5 0; s6 c6 0 0; s5c6 -s5s6 c5 0; 0 0 0 1",
    ),
    ("check", "planar-2r", "--table", "robot.yaml", "--format", "json", "-o", "m.json", "--overwrite"),
    ("check", "planar-2r", "--table", "robot.yaml", "--compare", "same-motion"),
    ("check", "planar-2r", "--frames", "robot.yaml", "--pose", "zero", "--why"),
    ("sweep", "planar-2r", "--over", "theta1 n 3", "--draw", "reach.svg", "--overwrite"),
    ("draw", "planar-2r", "--to", "fold", "--animate", "-o", "move.svg", "--overwrite"),
    ("draw", "planar-2r", "--in", "two.csv", "-o", "strip.svg", "--overwrite"),
    ("draw", "planar-2r", "--rows", "two.csv", "-o", "strip.svg", "--overwrite"),
    ("check", "planar-2r", "--table", "robot.yaml", "--compare", "same-motion", "--draw", "over.svg", "--overwrite"),
    ("watch", "yim/planar-in-numbers", "sheet.yaml", "--variant", "x", "--why"),
    ("hint", "yim/planar-in-numbers", "--part", "t02", "--variant", "bob"),
    ("solution", "yim/planar-in-numbers", "--part", "t02", "--yes", "--variant", "bob"),
    (
        "grade",
        "class",
        "--exercise",
        "yim/planar-in-numbers",
        "--jobs",
        "1",
        "--timeout",
        "20",
        "--format",
        "json",
        "-o",
        "g.json",
    ),
    ("show", "puma560", "--format", "latex", "-o", "p.tex", "--overwrite"),
    ("show", "yim/planar-in-numbers", "--variant", "alice"),
    ("list", "robots", "--format", "csv", "-o", "l.csv", "--overwrite"),
    ("lint", "robot.yaml", "exercise.yaml", "--format", "json", "-o", "lint.json", "--overwrite"),
    ("new", "robot", "arm", "--convention", "modified", "--joints", "RRP", "-o", "-"),
    ("new", "exercise", "course/first", "--robot", "planar-2r", "--output", "-", "--overwrite"),
    ("new", "linkage", "press", "--form", "bars", "-o", "-"),
    ("new", "linkage", "press", "--form", "joints", "-o", "press.yaml", "--overwrite"),
    ("new", "robot", "arm", "-o", "arm.yaml", "--overwrite"),
    ("schema", "linkage"),
    ("schema", "robot", "-o", "robot.schema.json", "--overwrite"),
    ("new", "robot", "--from", "table.csv", "--convention", "standard", "--joints", "RR", "--units", "mm", "-o", "-"),
    ("new", "robot", "--from", "arm.urdf", "--base", "base_link", "--tip", "hand", "--as-typed", "-o", "-"),
    ("sweep", "planar-2r", "--over", "theta1 n 3", "--q", "theta2=0", "-o", "t.csv", "--overwrite"),
    ("transform", "Rot(z,a)", "-o", "t.json", "--overwrite"),
    ("grade", "class", "-o", "c.csv", "--overwrite"),
    ("help", "student"),
)
"""A line for every option of every command; a test makes sure that none is left out."""

FILES: dict[str, tuple[str, tuple[tuple[str, ...], ...]]] = {
    "robot": (
        "robots/planar-2r.yaml",
        (("show", "./x.yaml"), ("fk", "./x.yaml", "-s"), ("lint", "x.yaml"), ("dof", "x.yaml")),
    ),
    "product": ("robots/scara.yaml", (("show", "./x.yaml"), ("fk", "./x.yaml", "--pose", "pick"), ("lint", "x.yaml"))),
    "modified": (
        "robots/puma560.yaml",
        (
            ("fk", "./x.yaml", "-s", "--format", "numpy"),
            ("check", "puma560", "--table", "x.yaml"),
            ("check", "puma560", "--frames", "x.yaml"),
        ),
    ),
    "motors": (
        "tests/data/coupled/two-and-three.yaml",
        (("fk", "./x.yaml", "--motors", "-s"), ("describe", "./x.yaml", "--as", "motors"), ("show", "./x.yaml")),
    ),
    "urdf": (
        "tests/data/urdf/three-joints.urdf",
        (("fk", "./x.urdf", "--q", "0,0,0"), ("describe", "./x.urdf", "--as", "standard"), ("show", "./x.urdf")),
    ),
    "listing": ("tests/data/foreign/four-links.m", (("new", "robot", "--from", "x.m", "-o", "-"), ("fk", "x.m"))),
    "page": ("tests/data/foreign/craig.md", (("new", "robot", "--from", "x.md", "-o", "-"),)),
    "paper": ("tests/data/foreign/scara.tex", (("new", "robot", "--from", "x.tex", "-o", "-"),)),
    "kinematics": (
        "tests/data/foreign/ur5e-kinematics.yaml",
        (("new", "robot", "--from", "x.yaml", "-o", "-"), ("show", "./x.yaml")),
    ),
    "linkage": ("robots/linkages/planar-four-bar.yaml", (("show", "./x.yaml"), ("dof", "x.yaml"), ("lint", "x.yaml"))),
    "spatial": ("robots/linkages/bennett.yaml", (("dof", "x.yaml", "--format", "json"),)),
    "exercise": (
        "exercises/yim/planar-in-numbers.yaml",
        (("show", "./x.yaml"), ("lint", "x.yaml"), ("start", "./x.yaml", "-o", "-"), ("solution", "./x.yaml", "--yes")),
    ),
    "table": (
        "exercises/wpi/puma560-table.yaml",
        (("solution", "./x.yaml", "--yes"), ("start", "./x.yaml", "--variant", "a")),
    ),
    "counts": ("exercises/yim/counting-freedoms.yaml", (("solution", "./x.yaml", "--yes"), ("show", "./x.yaml"))),
    "sheet": (
        "tests/data/class/student-1/planar.yaml",
        (
            ("check", "yim/planar-in-numbers", "x.yaml"),
            ("check", "yim/planar-in-numbers", "x.yaml", "--why", "--format", "json"),
        ),
    ),
}
"""A file of each kind, and the commands that read it."""

ROWS: dict[str, bytes] = {
    "q.csv": b"theta1[deg], theta2 [rad], d3[mm], note\n10,0.5,100,a\n20,0.6,-50,b\n",
    "q2.csv": b"sep=;\n0,1;0,2;0,3\n1;2;3\n",
    "one.csv": b"d3[mm];theta1[deg];theta2\n100;30;0,5\n",
    "q.jsonl": b'{"theta1": 0.1, "theta2": 0.2, "d3": 0.3}\n[1, 2, 3]\n',
    "q.npy": b"\x93NUMPY\x01\x00v\x00{'descr': '<f8', 'fortran_order': False, 'shape': (1, 3), }"
    + b" " * 58
    + b"\n"
    + b"\0" * 24,
}


POSES: dict[str, bytes] = {
    "p.csv": b"p_x,p_y,p_z,roll,pitch,yaw\n-0.2321,0.4259,0.3,0,0,0.8\n",
    "m.csv": b"r11;r12;r13;p_x;r21;r22;r23;p_y;r31;r32;r33;p_z\n1;0;0;0,3;0;1;0;0,2;0;0;1;0,3\n",
    "a.csv": b"axis_x axis_y axis_z angle[deg] p_x[cm] p_y p_z\n0 0 2 90 30 0.2 0.3\n",
    "p.jsonl": b'{"position": [0.3, 0.2, 0.3], "quaternion": {"w": 1, "x": 0, "y": 0, "z": 0}}\n{"position": [0.3, 0.2, 0.3]}\n',
    "p.npy": ROWS["q.npy"],
}


@dataclass(frozen=True)
class Case:
    """A command line with what it finds in its folder and on standard input."""

    words: tuple[str, ...]
    files: dict[str, bytes] = field(default_factory=dict)
    stdin: str = ""


def cases(door: str, count: int, seed: str) -> Iterator[Case]:
    """So many cases at a door, the same for the same seed."""
    for number in range(count):
        chance = random.Random(f"{seed}/{door}/{number}")  # noqa: S311  nothing is kept secret
        yield DOORS[door](chance)


def _line(chance: random.Random) -> Case:
    words = list(chance.choice(LINES))
    at = chance.randrange(1, len(words))
    words[at] = mutated(words[at], chance)
    poses = b"p_x,p_y,p_z,roll,pitch,yaw\n-0.2321,0.4259,0.3,0,0,0.8\n"
    files = {
        "q.csv": ROWS["q.csv"],
        "poses.csv": poses,
        "two.csv": b"theta1,theta2\n0.1,0.2\n0.3,0.4\n",
        "robot.yaml": source("robot"),
        "exercise.yaml": source("exercise"),
    }
    files |= {"motors.yaml": source("motors")}
    files |= {"arm.urdf": source("urdf"), "table.csv": b"a,alpha [deg],d,theta\n300,90,0,q1\n200,0,0,q2*\n"}
    files |= {"class/one/s.yaml": source("sheet"), "sheet.yaml": source("sheet")}
    return Case(tuple(word.replace("\0", "") for word in words), files, chance.choice(("", IDENTITY)))


def _file(chance: random.Random) -> Case:
    kind = chance.choice(sorted(FILES))
    words = chance.choice(FILES[kind][1])
    content = source(kind)
    name = f"x{Path(FILES[kind][0]).suffix}"
    if chance.random() < 0.1:
        return Case(words, {name: mutated_bytes(content, chance)})
    return Case(words, {name: mutated(content.decode(), chance).encode("utf-8", "surrogatepass")})


def _spoilt(files: Mapping[str, bytes], chance: random.Random) -> tuple[str, bytes]:
    """One of some files of rows, with something in it changed."""
    name = chance.choice(sorted(files))
    if name.endswith(".npy") or chance.random() < 0.2:
        return name, mutated_bytes(files[name], chance)
    return name, mutated(files[name].decode(), chance).encode("utf-8", "surrogatepass")


def _rows(chance: random.Random) -> Case:
    name, content = _spoilt(ROWS, chance)
    more = chance.choice(((), ("--deg",), ("--skip-bad", "--ignore-columns"), ("--as", "rpy", "--format", "jsonl")))
    lines = [("fk", "scara", "--rows", name, *more)] * 2
    lines += [("jacobian", "scara", "--rows", name, "--skip-bad"), ("fk", "scara", "--q", f"@{name}")]
    return Case(chance.choice(lines), {name: content})


def _poses(chance: random.Random) -> Case:
    name, content = _spoilt(POSES, chance)
    more = chance.choice(((), ("--skip-bad",), ("--task", "position"), ("--skip-bad", "--follow", "--near", "zero")))
    return Case(("ik", "scara", "--rows", name, *more), {name: content})


def _answer(chance: random.Random) -> Case:
    words = list(chance.choice([line for line in LINES if "--answer" in line]))
    at = words.index("--answer") + 1
    text = mutated(mutated(words[at], chance), chance)
    words[at] = "-"
    return Case(tuple(words), stdin=text.encode("utf-8", "replace").decode())


def _moves(chance: random.Random) -> Case:
    return Case(
        ("transform", mutated(mutated("Trans(8,-6,14) Rot(y,90°) Rot(z,a)^-1", chance), chance).replace("\0", ""))
    )


def _freedoms(chance: random.Random) -> Case:
    pattern = chance.choice(("6-UPS", "loop 4R", "3-RRR planar", "2R1P", "RRRP", "20 pin 4 slot"))
    return Case(("dof", mutated(mutated(pattern, chance), chance).replace("\0", "")))


DOORS = {
    "words": _line,
    "files": _file,
    "rows": _rows,
    "poses": _poses,
    "answers": _answer,
    "moves": _moves,
    "freedoms": _freedoms,
}


def source(kind: str) -> bytes:
    """The valid file of a kind."""
    (path,) = ROOT.glob(FILES[kind][0])
    return path.read_bytes()
