"""What is asked for when a robot is to be described anew."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, get_args

from dhcli.errors import UnknownNameError, did_you_mean
from dhcli.frozen import frozen
from dhcli.kinematics.describe.choices import USUAL, Choices
from dhcli.kinematics.robot import Value

Form = Literal["standard", "modified", "axes", "screws", "body-screws", "product"]
FORMS: tuple[Form, ...] = get_args(Form)

DRAWN = "drawn"
"""The named pose in which a robot was drawn."""

NAMES = {
    "standard": "standard DH",
    "modified": "modified DH",
    "axes": "joint axes",
    "screws": "screws in the base",
    "body-screws": "screws in the end frame",
    "product": "products of moves",
}
"""What each description is called."""


@frozen
class Asked:
    """What to describe.

    Attributes:
        form: The description wanted.
        steps: Whether the process is to be told: then a table comes from the axes, even from another table.
        numbers: Whether lengths are to be numbers.
        pose: The pose in which the robot is drawn; None for the one named `drawn`, else zero.
        choices: What decides where the rules leave a choice; then, too, a table comes from the axes.
        straighten: Within which angle axes count as parallel, or as meeting, which are not [rad]; None for no such.
    """

    form: Form
    steps: bool = False
    numbers: bool = False
    pose: Mapping[str, Value] | None = None
    choices: Choices = USUAL
    straighten: float | None = None

    @property
    def from_axes(self) -> bool:
        """Whether a table is to come from the axes, even where rows would only have to be grouped anew."""
        return self.steps or self.pose is not None or self.choices != USUAL or self.straighten is not None


def check_form(text: str, others: tuple[str, ...]) -> Form:
    """A form by its name.

    Args:
        text: The name.
        others: What else the caller has names for, to be told where this is none of them.

    Raises:
        UnknownNameError: There is none of this name.
    """
    for form in FORMS:
        if form == text.strip().lower():
            return form
    known = (*FORMS, *others)
    raise UnknownNameError(f"there is no description {text}", did_you_mean(text, known))
