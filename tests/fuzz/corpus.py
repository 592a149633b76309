"""What was once found, by hand or by mutation: every case stays."""

from __future__ import annotations

from tests.fuzz.doors import IDENTITY, Case, source

PARALLEL = 50
_PARALLEL = (
    "format: 1\ntitle: t\nsource: s\nconvention: standard\n"
    f"variables: [{', '.join(f'theta{i}' for i in range(1, PARALLEL + 1))}]\n"
    f"parameters: {{{', '.join(f'a{i}: {i} mm' for i in range(1, PARALLEL + 1))}}}\nlinks:\n"
    + "".join(f"  - {{a: a{i}, alpha: 0, d: 0, theta: theta{i}}}\n" for i in range(1, PARALLEL + 1))
).encode()
_UNVALUED = b"""\
format: 1
title: t
source: s
robot: planar-2r
numeric: true
given: {theta1: 30 deg}
task: x
parts:
  - {id: a, ask: pose 0..2}
  - {id: b, ask: link 1}
"""
_EXERCISE = "format: 1\ntitle: t\nsource: s\nrobot: planar-2r\ntask: x\nparts:\n  - {{id: a, ask: '{ask}'}}\n"
_LOOP = (
    "format: 1\ntitle: t\nsource: s\nspace: planar\nchain: ground "
    + " ".join(f"R l{i}" for i in range(1, 1000))
    + " R ground\n"
).encode()
_SUM = "+".join(f"cos(theta1/{p})" for p in range(2, 117))


def _exercise(ask: str) -> Case:
    return Case(("solution", "./x.yaml", "--yes"), {"x.yaml": _EXERCISE.format(ask=ask).encode()})


def _rows(content: bytes) -> Case:
    return Case(("fk", "scara", "--rows", "q.csv"), {"q.csv": content})


CASES: dict[str, Case] = {
    "check of 50 parallel joints in letters": Case(
        ("check", "./x.yaml", "-s", "--answer", IDENTITY, "--why"), {"x.yaml": _PARALLEL}
    ),
    "check of 50 parallel joints in numbers": Case(
        ("check", "./x.yaml", "--q", ",".join(["0.1"] * PARALLEL), "--answer", IDENTITY, "--why"), {"x.yaml": _PARALLEL}
    ),
    "200 translations in letters": Case(("transform", " ".join(f"Trans(a{i},b{i},c{i})" for i in range(200)))),
    "200 translations in letters, every frame": Case(
        ("transform", " ".join(f"Trans(a{i},b{i},c{i})" for i in range(200)), "--steps")
    ),
    "a name without a value in solution": Case(("solution", "./x.yaml", "--yes"), {"x.yaml": _UNVALUED}),
    "a name without a value in check": Case(
        ("check", "./x.yaml", "--part", "a", "--answer", IDENTITY), {"x.yaml": _UNVALUED}
    ),
    "a pose from a frame to itself": _exercise("pose 0..0"),
    "a division by zero at the values given": Case(
        ("fk", "planar-2r", "--q", "0,0", "--set", "a1=1/(0.4-0.4)"),
    ),
    "tan of a right angle": Case(("transform", "Trans(tan(t),0,0)", "--set", "t=90°")),
    "a joint called elbow-joint": Case(
        ("fk", "./x.yaml", "-s"), {"x.yaml": source("robot").replace(b"theta1", b"elbow-joint")}
    ),
    "4 pin 1 slot": Case(("dof", "4 pin 1 slot")),
    "20,000 joints by hyphen": Case(("dof", "20000-R")),
    "20 joints between two blanks": Case(("dof", "R  " * 20 + "!")),
    "28 empty brackets": Case(("dof", "--links", "3", "--joints", "()" * 28)),
    "a bracket and a blank, repeated": Case(("transform", "a [ " * 2000)),
    "an answer of nothing but brackets": Case(("check", "scara", "-s", "--answer", "(" * 5000)),
    "a power of a power with a unit in --q": Case(("fk", "scara", "--q", "0,0,1e-60^5 m")),
    "a power of a power with a unit in --set": Case(("fk", "scara", "--q", "0,0,0", "--set", "l1=1e-60^5 m")),
    "a power of a power with a unit in --point": Case(("fk", "scara", "--q", "0,0,0", "--point", "1e-60^5 m,0,0")),
    "a power of a power with a unit in --over": Case(("sweep", "scara", "--over", "d3=0..1e-60^5 m step 1")),
    "a power of a power in transform": Case(("transform", "Trans(1e-60^5 m,0,0)")),
    "fractions whose integers pass 4,300 digits": Case(
        ("transform", f"Trans({'+'.join(f'1/{10**300 + i}' for i in range(40))},0,0)")
    ),
    "a range that never ends": Case(
        ("lint", "x.yaml"),
        {"x.yaml": source("exercise").replace(b"variants:", b"variants: " + b"1.. " * 40_000 + b"\n#")},
    ),
    "a row that a matrix does not have": _exercise("entry 4 4 of pose 0..2"),
    "a link of 5,000 digits": _exercise("link " + "9" * 5000),
    "inverse of inverse of, 2,000 times": _exercise("inverse of " * 2000 + "link 1"),
    "a cell of 10,000 digits": _rows(b"theta1,theta2,d3\n" + b"1" * 10_000 + b"x,0,0\n"),
    "a head with 10,000 blanks": _rows(b"theta1" + b" " * 10_000 + b"x,theta2,d3\n0,0,0\n"),
    **{
        f"read as something else: {text}": Case(("transform", f"Trans({text},0,0)"))
        for text in (
            *("400mm/2mm", "0.1 m^-1", "1 m m", "2 m 3", "0x10", "sec(0)", "abs(-3)", "3 km", "nan", "inf"),
            *("factorial(10**7)", "1e60^5"),
        )
    },
    "a format without a name, for a file": Case(("fk", "scara", "-s", "--format", "", "-o", "x.json")),
    "degrees and minutes without a sign": Case(("transform", "Rot(z, 30° 15)")),
    "a number of joints that is none": Case(("dof", "4infR")),
    "1,000 joints in a pattern": Case(("dof", "loop 1000R")),
    "a loop of 1,000 joints": Case(("dof", "./x.yaml"), {"x.yaml": _LOOP}),
    "a power of a power in a file": Case(
        ("show", "./x.yaml"), {"x.yaml": source("robot").replace(b"parameters: {", b"parameters: {zz: 1e-60^5 m, ")}
    ),
    "a power of a power in an answer": Case(("check", "planar-2r", "-s", "--entry", "1,4", "--answer", "1e-60^5 m")),
    "115 terms a cell": Case(
        (
            "check",
            "planar-2r",
            "-s",
            "--answer",
            ";".join([",".join(["+".join(f"cos(theta1/{p})" for p in range(2, 117))] * 4)] * 4),
        )
    ),
}
"""Every finding by what it was."""

SLOW = {
    "check of 50 parallel joints in letters",
    "check of 50 parallel joints in numbers",
    "115 terms a cell",
    "a range that never ends",
}
"""Those of them that nights are for: counting makes them ten times as slow."""
