"""Robots as files that dhcli and others load."""

from __future__ import annotations

from dhcli.files.urdf.writing import urdf_text
from dhcli.files.yaml.writing import described_text
from dhcli.kinematics.describe.description import Described
from dhcli.render.look import Look


def description_yaml(result: Described, _look: Look) -> str:
    """A robot file in the description that was asked for."""
    return described_text(result)


def description_urdf(result: Described, _look: Look) -> str:
    """A URDF; all descriptions give the same one."""
    return urdf_text(result.given)
