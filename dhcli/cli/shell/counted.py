"""What `dof` was asked about: a file, a name, a pattern, or bare counts."""

from __future__ import annotations

from dhcli.errors import DhcliError, Place, Problem
from dhcli.files.yaml.linkages import find_linkage, open_chain
from dhcli.frozen import frozen
from dhcli.mobility.counting import Counts, counts
from dhcli.mobility.linkage import Linkage
from dhcli.mobility.pairs import PLANAR, SPATIAL, LinkageError, Space, space_of
from dhcli.mobility.patterns import count_of, joint_counts


@frozen
class Ends:
    """Which chain of a URDF is meant.

    Attributes:
        base: The link that it begins with; None for the root.
        tip: The link that it ends with; None for the only one there is.
    """

    base: str | None = None
    tip: str | None = None


def asked(
    what: str,
    ends: Ends,
    *,
    planar: bool,
    lambda_: str | None,
    links: str | None,
    joints: str | None,
    tolerance: float,
) -> Linkage | Counts:
    """The linkage, or the counts, that the words and options describe.

    Raises:
        DhcliError: They contradict each other, or describe nothing.
    """
    if planar and lambda_ is not None:
        raise DhcliError("--planar and --lambda say the same thing", "use one of them")
    space = _space(lambda_, planar=planar)
    if what:
        if links is not None or joints is not None:
            raise DhcliError(f"--links and --joints describe a linkage, and so does {what}", "give one or the other")
        if ends == Ends():
            found = find_linkage(what, space or SPATIAL, tolerance)
        else:
            from dhcli.files.yaml.robots import load_robot  # few linkages are chains of a URDF

            found = open_chain(load_robot(what, base=ends.base, tip=ends.tip), what)
        if space is not None and isinstance(found, Linkage) and not found.reading:
            raise DhcliError(f"{what} says itself where it moves: {found.space}", "leave --planar and --lambda out")
        return found
    if ends != Ends():
        raise DhcliError("--base and --tip are links of a URDF", "write dhcli dof arm.urdf --tip tool0")
    if links is None or joints is None:
        missing = "--links" if joints is not None else "--joints" if links is not None else ""
        if missing:
            raise DhcliError(f"{missing} is missing", "write --planar --links 4 --joints 4R")
        raise DhcliError("nothing to count", "write dhcli dof bennett, dhcli dof 6R, or --planar --links 4 --joints 4R")
    place = Place("--joints", None, None, joints)
    n = count_of(links, Place("--links", None, 1, links))
    return counts(space or SPATIAL, n, joint_counts(joints, place), f"{links} links, {joints}")


def _space(lambda_: str | None, *, planar: bool) -> Space | None:
    if lambda_ is None:
        return PLANAR if planar else None
    try:
        return space_of(lambda_)
    except LinkageError as error:
        place = Place("--lambda", None, None, lambda_)
        raise LinkageError(Problem(p.message, place, p.hint) for p in error.problems) from None
