"""New robot files: commented, and loading as they are, so that there is something to change."""

from __future__ import annotations

from collections.abc import Iterator
from unicodedata import combining, normalize

from dhcli.errors import DhcliError
from dhcli.kinematics.conventions import ORDER, Convention, convention_hint
from dhcli.regex import regex

MOST_JOINTS = 20
NAME = regex(r"[A-Za-z0-9][A-Za-z0-9_-]*")
"""What can be typed in a command and be the name of a file."""
_NO_NAME = regex(r"[^A-Za-z0-9_-]+")
_COUNTED = regex(r"([0-9]{0,2})([RP])")
"""`3R`, which is `RRR`."""


def robot_template(name: str, convention: str, joints: str) -> str:
    """The text of a new robot file.

    Args:
        name: Name of the robot.
        convention: standard, modified or product.
        joints: The joints as letters, R for revolute and P for prismatic, such as RRP.

    Raises:
        DhcliError: The name, the convention or the joints cannot be.
    """
    check_name(name)
    letters = _letters(joints)
    written = _convention(convention)
    rows = "\n".join(_rows(written, letters))
    variables = ", ".join(_variable(letter, i) for i, letter in enumerate(letters, 1))
    lengths = ", ".join(f"{n}: 0.3 m" for n in _lengths(written, letters))
    zeros = ", ".join("0" for _ in letters)
    limits = "".join(f"  {_variable(r, i)}: {_limits(r)}\n" for i, r in enumerate(letters, 1))
    order = ORDER[written].removeprefix("A_i = ")
    return f"""\
# A robot for dhcli. Change what differs; `dhcli show {name}` draws the table, `dhcli fk {name} --symbolic` the pose.

format: 1
title: {name} ({letters})
source: write here where the numbers come from; these are example values

# {_ABOUT[written]}
# The order of the moves of a link: {order}
convention: {written.value}

# Joint variables in order: an angle stands in a theta, a displacement in a d. All other names are parameters.
variables: [{variables}]

# Lengths with their unit: mm, cm, m, in. Leave a value out, `{{a1: }}`, to keep it open; then --set a1=0.4 gives it.
parameters: {{{lengths}}}

# Angles have a unit, 90° or 1.57 rad; offsets and signs are expressions: theta2 - 90°, -d3.
links:
{rows}

# Beyond these dhcli warns.
limits:
{limits}
# Joint values by name, for --pose.
poses:
  zero: [{zeros}]

# Where the first frame stands in the world, and where the tool is in the last frame; uncomment if you need them.
# base: Trans(0, 0, 0.5)
# tool: Trans(0, 0, 0.1)
"""


def check_name(name: str, what: str = "a robot") -> None:
    """Make sure that a name can be typed in a command and be the name of a file.

    Args:
        name: The name.
        what: What has it.

    Raises:
        DhcliError: It cannot.
    """
    if not NAME.fullmatch(name):
        plain = "".join(letter for letter in normalize("NFKD", name) if not combining(letter))
        meant = "-".join(part for part in _NO_NAME.split(plain.removesuffix(".yaml")) if part)
        such = f"such as {meant}" if NAME.fullmatch(meant) else "such as my-own"
        raise DhcliError(
            f"{name!r} cannot be the name of {what}", f"write letters from a to z, digits, - and _, {such}"
        )


_ABOUT = {
    Convention.STANDARD: "Standard DH: frame i stands at the far end of link i. Columns a_i, alpha_i, d_i, theta_i.",
    Convention.MODIFIED: "Modified DH (Craig): frame i stands at joint i. Columns a_{i-1}, alpha_{i-1}, d_i, theta_i.",
    Convention.PRODUCT: "Products: each line is what leads from one frame to the next, read from left to right.",
}


def _letters(joints: str) -> str:
    letters = joints.strip().upper()
    if not letters or set(letters) - {"R", "P"}:
        meant = "".join(letter * min(int(count or 1), MOST_JOINTS) for count, letter in _COUNTED.findall(letters))
        hint = f"R is revolute, P is prismatic: --joints {meant or 'RRP'}"
        raise DhcliError(f"{joints!r} is not a row of joints", hint)
    if len(letters) > MOST_JOINTS:
        raise DhcliError(
            f"{len(letters)} joints are more than {MOST_JOINTS}", "write a shorter row and add links by hand"
        )
    return letters


def _convention(word: str) -> Convention:
    known = [convention.value for convention in Convention]
    if word not in known:
        raise DhcliError(f"there is no convention {word}", convention_hint(word, known))
    return Convention(word)


def _variable(letter: str, number: int) -> str:
    return f"{'theta' if letter == 'R' else 'd'}{number}"


def _limits(letter: str) -> str:
    return "[-180°, 180°]" if letter == "R" else "[0 m, 0.5 m]"


def _lengths(convention: Convention, letters: str) -> Iterator[str]:
    """The lengths that the rows use."""
    stem = "l" if convention is Convention.PRODUCT else "a"
    first = 2 if convention is Convention.MODIFIED else 1
    for number, letter in enumerate(letters, 1):
        if letter == "R" and number >= first:
            yield f"{stem}{number - (convention is Convention.MODIFIED)}"


def _rows(convention: Convention, letters: str) -> Iterator[str]:
    for number, letter in enumerate(letters, 1):
        name = _variable(letter, number)
        if convention is Convention.PRODUCT:
            product = f"Rot(z, {name}) * Trans(l{number}, 0, 0)" if letter == "R" else f"Trans(0, 0, {name})"
            yield f"  - {product}"
            continue
        modified = convention is Convention.MODIFIED
        a = f"a{number - modified}" if letter == "R" and number > modified else "0"
        d, theta = ("0", name) if letter == "R" else (name, "0")
        yield f"  - {{a: {a}, alpha: 0, d: {d}, theta: {theta}}}"
