"""The keys of a linkage file."""

from __future__ import annotations

from dhcli.files.keys.shapes import (
    COORDINATES,
    HEAD,
    NOTES,
    ROW,
    TEXT,
    TEXTS,
    WHOLE,
    Either,
    Key,
    Keyed,
    Many,
    Named,
    Scalar,
)

JOINT = (
    Key("name", "what the joint is called; they are numbered otherwise", TEXT),
    Key("type", "a letter or a name from the table of joints", TEXT, is_required=True),
    Key("links", "the two links, or all that a pin holds together", Many(TEXT, 2), is_required=True),
    Key("point", "a point by its name or its coordinates", Either((TEXT, COORDINATES))),
    Key("axis", "a direction of any length", Either((TEXT, COORDINATES))),
    Key("axis2", "the second direction", Either((TEXT, COORDINATES))),
    Key("other", "the second point that a bar, a cam or a rolling wheel needs", Either((TEXT, COORDINATES))),
    Key("slide", "the direction of a slot", Either((TEXT, COORDINATES))),
    Key("pitch", "how far a screw goes in one turn", TEXT),
    Key("carrier", "of gears the link in which both wheels turn", TEXT),
    Key("radii", "of gears the radii in the order of `links`", Many(TEXT, 2, 2)),
    Key("internal", "`yes` if one wheel of a gear has its teeth inside", Scalar(("yes", "no", "true", "false"))),
)
A_JOINT = Either((TEXT, Keyed(JOINT)))
LOOP_ROW = (*ROW, Key("joint", "the joint of the row, where it is not revolute", TEXT))
LOOP = (
    Key("convention", "of the table", Scalar(("standard", "modified")), is_required=True),
    Key("rows", "the rows, whose product is the identity", Many(Keyed(LOOP_ROW), 1), is_required=True),
)
LINKAGE = (
    *HEAD,
    NOTES,
    Key("space", "where it moves", Scalar(("planar", "spherical", "spatial"))),
    Key("lambda", "in its place: λ from 1 to 6", WHOLE),
    Key("ground", "the link that stands still; the one that is called `ground` needs no mention", TEXT),
    Key("output", "the link whose motion is told, such as 1T0R: one translation, no rotation", TEXT),
    Key("let", "names for numbers; each may use those before it, in `points`, `joints` and `loop`", Named(TEXT)),
    Key("points", "names for points: `[x, y]` in the plane, `[x, y, z]` in space", Named(COORDINATES)),
    Key("links", "how many links there are, where `joints` holds bare counts only", TEXT),
    Key("joints", "the joints, each in a line or with keys; or bare counts, `3R 1P`", Either((TEXT, Many(A_JOINT, 1)))),
    Key("chain", "the joints as links and joints in turn", Either((TEXT, TEXTS))),
    Key("bars", "the joints as bars with the pins that hold them", Named(TEXTS)),
    Key("loop", "the joints as a closed loop of DH rows", Keyed(LOOP)),
)
FORMS = ("joints", "chain", "bars", "loop")
"""The keys of a linkage of which one must stand there."""

SIGNS = (*FORMS, "lambda", "space")
"""Keys that no file of another kind has."""
