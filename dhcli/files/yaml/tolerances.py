"""How near is near enough, as an exercise file says it."""

from __future__ import annotations

from dhcli.checking.tolerance import DEFAULT, Tolerance
from dhcli.files.keys.exercises import TOLERANCE
from dhcli.files.keys.shapes import names
from dhcli.files.yaml.fields import Fields
from dhcli.files.yaml.typed import read_degrees, read_flag, read_number, read_whole

MOST_DECIMALS = 12


def read_decimals(fields: Fields) -> int | None:
    """How many decimals a task asks for; None if it does not say, or not so that it can be meant."""
    decimals = read_whole(fields, "decimals")
    if decimals is not None and not 1 <= decimals <= MOST_DECIMALS:
        message = f"decimals: {decimals} cannot be asked for"
        fields.problems.add(fields.place_of("decimals"), message, f"1 to {MOST_DECIMALS}")
        return None
    return decimals


def read_tolerance(fields: Fields) -> Tolerance:
    """What stands under the key `tolerance`; the usual tolerances where nothing does."""
    own = fields.mapping("tolerance", known=names(TOLERANCE), example="{rotation: 0.001, position: 0.5 mm}")
    rotation = read_number(own, "rotation", "a direction cosine has no unit: write 0.001")
    position, angle = read_number(own, "position"), read_degrees(own, "angle")
    for key, value in (("rotation", rotation), ("position", position), ("angle", angle)):
        if value is not None and not value >= 0:
            own.problems.add(own.place_of(key), f"{key}: a tolerance is not negative")
    return Tolerance(
        rotation=DEFAULT.rotation if rotation is None else rotation,
        position=position,
        angle=DEFAULT.angle if angle is None else angle,
        decimals=read_decimals(own),
        exact=read_flag(own, "exact"),
    )
