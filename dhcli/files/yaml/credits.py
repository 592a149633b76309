"""What answers earn, as an exercise file says it: the points of a part, and the shares that an answer gets of them."""

from __future__ import annotations

from dataclasses import replace

from dhcli.checking.credit import UNITS, USUAL, Shares
from dhcli.files.keys import exercises as keys
from dhcli.files.keys.shapes import names
from dhcli.files.yaml.fields import Fields
from dhcli.files.yaml.placed import PlacedMapping
from dhcli.files.yaml.typed import read_number, read_word

HALVES = ("rotation", "position")
SHARES = ("close", "rounded", "unit", "moves")
EXAMPLE = "{rotation: 1/2, close: 1/2, rounded: 1, unit: 1/2}"


def read_shares(fields: Fields) -> Shares:
    """What stands under the key `credit` at the top of a file, for all parts; the usual shares where nothing does."""
    return _shares(fields.mapping("credit", known=names(keys.SHARES), example=EXAMPLE), USUAL)


def read_credit(fields: Fields, shares: Shares) -> tuple[float, Shares | None]:
    """The points of a part, and its own shares; None where it has those of the exercise.

    Args:
        fields: The fields of the part: `credit: 2`, or `credit: {points: 2, close: 1/2}`.
        shares: Those of the exercise, which hold where the part says nothing else.
    """
    if not isinstance(fields.get("credit"), PlacedMapping):
        points = read_number(fields, "credit")
        return 1.0 if points is None else points, None
    own = fields.mapping("credit", known=names(keys.CREDIT))
    points, found = read_number(own, "points"), _shares(own, shares)
    return 1.0 if points is None else points, None if found == shares else found


def _shares(own: Fields, usual: Shares) -> Shares:
    given = {key: value for key in (*HALVES, *SHARES) if (value := read_number(own, key)) is not None}
    for key, value in given.items():
        if not 0 <= value <= 1:
            own.problems.add(own.place_of(key), f"{key}: a share is 0 to 1, is {value:g}", "write 1/2 for one half")
    rotation, position = (given.pop(key, None) for key in HALVES)
    if rotation is not None and position is not None and abs(rotation + position - 1) > 1e-9:  # noqa: PLR2004  rounding
        message = f"rotation: {rotation:g} and position: {position:g} do not add up to 1"
        own.problems.add(own.place_of("position"), message, "one of them says it: the other is the rest")
    if rotation is None and position is not None:
        rotation = 1 - position
    table = read_word(own, "table", UNITS) or usual.table
    return replace(usual, **given, table=table, rotation=usual.rotation if rotation is None else rotation)
