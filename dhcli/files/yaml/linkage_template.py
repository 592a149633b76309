"""New linkage files: commented, and loading as they are, so that there is something to change."""

from __future__ import annotations

from dhcli.errors import DhcliError, did_you_mean
from dhcli.files.yaml.templates import check_name


def linkage_template(name: str, form: str) -> str:
    """The text of a new linkage file.

    Args:
        name: Name of the linkage.
        form: joints, bars, chain or loop: how the linkage is written down.

    Raises:
        DhcliError: The name or the form cannot be.
    """
    check_name(name, "a linkage")
    if form not in _FORMS:
        raise DhcliError(f"there is no form {form}", did_you_mean(form, _FORMS))
    return _HEAD.format(name=name, other=", ".join(other for other in _FORMS if other != form)) + _FORMS[form]


_HEAD = """\
# A linkage for dhcli. Change what differs; `dhcli dof {name}` counts its freedoms.
# Every key stands in `dhcli help linkage-files`.
# Other forms of such a file: dhcli new linkage {name} --form {other}

format: 1
title: {name}
source: write here where the numbers come from; these are example values

"""

_JOINTS = """\
# planar, spherical or spatial, or lambda: 1 to 6. In the plane an axis is left out, and a point has two coordinates.
space: planar

# Names for numbers. Expressions keep special lengths exact: a rounded special linkage does not move.
let:
  crank: 0.1                    # metres; units may be written, 100 mm
  phi: 60°

# Points in one assembled position. The mobility that is found is that of this position.
points:
  A: [0, 0]
  B: [crank*cos(phi), crank*sin(phi)]
  C: [0.4, 0.3]
  D: [0.35, 0]

# One line a joint: link, type, link, and where. R revolute, P prismatic, S spherical, ...
# A link needs no list: it is there when a joint names it.
joints:
  - ground R crank at A
  - crank R rod at B
  - rod R rocker at C
  - rocker R ground at D
# - {type: P, links: [ground, slider], axis: [1, 0]}     a joint with keys, for all that has no place in a line

# The link that stands still is called ground, or named here; the motion of the output is told.
# ground: ground
output: rocker
"""

_BARS = """\
# Bars are pinned together in the plane.
space: planar

points:
  A: [0, 0]
  B: [0.1, 0.2]
  C: [0.5, 0.35]
  D: [0.4, 0]
  E: [0.3, 0.5]

# Each bar with its pins. A pin through k bars is k - 1 joints; a bar with three pins is a plate.
bars:
  ground: [A, D]
  crank: [A, B]
  coupler: [B, C, E]
  rocker: [C, D]

output: coupler
"""

_CHAIN = """\
# A chain says which links there are and what ties them, not where: it gives the formula, and not the truth.
space: spatial

# Links and joints in turn; several chains may share links.
chain:
  - ground R arm1 S rod1 S platform
  - ground R arm2 S rod2 S platform
  - ground R arm3 S rod3 S platform

output: platform
"""

_LOOP = """\
space: spatial

let:
  a: 1
  alpha: 40°
  beta: 75°
  b: a*sin(beta)/sin(alpha)     # Bennett's condition: without it four axes in space do not move
  theta1: 70°                   # the position; the loop must close in it
  theta2: 2*atan(sin((beta + alpha)/2)/sin((beta - alpha)/2)/tan(theta1/2))

# A closed loop as the rows of a DH table, standard or modified; the product of all rows must be the identity.
# A joint is revolute unless `joint: P` or another letter says what it is. The links are ground, 1, 2, ...
loop:
  convention: standard
  rows:
    - {a: a, alpha: alpha, d: 0, theta: theta1}
    - {a: b, alpha: beta,  d: 0, theta: theta2}
    - {a: a, alpha: alpha, d: 0, theta: -theta1}
    - {a: b, alpha: beta,  d: 0, theta: -theta2}

output: "2"
"""

_FORMS = {"joints": _JOINTS, "bars": _BARS, "chain": _CHAIN, "loop": _LOOP}
