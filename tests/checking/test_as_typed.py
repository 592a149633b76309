"""Answers as tired people type and paste them: from spreadsheets, from Word, from slides, from a phone.

Each stands here with one slip in it as well: a spelling that is read must not make a wrong answer right.
"""

from __future__ import annotations

from functools import cache

import pytest

from dhcli.checking.judge import Judge
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.files.yaml.exercises import load_exercise
from tests.row_by_row import row_by_row

ARM, LINK = "yim/planar-two-links", "yim/dh-factors"
FORMULAS, VALUES, REACH = "inverse/planar-joints", "inverse/planar-joints-in-numbers", "inverse/planar-reach"
COUNTS, TABLE = "yim/counting-freedoms", "zhou/three-r-arm-tip"
JACOBIAN, ELBOW = "motion/planar-jacobian", "motion/articulated-jacobian"
MODIFIED, SCARA, CHANGE = "zhou/modified-link-matrix", "motion/scara-jacobian", "motion/differential-motion"
DOT = "\u2061"  # what Word has between a function and its argument


@cache
def judge(exercise: str) -> Judge:
    """The judge of an exercise, once."""
    return Judge(load_exercise(exercise))


def told(exercise: str, part: str, answer: str) -> Mark:
    """An answer judged."""
    found = judge(exercise)
    return found.mark(found.exercise.part(part), answer)


READ = [
    (ARM, "a1", "c1\t-s1\t0\ta1 c1\ns1\tc1\t0\ta1 s1\n0\t0\t1\t0\n0\t0\t0\t1", ("a1 s1", "a1 c1")),
    (ARM, "a1", "(c1 -s1 0 a1c1)\n(s1 c1 0 a1s1)\n(0 0 1 0)\n(0 0 0 1)", ("a1s1", "a1c1")),
    (ARM, "a1", "(c1 -s1 0 a1c1\n s1 c1 0 a1s1\n 0 0 1 0\n 0 0 0 1)", ("a1s1", "a1c1")),
    (ARM, "a1", "COS(θ1) -SIN(θ1) 0 a1*COS(θ1); SIN(θ1) COS(θ1) 0 a1*SIN(θ1); 0 0 1 0; 0 0 0 1", ("a1*SIN", "a1*COS")),
    (
        ARM,
        "a1",
        (
            f"[■(cos{DOT}θ_1&-sin{DOT}〖θ_1 〗&0&a_1 cos{DOT}θ_1@"
            f"sin{DOT}θ_1&cos{DOT}θ_1&0&a_1 sin{DOT}θ_1@0&0&1&0@0&0&0&1)]"
        ),
        (f"a_1 sin{DOT}θ_1", f"a_1 cos{DOT}θ_1"),
    ),
    (ARM, "t02", "c_{1+2} -s_{1+2} 0 a1c1+a2c_{1+2}; s12 c12 0 a1s1+a2s_{1+2}; 0 0 1 0; 0 0 0 1", ("a2s_", "a2c_")),
    (ARM, "d02", "a1 c1 + a2 c12\ta1 s1 + a2 s12\t0", ("s12", "c12")),
    (ARM, "d02", "P(a1 c1 + a2 c12, a1 s1 + a2 s12, 0)", ("s12", "c12")),
    (ARM, "d02", "1. a1 c1 + a2 c12\n2. a1 s1 + a2 s12\n3. 0", ("s12", "c12")),
    (ARM, "d02", "1) a1 c1 + a2 c12\n2) a1 s1 + a2 s12\n3) 0", ("s12", "c12")),
    (JACOBIAN, "column1", "1. -a1*s1 - a2*s12; 2. a1*c1 + a2*c12; 3. 0", ("c12", "s12")),
    ("bajd/rotate-a-vector", "w", "1. -6\n2. 14\n3. 0", ("-6", "6")),
    ("bajd/rotate-a-vector", "w", "-6.\n14.\n0.", ("-6", "6")),
    (ARM, "d02", "x: a1c1 + a2c12, y: a1s1 + a2s12, z: 0", ("s12", "c12")),
    ("bajd/rotate-a-vector", "w", "-6 i + 14 j + 0 k", ("-6", "6")),
    ("bajd/rotate-a-vector", "w", "-6i + 14j + 0k", ("-6", "6")),
    ("bajd/rotate-a-vector", "w", "<-6, 14, 0>", ("-6", "6")),
    ("bajd/order-of-displacements", "post", "HD", ("HD", "DH")),
    ("wpi/puma560-actuators", "joints", "4,5,6", ("4,5,6", "1,2,3")),
    ("motion/planar-jacobian", "singular", "θ2 = 0°/180°", ("0°/180°", "90°/-90°")),
    ("motion/planar-jacobian", "singular", "θ2 = 0/π", ("0/π", "90°/270")),
    ("motion/planar-jacobian", "singular", "sin(θ2) = 0°/2", ("sin", "cos")),
    ("yim/dh-process", "against", "a1c1+a2c_{1-2}, a1s1+a2s_{1-2}, d1-d2", ("s_{1-", "s_{1+")),
    (
        ARM,
        "d02",
        r"\left\{\begin{array}{l} x = a_1 c_1 + a_2 c_{12} \\ y = a_1 s_1 + a_2 s_{12} \\ z = 0 \end{array}\right.",
        ("+ a_2 s", "- a_2 s"),
    ),
    (
        ARM,
        "d02",
        r"\begin{cases} y = a_1 s_1 + a_2 s_{12} \\ x = a_1 c_1 + a_2 c_{12} \\ z = 0 \end{cases}",
        ("+ a_2 s", "- a_2 s"),
    ),
    (FORMULAS, "elbow", "θ_2=±〖cos〗^(-1)\u2061((p_x^2+p_y^2-a_1^2-a_2^2)/(2a_1 a_2 ))", ("-a_2^2", "+a_2^2")),
    (
        "bajd/scara-pose-in-m",
        "t03",
        "SE3:  0.766  -0.6428  0  0.0435\n 0.6428  0.766  0  0.399\n 0  0  1  0.25\n 0  0  0  1",
        ("0.25", "0.35"),
    ),
    ("bajd/elementary-rotations", "rot_x", "1 0 0 0\n0 ca -sa 0\n0 sa ca 0\n0 0 0 1", ("0 sa ca", "0 -sa ca")),
    ("bajd/elementary-rotations", "cosines", "1 0 0; 0 ca -sa; 0 sa ca", ("-sa", "-sb")),
    ("bajd/elementary-rotations", "rot_z", "cg -sg 0 0; sg cg 0 0; 0 0 1 0; 0 0 0 1", ("cg -sg", "ca -sa")),
    ("bajd/elementary-rotations", "rot_y", "cb 0 sb 0; 0 1 0 0; -sb 0 cb 0; 0 0 0 1", ("cb 0 sb", "ca 0 sb")),
    (ARM, "table", "a = a1, α = 0, d = 0, θ = θ1; a = a2, α = 0, d = 0, θ = θ2", ("a = a2", "a = a1")),
    (
        ARM,
        "table",
        "DHLink(a=a1, alpha=0, d=0, theta=theta1)\nDHLink(a=a2, alpha=0, d=0, theta=theta2)",
        ("a=a2", "a=a1"),
    ),
    (
        "zhou/three-r-arm-modified",
        "frames",
        "(0,0,0), +X, +Z\n(0,0,0), +X, +Z\n(a,0,0), +X, +Z\n(a+b,0,0), +X3, +Y",
        ("+Y", "+Z"),
    ),
    (ARM, "table", "Joint 1: θ = θ1, d = 0, a = a1, α = 0\nJoint 2: θ = θ2, d = 0, a = a2, α = 0", ("a2", "a1")),
    (ARM, "table", "a=a1; α=0; d=0; θ=θ1\na=a2; α=0; d=0; θ=θ2", ("a2", "a1")),
    (ARM, "table", "link1: a1, 0, 0, θ1\nlink 2: a2, 0, 0, θ2", ("a2", "a1")),
    (ARM, "table", "1: a1, 0, 0, θ1\n2: a2, 0, 0, θ2", ("a2", "a1")),
    ("yim/articulated-arm", "table", "[[0,90°,d1,theta1],[a2,0,0,theta2],[a3,0,0,theta3]]", ("90", "-90")),
    (ARM, "table", "1. a1, 0, 0, θ1\n2. a2, 0, 0, θ2", ("a2", "a1")),
    (ARM, "table", "1: a1 0 0 θ1\n2: a2 0 0 θ2", ("a2", "a1")),
    (ARM, "blocks", "option 1", ("1", "2")),
    (ARM, "blocks", "Answer: a)", ("a)", "b)")),
    (ARM, "blocks", "#1", ("1", "2")),
    (ARM, "blocks", "①", ("①", "②")),
    (LINK, "order", "Rot(z,θᵢ)·Trans(0,0,dᵢ)·Trans(aᵢ,0,0)·Rot(x,αᵢ)", ("Rot(x", "Rot(y")),
    (LINK, "order", "Rot(z,θi), Trans(0,0,di), Trans(ai,0,0), Rot(x,αi)", ("Rot(x", "Rot(y")),
    (LINK, "order", "Rot(z,θi) → Trans(0,0,di) → Trans(ai,0,0) → Rot(x,αi)", ("Rot(x", "Rot(y")),
    (LINK, "order", "1. Rot(z,θi)\n2. Trans(0,0,di)\n3. Trans(ai,0,0)\n4. Rot(x,αi)", ("Rot(x", "Rot(y")),
    (LINK, "order", "Rot_{z,θ_i} Trans_{z,d_i} Trans_{x,a_i} Rot_{x,α_i}", ("Rot_{x", "Rot_{y")),
    (LINK, "order", "Rot(z_{i-1}, θ_i) Trans(z_{i-1}, d_i) Trans(x_i, a_i) Rot(x_i, α_i)", ("Rot(x_i", "Rot(z_i")),
    (
        LINK,
        "link",
        "cθᵢ −sθᵢcαᵢ sθᵢsαᵢ aᵢcθᵢ\nsθᵢ cθᵢcαᵢ −cθᵢsαᵢ aᵢsθᵢ\n0 sαᵢ cαᵢ dᵢ\n0 0 0 1",
        ("aᵢsθᵢ", "aᵢcθᵢ"),
    ),
    (LINK, "link", "ci -si*cαi si*sαi ai*ci; si ci*cαi -ci*sαi ai*si; 0 sαi cαi di; 0 0 0 1", ("ai*si", "ai*ci")),
    *(
        (MODIFIED, "corner", answer, ("a", "2a"))
        for answer in ("ai-1", "a_i-1", "a(i-1)", "a_(i-1)", "a[i-1]", "aᵢ₋₁", "a_{i−1}", "a_i−1")
    ),
    (
        MODIFIED,
        "matrix",
        "cθi -sθi 0 ai-1; sθicαi-1 cθicαi-1 -sαi-1 -disαi-1; sθisαi-1 cθisαi-1 cαi-1 dicαi-1; 0 0 0 1",
        ("dicαi-1", "disαi-1"),
    ),
    *(
        (SCARA, "first", answer, ("l3", "l2"))
        for answer in (
            "-l2 c1 - l3 c12\n-l2 s1 - l3 s12\n0\n0\n0\n1",
            "-l2 c1 - l3 c12; -l2 s1 - l3 s12; 0; 0; 0; 1",
            r"\begin{bmatrix} -l_2 c_1 - l3 c_{12} \\ -l_2 s_1 - l3 s_{12} \\ 0 \\ 0 \\ 0 \\ 1 \end{bmatrix}",
            "v = (-l2c1-l3c12, -l2s1-l3s12, 0), ω = (0, 0, 1)",
            "-l2c1-l3c12, -l2s1-l3s12, 0\n0, 0, 1",
        )
    ),
    (CHANGE, "base", "-8.66x10^-3, -5x10^-3, 0, -4.062 x 10⁻³; 0,0,10^-2,0; 0,0,0,10^-3; 0,0,0,0", ("-4", "-6")),
    *(("yim/scara-in-numbers", "turn", f"{about}60°", ("60", "61")) for about in ("ca. ", "about ", "~", "≈ ")),
    (COUNTS, "gruebler", "λ(N - J - 1) + J f", ("- 1", "+ 1")),
    (COUNTS, "gruebler", "lambda (N-1-j) + j.f", ("-1", "-2")),
    (JACOBIAN, "column1", "-A1 S1 - A2 S12; A1 C1 + A2 C12; 0", ("A1 C1", "A2 C1")),
    (JACOBIAN, "column1", "-L1 S1 - L2 S12; L1 C1 + L2 C12; 0", ("L1 C1", "L2 C1")),
    (JACOBIAN, "column1", "-l_1 s_1 - l_2 s_{12}; l1c1 + l2c12; 0", ("l1c1", "l2c1")),
    (JACOBIAN, "column1", "-a1 sin t1 - a2 sin(t1+t2); a1 cos t1 + a2 cos(t1+t2); 0", ("cos t1", "cos t2")),
    (JACOBIAN, "column1", "-a1.sin th1 - a2.s(th12); a1.cos th1 + a2.c(th12); 0", ("cos th1", "cos th2")),
    (JACOBIAN, "singular", "θ2 ∈ {0, π}", ("π", "π/2")),
    (JACOBIAN, "singular", "θ2 = nπ, n ∈ ℤ", ("θ2", "θ1")),
    (JACOBIAN, "singular", "sin(θ2) = 0, i.e. θ2 = 0 or π", ("sin(θ2)", "sin(θ1)")),
    (JACOBIAN, "singular", "sin(θ2) = 0 ⇒ θ2 = 0 or π", ("0 or π", "0")),
    (JACOBIAN, "singular", "θ2 ∈ {0, π}, i.e. s2 = 0", ("s2", "c2")),
    (ELBOW, "singular", "s3 = 0, i.e. θ3 = 0 or 180°, a2*c2 + a3*c23 = 0", ("0 or 180°", "0°")),
    (ELBOW, "singular", "a2*c2 + a3*c23 = 0, s3 = 0 => θ3 = 0 or π", ("0 or π", "π")),
    (FORMULAS, "elbow", "±acos(D) where D = (r² - a1² - a2²)/(2a1a2) and r² = px² + py²", ("+ py²", "- py²")),
    (JACOBIAN, "singular", r"\theta_2 \in \{0, \pi\}", ("2", "1")),
    (JACOBIAN, "singular", "theta2 in {0°, 180°}", ("180", "90")),
    (FORMULAS, "elbow", "±acos((r^2 - a1^2 - a2^2)/(2 a1 a2)) where r^2 = px^2 + py^2", ("- a2^2", "+ a2^2")),
    (FORMULAS, "elbow", "r² = px²+py²; t2 = ±acos((r² - a1² - a2²)/(2a1a2))", ("- a2²", "+ a2²")),
    (FORMULAS, "elbow", "plus or minus acos((px^2+py^2-A1^2-A2^2)/(2 A1 A2))", ("-A2^2", "+A2^2")),
    (FORMULAS, "elbow", "±cos⁻¹((px²+py²-a1²-a2²)/(2a1a2))", ("-a2²", "+a2²")),
    (FORMULAS, "elbow", r"±\cos^{-1}\left(\frac{px^2+py^2-a1^2-a2^2}{2a1a2}\right)", ("-a2^2", "+a2^2")),
    (FORMULAS, "elbow", "theta2 = ±cos^(-1)(D), D = (px^2+py^2-a1^2-a2^2)/(2a1a2)", ("-a2^2", "+a2^2")),
    (FORMULAS, "elbow", "±ACOS((px^2+py^2-a1^2-a2^2)/(2*a1*a2))", ("-a2^2", "+a2^2")),
    (FORMULAS, "elbow", "±arccos((pₓ² + p_y² − a₁² − a₂²)/(2·a₁·a₂))", ("2·a", "3·a")),
    (FORMULAS, "shoulder", "Atan2(py,px)-Atan2(a2s2,a1+a2c2)", ("py,px", "px,py")),
    (FORMULAS, "shoulder", "A1 = a1 + a2*c2; atan2(py, px) - atan2(a2*s2, A1)*a1/a1", ("+ a2", "- a2")),
    (FORMULAS, "shoulder", "A1 = a1 + a2*c2; A2 = A1 - a1; atan2(py, px) - atan2(a2*s2, a1 + A2)", ("- a1", "- a2")),
    (VALUES, "all", "[2.48 59.45; 67.98 -67.98]^T", ("-67.98", "66.98")),
    (VALUES, "all", "[2.48 67.98]^T, [59.45 -67.98]^T", ("-67.98", "67.98")),
    (VALUES, "all", "[2.48; 67.98], [59.45; -67.98]", ("-67.98", "67.98")),
    (VALUES, "all", "(2.48 67.98)\n(59.45 -67.98)", ("-67.98", "67.98")),
    (VALUES, "any", "2°28′38″, 67°58′33″", ("67°", "66°")),
    (VALUES, "any", "t1 = 2° 28', t2 = 67° 58'", ("67°", "66°")),
    (VALUES, "any", "(2.48°|67.98°)", ("67.98", "66.98")),
    (VALUES, "any", "q = (2.48, 67.98)°", ("67.98", "66.98")),
    (VALUES, "all", "1. 2.48° 67.98°\n2. 59.45° -67.98°", ("-67.98", "67.98")),
    (VALUES, "all", "| θ1 | θ2 |\n|---|---|\n| 2.48 | 67.98 |\n| 59.45 | -67.98 |", ("-67.98", "67.98")),
    (VALUES, "all", "θ2 θ1\n67.98 2.48\n-67.98 59.45", ("θ2 θ1", "θ1 θ2")),
    (VALUES, "all", "{(2.48, 67.98), (59.45, -67.98)}", ("-67.98", "67.98")),
    (REACH, "inside", "it is reachable", ("reachable", "not reachable")),
    (REACH, "ways", "2 solutions", ("2", "1")),
    (REACH, "ways", "two ways", ("two", "three")),
    (COUNTS, "sixr", "6 DOF", ("6", "5")),
    (COUNTS, "sixr", "DoF: 6", ("6", "5")),
    (COUNTS, "sixr", "six degrees of freedom.", ("six", "five")),
    (COUNTS, "sixr", "=6", ("6", "5")),
    (COUNTS, "links", "7 links", ("7", "6")),
    (TABLE, "table", "a 0 0 θ1\nb -PI()/2 0 θ2\n0 0 0 θ3", ("-PI", "PI")),
    (JACOBIAN, "determinant", "|J| = a1 a2 s2", ("s2", "c2")),
    ("wpi/puma560-entries-of-0t6", "px", "(c1 (a2 c2 + a3 c23 - d4 s23) - d3 s1)", ("d3", "d4")),
    (JACOBIAN, "whole", "-a1 s1 - a2 s12\t-a2 s12\na1 c1 + a2 c12\ta2 c12\n0\t0\n0\t0\n0\t0\n1\t1", ("1\t1", "1\t0")),
]


@row_by_row(("exercise", "part", "answer", "slip"), READ)
def test_an_answer_is_read_as_it_is_typed(exercise: str, part: str, answer: str, slip: tuple[str, str]) -> None:
    """And with a slip in it it is wrong."""
    mark = told(exercise, part, answer)
    assert mark.verdict is Verdict.RIGHT, mark
    right, wrong = slip
    before, found, behind = answer.rpartition(right)
    assert found
    assert told(exercise, part, f"{before}{wrong}{behind}").verdict in (Verdict.WRONG, Verdict.CLOSE)


@row_by_row(
    ("exercise", "part", "answer", "said"),
    [
        (ARM, "a1", "Rot(z,θ1) Trans(a1,0,0)", "these are moves; what they make was asked, number by number"),
        (ARM, "blocks", "1 or 2", "choose a number from 1 to 4"),
        (FORMULAS, "elbow", "acos((px²+py²-a1²-a2²)/2a1a2)", "can be read in two ways (write a/(2*a1a2) or a/2*a1a2)"),
        (FORMULAS, "elbow", "cos⁻¹(θ1)", "cos to a negative power can be read in two ways"),
        (FORMULAS, "elbow", "cos^{-1}(θ1)", "cos to a negative power can be read in two ways"),
        (FORMULAS, "elbow", "±1/cos(D), D = px/py", "D stands inside a cosine or sine: write there what it is made of"),
        (FORMULAS, "elbow", "s = sin(D); D = px/py; acos(s)", "D stands inside a cosine or sine"),
        (FORMULAS, "elbow", "cos⁻¹(0.5)", "cos to a negative power can be read in two ways"),
        (FORMULAS, "shoulder", "ATAN2(px,py)", "a spreadsheet has x first: write atan2(y, x)"),
        (REACH, "ways", "2 or 4 solutions", "a number of solutions is a whole number"),
        (VALUES, "all", "[2.48 67.98; 59.45 -67.98]^T", "right without the sign of a transposition"),
        (VALUES, "all", "[2.48 59.45; 67.98 -67.98]", "right if the columns are the solutions"),
        (VALUES, "all", "2.48 59.45\n67.98 -67.98", "right if the columns are the solutions"),
        (JACOBIAN, "singular", "θ1, θ2 ∈ {0, π}", "theta1 stands without a value before theta2"),
        (JACOBIAN, "singular", "t1, t2 = 0 or 180°", "theta1 stands without a value before theta2"),
        (ARM, "d02", "a1 c1 + a2 c1.2, a1 s1 + a2 s12, 0", "c1.2 may be a name or a product (write c12, or c1*0.2)"),
        ("yim/scara-in-numbers", "turn", "1.05", "right in radians, to the digits typed"),
        (COUNTS, "constraint", "6 - F", "F is not a name that is known here"),
        (COUNTS, "gruebler", "λ(N-n-1) + j f", "N stands beside n: are they the same?"),
        (COUNTS, "gruebler", "λ(n-j-1) + Σf", "(write the sum out, a1 + a2)"),
        (FORMULAS, "elbow", "±acos(r/(2a1a2)); r^2 = px^2 + py^2", "r stands without its square"),
        (JACOBIAN, "column1", "-T1 s1; a1 c1; 0", "T1 is not a name that is known here"),
        (COUNTS, "sixr", "6 apples", "apples"),
        (COUNTS, "sixr", "6 links", "links"),
        (COUNTS, "links", "DoF: 7", "what is asked for is links"),
        (COUNTS, "links", "7 joints", "joints"),
        (REACH, "inside", "yes or no", "write yes or no"),
        (REACH, "ways", "2 joints", "a number of solutions is a whole number"),
        ("bajd/rotate-a-vector", "w", "-6 mm, 14 mm, 0", "entry (1,1): the task names no unit, write a number alone"),
        ("wpi/puma560-entries-of-0t6", "px", "(c1, s1)", "this is a matrix, 1x2; one number was asked"),
        ("motion/articulated-load", "load", "[0, 10.3385, 5.1962] mm", "entry (2,1) is no length: leave its unit out"),
        ("motion/articulated-load", "rates", "[0, 0.12693, 0.13236] m", "entry (2,1) is no length: leave its unit out"),
        ("motion/planar-rates-in-numbers", "turning", "[0, 0, -0.7] cm", "entry (3,1) is no length"),
        (JACOBIAN, "determinant", "a1*a2*s2 m", "is no length: leave its unit out"),
        (JACOBIAN, "determinant", "a1*a2*s2 mm^2", "is no length: leave its unit out"),
    ],
)
def test_what_may_be_meant_in_two_ways_is_asked(exercise: str, part: str, answer: str, said: str) -> None:
    """A question costs no try."""
    mark = told(exercise, part, answer)
    assert mark.verdict is Verdict.CANNOT_READ
    assert said in "; ".join(mark.remarks)


def test_an_arctangent_is_not_blamed_where_none_stands() -> None:
    """A root loses the sign of a cosine, too, and then the angle is half a turn off."""
    root = "±acos(sqrt(D^2)), D = (px^2 + py^2 - a1^2 - a2^2)/(2a1a2)"
    assert told(FORMULAS, "elbow", root).remarks[0].endswith("elsewhere it is half a turn off")
    assert "as atan loses" in told(FORMULAS, "shoulder", "atan(py/px) - atan2(a2 s2, a1 + a2 c2)").remarks[0]


RATES, POSE, TURN = "motion/planar-rates-in-numbers", "bajd/scara-pose-in-m", "inverse/planar-joints-in-numbers"


@pytest.mark.parametrize(
    ("exercise", "part", "answer", "unit"),
    [
        (RATES, "load", "403.65 -31.38 Ncm", "Ncm"),
        (RATES, "load", "4036.5, -313.8 N mm", "N mm"),
        (RATES, "rates", "29.04, -64.64 °/s", "°/s"),
        (POSE, "tool", "43.5, 399, 250 mm", "mm"),
    ],
)
def test_a_unit_behind_the_last_number_alone_is_asked_about(exercise: str, part: str, answer: str, unit: str) -> None:
    """Where the answer is right if it is that of all; a bracket settles it, and another number stays wrong."""
    mark = told(exercise, part, answer)
    said = (
        f"{unit} stands behind the last number alone: if it is that of all, write it behind each, or behind a bracket"
    )
    assert (mark.verdict, mark.remarks) == (Verdict.CANNOT_READ, (said,))
    numbers = answer.strip("()").removesuffix(unit)
    assert (
        told(exercise, part, f"({numbers.strip().replace(' -', ', -').replace(',,', ',')}) {unit}").verdict
        is Verdict.RIGHT
    )
    assert told(exercise, part, f"9{answer.lstrip('(')}").verdict is Verdict.WRONG


def test_a_list_that_is_right_with_one_unit_in_it_is_right() -> None:
    """Metres for two numbers and millimetres for the third; three in millimetres earn half, a unit or not."""
    assert told(POSE, "grip", "81.82, 431.09, 150 mm").other_unit == "mm"
    assert told(POSE, "grip", "0.08182, 0.43109, 150 mm").verdict is Verdict.RIGHT
    assert told(TURN, "any", "2.4773, 67.9757°").verdict is Verdict.RIGHT
