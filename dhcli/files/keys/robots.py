"""The keys of a robot file."""

from __future__ import annotations

from dhcli.files.keys.shapes import (
    ANGLE,
    FLAG,
    HEAD,
    MOVES,
    NOTES,
    PAIR,
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
from dhcli.kinematics.conventions import Convention

SIDES = ("space", "body")
"""Where screws may be seen from."""

CONVENTIONS = (*(convention.value for convention in Convention), "axes", "screws")

_OF_EVERY_ROBOT = (
    *HEAD,
    NOTES,
    Key("convention", "how its links are described", Scalar(CONVENTIONS), is_required=True),
    Key("exact", "false: 1.5708 stays what it is; else it is taken as 90°", FLAG, example="exact: false"),
    Key("variables", "the joint variables in order", Many(TEXT), is_required=True, example="variables: [theta1, d2]"),
    Key(
        "called",
        "what joints are called elsewhere, such as in a URDF; joint values may have these names too",
        Named(TEXT),
        example="called: {theta1: shoulder_pan_joint}",
    ),
    Key(
        "parameters",
        "values of all other names, or formulas of others; without a value one stays open",
        Named(Scalar(may_be_empty=True)),
        example="parameters: {a1: 300 mm, a2: 2*a1}",
    ),
    Key("limits", "lowest and highest value of joints", Named(PAIR), example="limits: {theta1: [-160°, 160°]}"),
    Key("poses", "named poses, a value for each variable", Named(TEXTS), example="poses: {home: [0, 90°]}"),
    Key(
        "actuators",
        "motors with their limits, and for each joint that they drive in what way",
        Named(Either((TEXT, TEXTS, Named(Either((Scalar(may_be_empty=True), PAIR)))))),
        example="actuators: {motors: {m1: [-60°, 76°], m2: }, theta1: m1, theta2: m2 - m1}",
    ),
)
UNITS = ("m", "cm", "mm", "in")
_BESIDE_LINKS = (
    Key("units", "the unit of bare lengths; metres by default", Scalar(UNITS), example="units: mm"),
    Key("first", "number of the first link, 1 by default", WHOLE, example="first: 4"),
    Key("base", "moves in front of the first link", MOVES, example="base: Trans(0, 0, 0.5)"),
    Key("tool", "moves behind the last link", MOVES, example="tool: Trans(0, 0, 0.1) Rot(z, 45°)"),
    Key("tools", "other tools by name", Named(MOVES), example='tools: {gripper: "Trans(0, 0, 0.2)"}'),
)
BETA = Key("beta", "of a calibrated row: a turn about y besides", ANGLE, example="beta: 0.1°")
TABLE = (
    *_OF_EVERY_ROBOT,
    Key(
        "links",
        "a row of the table for each link",
        Many(Keyed((*ROW, BETA)), 1),
        is_required=True,
        example="links: [{a: a1, alpha: 0, d: 0, theta: theta1}]",
    ),
    *_BESIDE_LINKS,
)
"""A robot with `convention: standard` or `modified`."""

PRODUCTS = (
    *_OF_EVERY_ROBOT,
    Key(
        "links",
        "a product of moves for each link",
        Many(MOVES, 1),
        is_required=True,
        example='links: ["Trans(0, 0, l1) * Rot(z, theta1)"]',
    ),
    *_BESIDE_LINKS,
)
"""A robot with `convention: product`."""

_LINE = Named(Either((Scalar(may_be_empty=True), TEXTS)))  # a point in round brackets is several values to YAML
AXES = (
    *_OF_EVERY_ROBOT,
    Key(
        "drawn", "values of variables in the pose drawn, where they are not 0", Named(TEXT), example="drawn: {q1: 90°}"
    ),
    Key(
        "axes",
        "the axis of each joint: its direction, and through which point; `slides: true` for a slide, "
        "`pitch: 5 mm` for each turn of a screw",
        Many(_LINE, 1),
        is_required=True,
        example="axes: [{theta1: +z, through: (0, 0, 0)}]",
    ),
    Key("end", "moves from the base to the end frame in the pose drawn", MOVES, example="end: Trans(0.7, 0, 0)"),
)
"""A robot with `convention: axes`."""

SCREWS = (
    *_OF_EVERY_ROBOT,
    Key("frame", "where the screws are seen from: the base, or the end frame", Scalar(SIDES)),
    Key(
        "screws",
        "the screw of each joint with the joints at 0: ω, then v",
        Many(_LINE, 1),
        is_required=True,
        example="screws: [{theta1: (0, 0, 1, 0, 0, 0)}]",
    ),
    Key(
        "home",
        "moves from the base to the end frame with the joints at 0",
        MOVES,
        is_required=True,
        example="home: Trans(0.7, 0, 0)",
    ),
)
"""A robot with `convention: screws`."""

ROBOTS = {
    **dict.fromkeys((Convention.STANDARD.value, Convention.MODIFIED.value), TABLE),
    Convention.PRODUCT.value: PRODUCTS,
    "axes": AXES,
    "screws": SCREWS,
}
"""The keys by convention."""
