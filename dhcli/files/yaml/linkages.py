"""Linkage files in all their forms: counts, chains, joints, planar bars, and loops of DH rows."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from dhcli.errors import DhcliError, FileError, Place, Problem
from dhcli.files.keys.linkages import FORMS, LINKAGE
from dhcli.files.keys.shapes import names, required
from dhcli.files.library.entries import Kind, holds
from dhcli.files.library.lookup import check_typed, find, is_path
from dhcli.files.reading import is_xml, read_text, source_of
from dhcli.files.yaml.coordinates import Coordinates
from dhcli.files.yaml.fields import Problems
from dhcli.files.yaml.joints import JointReader
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, read_yaml
from dhcli.mobility.counting import Counts, counts
from dhcli.mobility.linkage import InvalidLinkageError, Linkage, NamedPoint, serial
from dhcli.mobility.pairs import LETTERS, PLANAR, SPATIAL, LinkageError, Space, space_of
from dhcli.mobility.patterns import EXAMPLES, count_of, joint_counts, looks_like_pattern, read_pattern

if TYPE_CHECKING:
    from dhcli.kinematics.robot import Robot


def find_linkage(what: str | Path, space: Space = SPATIAL, tolerance: float = 0.0) -> Linkage | Counts:
    """What a person means: a file, the name of a linkage or a robot, or a pattern such as `6R`.

    Args:
        what: A path, or with `/` or `.yaml` one, else a known name, else a pattern.
        space: Where a pattern moves; files say it themselves.
        tolerance: Relative error of rounded values.

    Raises:
        LinkageError: It is nothing of these; the message shows one of each.
        FileError: The file is neither a linkage nor a robot.
    """
    if isinstance(what, Path) or is_path(Kind.LINKAGES, what):
        return load_linkage(Path(what), tolerance)
    if holds(Kind.LINKAGES, what):
        return load_linkage(what, tolerance)
    if holds(Kind.ROBOTS, what):
        return load_linkage(find(Kind.ROBOTS, what), tolerance)
    if looks_like_pattern(what):
        return read_pattern(what, space)
    try:
        find(Kind.LINKAGES, what)
    except DhcliError as error:
        hint = f"a file ./my.yaml, a name such as bennett or puma560, or a pattern such as {EXAMPLES}"
        near = error.problems[0].hint.partition(";")[0]
        hint = f"{near}; {hint}" if near.startswith(("did", "'")) else hint
        raise LinkageError(f"'{what}' is no linkage, no robot and no pattern", hint) from None
    raise AssertionError(what)


def load_linkage(name: str | Path, tolerance: float = 0.0) -> Linkage | Counts:
    """Load a linkage by name or from a file; the file of a serial robot is read as one too.

    Args:
        name: A name of the library such as `bennett`, a path, or `-` for standard input.
        tolerance: Relative error of rounded values, for the closure of a loop of DH rows.

    Raises:
        UnknownNameError: No linkage has this name.
        FileError: The file is no linkage; every problem with file, line and column.
    """
    check_typed(Kind.LINKAGES, name)
    path = name if isinstance(name, Path) else find(Kind.LINKAGES, name)
    text = read_text("-" if str(path) == "-" else path)
    return read_linkage(text, source_of(path), "stdin" if str(path) == "-" else path.stem, tolerance)


def read_linkage(text: str, source: str, name: str, tolerance: float = 0.0) -> Linkage | Counts:
    """Read a linkage from the text of a file.

    Raises:
        FileError: With all problems.
    """
    if is_xml(text):
        return _serial(text, source, name)
    refused: list[Problem] = []
    root = read_yaml(text, source, refused)
    if isinstance(root, PlacedMapping) and "variables" in {key.text for key, _ in root.entries}:
        return _serial(text, source, name)  # what was refused stands in its own error
    return _Loader(root, name, tolerance, refused).linkage()


def _serial(text: str, source: str, name: str) -> Linkage:
    """The robot in a file, YAML or URDF, as an open chain."""
    from dhcli.files.yaml.robots import robot_of

    return open_chain(robot_of(text, source, name), source)


def open_chain(robot: Robot, source: str) -> Linkage:
    """A robot as a linkage; the source is what it is called in errors.

    Raises:
        FileError: It has no joint.
    """
    pairs = tuple(LETTERS[letter] for letter in robot.pattern)
    if not pairs:
        raise FileError(Problem(f"{robot.name} has no joint, so there is nothing to count", Place(source)))
    return serial(robot.name, pairs, title=robot.title, source=robot.source)


class _Loader:
    """One pass over a file; what is wrong is collected, and something harmless taken in its place."""

    def __init__(self, root: PlacedNode, name: str, tolerance: float, refused: list[Problem]) -> None:
        self.problems = Problems(refused)
        self.name = name
        self.tolerance = tolerance
        self.fields = self.problems.document(root, known=names(LINKAGE), required=required(LINKAGE))
        self.space = self.read_space()
        self.numbers = Coordinates(
            self.problems, self.fields.mapping("let"), self.fields.mapping("points"), planar=self.space.is_planar
        )

    def linkage(self) -> Linkage | Counts:
        forms = [key for key in FORMS if key in self.fields]
        if len(forms) != 1:
            wanted = "joints, chain, bars or loop"
            message = (
                f"{' and '.join(forms)}: only one form of a linkage may stand here"
                if forms
                else f"no linkage: give {wanted}"
            )
            self.problems.add(self.fields.place_of(forms[-1]) if forms else self.fields.place, message)
            self.problems.raise_if_any()
        if isinstance(self.fields.get("joints"), PlacedScalar):
            return self.counts()
        if "links" in self.fields:
            self.problems.add(self.fields.place_of("links"), "links: is counted from the joints", "leave it out")
        reader = JointReader(self.fields, self.numbers, self.space, self.tolerance)
        joints = reader.read(forms[0])
        self.problems.raise_if_any()
        known = {link for joint in joints for link in joint.links}
        ground = self.fields.text("ground") or ("ground" if "ground" in known else "")
        texts = {key: self.fields.text(key) for key in ("title", "source", "notes", "output")}
        try:
            named = tuple(NamedPoint(n, at, reader.loose.get(n, "")) for n, at in self.numbers.points.items())
            return Linkage(self.name, self.space, tuple(joints), ground, **texts, points=named)
        except InvalidLinkageError as error:
            for finding in error.findings:
                key, index = str(finding.where[0]), finding.where[-1]
                place = (
                    reader.places[index]
                    if isinstance(index, int)
                    else self.fields.place_of(key if key in self.fields else forms[0])
                )
                self.problems.add(place, finding.message, finding.hint)
            self.problems.raise_if_any()
            raise

    def read_space(self) -> Space:
        keys = [key for key in ("space", "lambda") if key in self.fields]
        if len(keys) != 1:
            message = "space and lambda say the same thing" if keys else "space: is missing"
            self.problems.add(
                self.fields.place, message, "write space: planar, spherical or spatial, or lambda: 1 to 6"
            )
            return PLANAR  # where two coordinates do, and three are no slip
        scalar = self.fields.scalar(keys[0])
        try:
            return space_of(scalar.text) if scalar else PLANAR
        except LinkageError as error:
            self.add_at(scalar.place if scalar else self.fields.place, error, keys[0])
            return PLANAR

    def counts(self) -> Counts:
        """`links: 4` and `joints: 4R`; both may hold names."""
        joints, links = self.fields.scalar("joints"), self.fields.scalar("links")
        if links is None and "links" not in self.fields:
            self.problems.add(
                self.fields.place, "links: is missing", "the number of links with the ground; or list the joints"
            )
        self.problems.raise_if_any()
        assert joints is not None  # noqa: S101  the caller has looked
        assert links is not None  # noqa: S101  its problem has been raised
        try:
            n = count_of(links.text, links.place_of(0))
            return counts(self.space, n, joint_counts(joints.text, joints.place), self.fields.text("title"))
        except DhcliError as error:
            self.add_at(joints.place, error)
            self.problems.raise_if_any()
            raise

    def add_at(self, place: Place, error: DhcliError, key: str = "") -> None:
        for problem in error.problems:
            self.problems.add(
                problem.place or place, f"{key}: {problem.message}" if key else problem.message, problem.hint
            )
