"""A file of any form that is read, as a robot."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from dhcli.errors import FileError, Place, Problem, UnknownNameError, did_you_mean
from dhcli.files.foreign.forms import Form, form_of, told
from dhcli.files.foreign.keyed import keyed_rows
from dhcli.files.foreign.kinematics import read_kinematics
from dhcli.files.foreign.listing import read_listing
from dhcli.files.foreign.rows import Reader, RowText, Units, Whole, robot_of_rows, scope_of
from dhcli.files.foreign.tables import first_row, read_table
from dhcli.files.urdf.robots import read_urdf
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import COLUMNS, Convention, convention_hint, conventions_in
from dhcli.kinematics.describe.asked import Asked
from dhcli.kinematics.describe.description import describe
from dhcli.kinematics.robot import Robot
from dhcli.notation.quantity import ANGLE_UNITS, LENGTH_UNITS
from dhcli.notation.quarters import Slight


@frozen
class Wish:
    """What a person says about a file.

    Attributes:
        name: What the robot is called.
        convention: Of a table, the one it is in; of everything else the one it is to be written in.
        joints: A letter for each row: R, P or F.
        units: Units of bare lengths and angles, `mm,deg`; one of them may be missing.
        base: The link of a URDF that is frame 0.
        tip: The link of a URDF that is the last frame.
        as_typed: Whether 1.5708 stays what it is.
    """

    name: str
    convention: str | None = None
    joints: str = ""
    units: str = ""
    base: str | None = None
    tip: str | None = None
    as_typed: bool = False


def import_robot(text: str, source: str, wish: Wish) -> Robot:
    """A robot from a file of others.

    Raises:
        FileError: It is of no form that is read, or something is wrong in it.
        UnknownNameError: There is no such convention, unit or link.
    """
    convention = _convention(wish.convention)
    units = _units(wish.units)
    form = form_of(text)
    _check_wish(wish, units, form, source)
    joints = wish.joints.strip().upper()
    match form:
        case Form.TABLE:
            return _from_table(text, source, wish, convention)
        case Form.LISTING:
            found = read_listing(text, source, wish.name, units.length, as_typed=wish.as_typed)
        case Form.KINEMATICS:
            found = read_kinematics(text, source, wish.name, joints, as_typed=wish.as_typed)
        case Form.URDF | Form.XACRO:
            found = read_urdf(text, source, wish.name, base=wish.base, tip=wish.tip, as_typed=wish.as_typed)
        case Form():
            raise FileError(told(form, source))
        case None:
            return _from_rows(text, source, wish, convention)
    return found if convention in (None, found.convention) else _described(found, convention)


def _units(text: str) -> Units:
    """The unit of lengths and that of angles.

    Raises:
        UnknownNameError: One of them is no unit, or there are two of one kind.
    """
    words = text.replace(",", " ").split()
    lengths = [word for word in words if word in LENGTH_UNITS]
    angles = [word for word in words if word in ANGLE_UNITS]
    if unknown := next((word for word in words if word not in (*lengths, *angles)), ""):
        hint = did_you_mean(unknown, (*LENGTH_UNITS, *ANGLE_UNITS))
        raise UnknownNameError(f"{unknown} is no unit of lengths or angles", hint)
    if len(lengths) > 1 or len(angles) > 1:
        raise UnknownNameError(f"{text} are two units of one kind", "one of lengths and one of angles: mm,deg")
    return Units("".join(lengths), "".join(angles))


def _check_wish(wish: Wish, units: Units, form: Form | None, source: str) -> None:
    """Make sure that what a person says about a file has a meaning there.

    Raises:
        FileError: It has none.
    """
    if form not in (Form.URDF, Form.XACRO) and (wish.base or wish.tip):
        raise FileError(Problem("only a URDF has links to choose from", Place(source)))
    if units.length not in ("", "m") and form in (Form.URDF, Form.XACRO, Form.KINEMATICS):
        hint = "divide them in the file, if they are none"
        raise FileError(Problem(f"lengths of {form.value} are in metres, not in {units.length}", Place(source), hint))
    if units.angle not in ("", "rad") and form in (Form.URDF, Form.XACRO, Form.KINEMATICS, Form.LISTING):
        hint = "change them in the file, if they are none"
        raise FileError(Problem(f"angles of {form.value} are in radians, not in {units.angle}", Place(source), hint))
    if wish.joints and form in (Form.URDF, Form.XACRO, Form.LISTING):
        raise FileError(Problem(f"{form.value} says itself what its joints do", Place(source), "leave --joints out"))


def _from_table(text: str, source: str, wish: Wish, convention: Convention | None) -> Robot:
    heads, rows = read_table(text, source)
    lines = text.split("\n")
    place = Place(source, heads.line, 1, lines[heads.line - 1])
    said = heads.convention or _wanted(convention, place, "\n".join(lines[: heads.line - 1]))
    if convention not in (None, said):
        if convention is Convention.PRODUCT:
            raise _untold(place, "")
        raise FileError(Problem(f"these heads are those of the {said} convention", place, f"--convention {said}"))
    return _of_rows(rows, source, wish, said, heads.besides)


def _from_rows(text: str, source: str, wish: Wish, convention: Convention | None) -> Robot:
    """The robot of a file that no other form fits: of rows with keys, if it has any."""
    rows, besides = keyed_rows(text, source)
    if rows:
        return _of_rows(rows, source, wish, _wanted(convention, rows[0].place, text), besides)
    if (line := first_row(text)) is not None:
        message = "are these the rows of a DH table? they have no heads"
        hint = f"name the columns in a line above, in their order: {', '.join(COLUMNS)}"
        raise FileError(Problem(message, Place(source, line, None, text.split("\n")[line - 1]), hint))
    hint = "DH tables as CSV, Markdown, LaTeX, YAML or JSON, SerialLink listings, kinematics YAML of ROS, and URDF"
    raise FileError(Problem("is none of the forms that are read", Place(source), f"dhcli reads {hint}"))


def _wanted(convention: Convention | None, place: Place, around: str) -> Convention:
    """The convention that a person says a table is in.

    Raises:
        FileError: They do not; the hint has the one that the text around speaks of.
    """
    if convention is None or convention is Convention.PRODUCT:
        raise _untold(place, around)
    return convention


def _untold(place: Place, around: str) -> FileError:
    hint = "add --convention standard or --convention modified"
    if len(named := [*conventions_in(around)]) == 1:
        hint = f"the text above it says {named[0]}: add --convention {named[0]}"
    return FileError(Problem("a table does not say which convention it is in", place, hint))


def _of_rows(rows: Sequence[RowText], source: str, wish: Wish, convention: Convention, besides: Sequence[str]) -> Robot:
    """The robot of the rows of a table."""
    scope = scope_of(cell.text for row in rows for cell in row.cells.values())
    reader = Reader(scope, units=_units(wish.units), as_typed=wish.as_typed)
    if besides:
        reader.remarks.append(Slight(f"left out: {', '.join(besides)}"))
    whole = Whole(wish.name, wish.name, f"the table {source}", convention)
    return robot_of_rows(reader, rows, whole, wish.joints.strip().upper())


def _described(robot: Robot, convention: Convention) -> Robot:
    """The same robot in another form, with what should be known of it."""
    found = describe(robot, Asked(convention.value))
    return replace(
        found.robot,
        title=robot.title,
        notes=robot.notes,
        remarks=(*robot.remarks, *found.notes, *found.warnings),
    )


def _convention(word: str | None) -> Convention | None:
    if word is None:
        return None
    known = [convention.value for convention in Convention]
    if word not in known:
        raise UnknownNameError(f"there is no convention {word}", convention_hint(word, known))
    return Convention(word)
