"""What a file is that is none of dhcli's, by how it begins and what it names; nothing of it is read."""

from __future__ import annotations

import re
from enum import Enum

from dhcli.errors import Place, Problem
from dhcli.files.foreign.heads import heads_of
from dhcli.regex import regex

LARGEST = 100_000
"""Letters of a file that are looked at."""

_FIRST_TAG = regex(r"<(?![?!])\s*(?P<tag>[\w:.-]{1,60})")
_LISTING = regex(r"\b(?:SerialLink|DHRobot|(?:DH)?Link|link|(?:Revolute|Prismatic)(?:M?DH)?)\([^\n]{0,200}[\d'=\[]")
_RESULT = regex(r"\{\s{0,99}\"dhcli\"\s{0,9}:")
_KINEMATICS = regex(r"^[ \t]{0,40}(?:roll|yaw)[ \t]{0,9}:|\{[^\n{}]{0,200}\broll[ \t]{0,9}:", re.MULTILINE)


class Form(Enum):
    """A form of file, and what it is called."""

    URDF = "a URDF"
    XACRO = "a xacro, a template of a URDF"
    SDF = "an SDF"
    MJCF = "an MJCF of MuJoCo"
    XML = "some XML"
    TABLE = "a DH table as CSV, Markdown or LaTeX"
    LISTING = "a listing of a robotics toolbox"
    KINEMATICS = "a kinematics file of ROS"
    RESULT = "a result for programs"


_TAGS = {"robot": Form.URDF, "sdf": Form.SDF, "mujoco": Form.MJCF}
_IMPORTED = "dhcli new robot --from {file} makes a robot file of it"
_TO_URDF = "dhcli reads URDF: write one from it with its own tools"
_HINTS = {
    Form.URDF: "it stands wherever a robot does: dhcli describe {file} --as standard",
    Form.XACRO: "write what it makes into a file: xacro {file} > arm.urdf",
    Form.SDF: _TO_URDF,
    Form.MJCF: _TO_URDF,
    Form.XML: _TO_URDF,
    Form.TABLE: "dhcli new robot --from {file} --convention standard makes a robot file of it",
    Form.LISTING: _IMPORTED,
    Form.KINEMATICS: _IMPORTED,
    Form.RESULT: "a robot file has all of it: dhcli describe ROBOT --as standard -o arm.yaml",
}


def form_of(text: str) -> Form | None:
    """The form of a text; None if nothing tells."""
    start = text[:LARGEST].lstrip("\ufeff \t\r\n")
    if start.startswith("<") and not start.startswith("<<"):
        return _xml(start)
    if _RESULT.match(start):
        return Form.RESULT
    if _KINEMATICS.search(start) and "format:" not in start:
        return Form.KINEMATICS
    if heads_of(start) is not None:
        return Form.TABLE
    return Form.LISTING if _LISTING.search(start) else None


def told(form: Form, source: str) -> Problem:
    """That a file is no file of dhcli's but this, and what to do with it."""
    return Problem(f"this is {form.value}, no file of dhcli's", Place(source), _HINTS[form].format(file=source))


def _xml(text: str) -> Form:
    tag = _FIRST_TAG.search(text)
    form = _TAGS.get(tag["tag"].rpartition(":")[2] if tag else "", Form.XML)
    is_template = "xmlns:xacro" in text or "<xacro:" in text or "${" in text
    return Form.XACRO if form is Form.URDF and is_template else form
