"""The keys of an exercise file."""

from __future__ import annotations

from dhcli.checking.credit import UNITS
from dhcli.checking.figures import LEVELS
from dhcli.checking.tables.comparing import COMPARED
from dhcli.checking.verdicts import Verdict
from dhcli.files.keys.shapes import ANGLE, FLAG, NUMBER, TEXT, TEXTS, WHOLE, Either, Key, Keyed, Many, Named, Scalar
from dhcli.notation.quantity import LENGTH_UNITS

FEEDBACK = ("verdict", "expected")
"""What a wrong entry may be told with: its verdict alone, or the right entry too."""

ANSWER = Either((Scalar(may_be_empty=True), Many(Either((TEXT, TEXTS)))))
"""An answer as a sheet has it: a text, or a list as YAML has it."""
TOLERANCE = (
    Key("rotation", "largest error of a direction cosine", NUMBER),
    Key("position", "largest error of a length", TEXT),
    Key("angle", "largest error of an angle", ANGLE),
    Key("decimals", "the truth rounded to so many decimals, or to more, is right", WHOLE),
    Key("exact", "only exact values are right, `sqrt(2)/2` and not 0.7071", FLAG),
)
SHARES = (
    Key("rotation", "what that half of a pose is worth; usually by the number of items", NUMBER),
    Key("position", "the same of the other half; one of the two says it", NUMBER),
    Key("close", "what an item within ten times the tolerance earns; usually 0", NUMBER),
    Key("rounded", "what is right to the digits typed earns, where they are too few; usually 1", NUMBER),
    Key("unit", "what an answer earns that is right throughout in another unit; usually 1/2", NUMBER),
    Key("moves", "what the moves of `factors` earn in the wrong order; usually 0", NUMBER),
    Key("table", "what earns in a table; usually cells", Scalar(UNITS)),
)
CREDIT = (Key("points", "what the part is worth", NUMBER), *SHARES)
SOURCE = (
    Key("document", "the document", TEXT, is_required=True),
    Key("item", "where in it", TEXT, is_required=True),
)
ALSO = (
    Key("robot", "the robot whose answers are right too", TEXT, is_required=True),
    Key("note", "why", TEXT),
)
PRINTED = (
    Key("answer", "what the document prints", ANSWER, is_required=True),
    Key("note", "what is wrong with it", TEXT),
)
TEST = (
    Key("part", "the part that is answered", TEXT, is_required=True),
    Key("answer", "the answer", ANSWER),
    Key("mistake", "a mistake that dhcli makes in the truth", TEXT),
    Key("verdict", "how it is judged", Scalar(tuple(verdict.word for verdict in Verdict)), is_required=True),
)
OF_KINDS = (
    Key(
        "compare",
        "of a table: `same-motion`, which leaves no free choice, the default where the task states base frame, end "
        "frame, joint zero and positive sense; `same-robot`, whose free choices are named, the default elsewhere; "
        "`literal`, cell by cell. `lint` asks for one of them by name",
        Scalar(COMPARED),
    ),
    Key("options", "of `ask: choice` its statements; an answer is a number, or words of one alone", TEXTS),
    Key("right", "of `ask: choice` the number of the right option", WHOLE),
)
"""Keys that only some kinds of question read; a test compares them with what the kinds say."""
PART = (
    Key("id", "its name, by which a sheet answers it", TEXT, is_required=True, example="id: a1"),
    Key("ask", "what is asked", TEXT, is_required=True, example="ask: pose 0..3"),
    Key("prompt", "what it asks, in words", TEXT),
    Key("credit", "what it is worth, or what answers earn of it", Either((NUMBER, Keyed(CREDIT)))),
    Key("withdrawn", "why it is not asked any more; sheets that have an answer to it are judged without it", TEXT),
    Key("depends", "parts before it whose answers it builds on", TEXTS),
    Key("hints", "what helps, gentle first", TEXTS),
    *OF_KINDS,
    Key("exact", "only exact values are right, `sqrt(2)/2` and not 0.7071", FLAG),
    Key("decimals", "the truth rounded to so many decimals, or to more, is right", WHOLE),
)
EXERCISE = (
    Key("title", "what it is called", TEXT, is_required=True),
    Key("source", "the document and where in it, or a text", Either((TEXT, Keyed(SOURCE))), is_required=True),
    Key("robot", "the robot it asks about, by name or path", TEXT),
    Key("task", "what a student is told", TEXT, is_required=True),
    Key("given", "values that the task gives", Named(TEXT), example="given: {theta1: 35°}"),
    Key("names", "further letters that answers may use", TEXTS, example="names: [beta]"),
    Key(
        "numeric",
        "answers are numbers, in all parts; an expression that has this value is right too, `a1*c1` with a1 and "
        "theta1 given; a name that an answer needs and that has no value keeps the exercise from loading",
        FLAG,
        example="numeric: true",
    ),
    Key(
        "unit",
        "the unit of a bare length on the sheet and in `ask:`, also of `scalar`, `cell` and `factors`: m, mm, cm, or "
        "none; directions, angles and ratios have none; bare lengths of `given:` stay metres",
        Scalar((*LENGTH_UNITS, "none")),
        example="unit: mm",
    ),
    Key(
        "tolerance",
        "how near is near enough",
        Keyed(TOLERANCE),
        example="tolerance: {rotation: 0.001, position: 0.5 mm, angle: 0.05°}",
    ),
    Key("credit", "what answers earn, in all parts", Keyed(SHARES), example="credit: {close: 1/2}"),
    Key("also", "a second robot whose answers are right too", Keyed(ALSO), example="also: {robot: NAME, note: why}"),
    Key("parts", "the questions", Many(Keyed(PART), 1), is_required=True, example="parts: [{id: a1, ask: pose 0..3}]"),
    Key("printed", "what the document prints, by part", Named(Either((ANSWER, Keyed(PRINTED))))),
    Key("tests", "answers and how they are judged, for `lint`", Many(Keyed(TEST))),
    Key(
        "variants",
        "values that are drawn for each student; `20°..70° n 11` counts them instead",
        Named(TEXT),
        example="variants: {theta1: 20°..70° step 1°}",
    ),
    Key("feedback", "`expected`: a wrong entry is told with the right one beside it", Scalar(FEEDBACK)),
    Key(
        "picture",
        "`axes`: `dhcli draw` shows bodies and joint axes only; `none`, no picture. By itself it shows frames and "
        "lengths beside questions for links, poses, positions, numbers and counts, else the axes; `lint` refuses "
        "`picture: frames` where they would answer a part",
        Scalar(LEVELS),
        example="picture: axes",
    ),
)
