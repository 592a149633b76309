"""New exercise files: questions about a robot, with blanks that the loader points at until they are filled in."""

from __future__ import annotations

import math
from itertools import cycle

from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about
from dhcli.errors import DhcliError
from dhcli.files.yaml.templates import check_name
from dhcli.kinematics.limits import is_within_limits
from dhcli.kinematics.robot import Robot
from dhcli.safe import one_line, yaml_scalar

FEWEST_FRAMES = 4
"""base, two numbered frames, tool: the frames of a robot with one link."""

ANGLES = ("25°", "40°", "70°", "35°", "60°", "15°")
LENGTHS = ("0.12 m", "0.2 m", "0.31 m")
"""No two alike, and no two angles that add up to a right one: values at which mistakes show."""

TURNED = (math.radians(20), math.radians(70), "20°..70° step 1°")
MOVED = (0.1, 0.3, "0.1 m..0.3 m step 0.01 m")
"""The lowest and the highest value of a range, and the range."""


def exercise_template(name: str, robot: Robot, called: str = "") -> str:
    """The text of a new exercise file.

    Args:
        name: Its id, `course/name`.
        robot: The robot it asks about.
        called: How the file names it, such as a path from its folder; by its name by default.

    Raises:
        DhcliError: The id cannot be, or the robot has no link to ask about.
    """
    folder, slash, short = name.partition("/")
    if not slash:
        raise DhcliError(f"the exercise {name} has no course", f"write dhcli new exercise my-course/{name}")
    for one in (folder, short):
        check_name(one, "an exercise")
    if len(robot.frames) < FEWEST_FRAMES or not robot.variables:
        raise DhcliError(f"{robot.name} has no joint to ask about", "dhcli list robots shows others")
    start, first, end = robot.frames[1], robot.frames[2], robot.frames[-2]
    pose = f"pose {start}..{end}"
    return f"""\
# An exercise for dhcli. Fill in what is empty ("") and change what differs; answers are computed, never typed in.
# `dhcli lint` points at what is still missing, `dhcli show ./exercises/{name}.yaml` shows what a student will see.

format: 1
title: ""
source: ""                      # your notes, a chapter, a sheet
robot: {yaml_scalar(called or robot.name)}

# In your own words; a student must be able to answer from this text alone.
task: |
  The robot is {one_line(robot.title)}.
  Base frame {start}: write here where it stands. End frame {end}: write here on which part it sits.
  Joint zero: write here how the arm looks then. Positive sense: write here that of every joint.

parts:                          # ask: link 1 | pose 0..3 | position of pose 0..3 | table standard
  - id: a{first}
    ask: link {first}
    credit: 1
    hints: [""]                 # from gentle to plain, without the answer
  - id: t{start}{end}
    ask: {pose}
    credit: 2
    depends: [a{first}]
    hints: [""]
  - id: tip
    ask: position of {pose}
    credit: 1
    depends: [t{start}{end}]
    hints: [""]

# Submissions the exercise tests itself with: one that is right, and mistakes that must not pass.
tests:
  - {{part: tip, answer: "", verdict: RIGHT}}
  - {{part: t{start}{end}, mistake: {_mistake(robot, start, end)}, verdict: WRONG}}
  - {{part: tip, answer: "0, 0, 0.001", verdict: WRONG}}

# Numbers instead of letters: take the # away; then every student gets numbers of their own with --variant NAME.
# numeric: true
# unit: m
# given: {{{_given(robot)}}}
# variants: {{{_ranges(robot)}}}
# tolerance: {{position: 0.5 mm}}
"""


def _mistake(robot: Robot, start: str, end: str) -> str:
    """A mistake that shows in the pose; in that of a SCARA, whose rotation is symmetric, the usual one does not."""
    exercise = question_about(robot, f"pose {start}..{end}", numeric=False, given={})
    names = [slip.name for slip in Judge(exercise).slips(exercise.parts[0])]
    return "transposed" if "transposed" in names else names[0]


def _given(robot: Robot) -> str:
    """A value for every joint, and for every length and angle of the table that has none."""
    turned, moved = cycle(ANGLES), cycle(LENGTHS)
    open_ = [name for name, value in robot.parameters.items() if value is None]
    return ", ".join(
        f"{_key(name)}: {next(turned if name in robot.angles else moved)}" for name in (*robot.variables, *open_)
    )


def _ranges(robot: Robot) -> str:
    """What every joint may take that can be there."""
    ranges = {joint.name: (TURNED if joint.kind == "revolute" else MOVED) for joint in robot.joints}
    free = {
        name: range_ for name, range_ in ranges.items() if all(is_within_limits(robot, name, end) for end in range_[:2])
    }
    return ", ".join(f"{_key(name)}: {text}" for name, (*_, text) in (free or ranges).items())


def _key(name: str) -> str:
    """A name as a key between braces; one that holds braces itself is quoted."""
    return f'"{name}"' if "{" in name else name
