"""How near is near enough, as an exercise file says it."""

from __future__ import annotations

from dhcli.checking.tolerance import DEFAULT, Tolerance
from dhcli.files.fields import Fields
from dhcli.files.typed import read_degrees, read_flag, read_number, read_whole

KEYS = ("rotation", "position", "angle", "decimals", "exact")


def read_tolerance(fields: Fields) -> Tolerance:
    """What stands under the key `tolerance`; the usual tolerances where nothing does."""
    own = fields.mapping("tolerance", known=KEYS)
    rotation, position, angle = read_number(own, "rotation"), read_number(own, "position"), read_degrees(own, "angle")
    for key, value in (("rotation", rotation), ("position", position), ("angle", angle)):
        if value is not None and not value >= 0:
            own.problems.add(own.place_of(key), f"{key}: a tolerance is not negative")
    return Tolerance(
        rotation=DEFAULT.rotation if rotation is None else rotation,
        position=position,
        angle=DEFAULT.angle if angle is None else angle,
        decimals=read_whole(own, "decimals"),
        exact=read_flag(own, "exact"),
    )
