"""The options of `fk` as a question; what contradicts itself is refused."""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.given import forms_of, open_scope, point_of
from dhcli.errors import DhcliError
from dhcli.kinematics.frames import View
from dhcli.kinematics.question import Listing, Question
from dhcli.kinematics.robot import Robot


def ask(
    robot: Robot,
    chosen: Chosen,
    *,
    inverse: bool,
    symbolic: bool,
    frames: bool,
    links: bool,
    factors: str | None,
    point: str | None,
    forms: Sequence[str] | None,
    let: bool,
) -> Question:
    """The question that the options ask.

    Raises:
        DhcliError: Two options contradict each other, the point cannot be read, or the robot has no such frame.
    """
    wanted = {
        "--frames": frames,
        "--links": links,
        "--factors": factors is not None,
        "--point": point is not None,
        "--as": bool(forms),
        "--let": let,
    }
    if len(given := [option for option, is_given in wanted.items() if is_given]) > 1:
        raise DhcliError(f"{' and '.join(given)} ask for different things", "use one of them")
    if let and not symbolic:
        raise DhcliError("--let gives names to parts of formulas, and this result is in numbers", "add --symbolic")
    if factors is not None and inverse:
        raise DhcliError(
            "--factors and --inverse do not go together", "the factors of a link have an order of their own"
        )
    listing: Listing | None = "frames" if frames else "links" if links else "factors" if factors is not None else None
    seen = None if point is None else point_of(point, "--point", open_scope(robot))
    return Question(
        View.of(robot, chosen.from_, chosen.end, inverse=inverse, point=seen),
        symbolic,
        listing,
        None if factors in (None, "all") else factors,
        forms_of(forms or ()),
        let,
    )


def result_kind(question: Question) -> str:
    """The kind of result that a question has, which decides the formats."""
    if question.listing:
        return "poses"
    if question.view.point is not None:
        return "point"
    if question.let:
        return "let"
    return "placement" if question.forms else "pose"
