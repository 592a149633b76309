"""One serial chain of a URDF, from a base link to a tip link."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from dhcli.errors import FileError, Place, Problem, UnknownNameError, did_you_mean, listed
from dhcli.files.reading import source_of
from dhcli.files.urdf.model import KINDS, Joint, Mimic, Model
from dhcli.kinematics.given import text_of
from dhcli.regex import regex

_HAND = regex(r"(?i:tcp|tool|flange|ee(?:f|_|$))")
"""In the name of the link that people mean by the end of an arm, and not a finger."""


def chain_of(model: Model, base: str | None, tip: str | None = None) -> tuple[Joint, ...]:
    """The joints from the base to the tip.

    Args:
        model: What the URDF says.
        base: The link to begin with; by default the one that no joint moves.
        tip: The link to end with; by default the only one at the end of a chain that moves.

    Raises:
        FileError: Links and joints are no tree, or the chain has a joint of another kind.
        UnknownNameError: There is no such link, or the tip is not below the base.
    """
    above = _tree(model)
    start = _root(model, above) if base is None else _link(model, base, "base")
    end = _tip(model, above, start) if tip is None else _link(model, tip, "tip")
    joints = _up(above, end, start)
    if joints is None:
        raise UnknownNameError(f"{end} is not below {start}", f"below it: {listed(_leaves(model, above, start))}")
    if not joints:
        raise UnknownNameError(f"{end} is the base itself", f"--tip {listed(_leaves(model, above, start))}")
    for joint in joints:
        if joint.kind not in KINDS:
            hint = f"choose a chain without it, or make it one of {', '.join(KINDS)}"
            raise FileError(
                Problem(f"joint {joint.name} is {joint.kind}, which is no joint of one variable", joint.place, hint)
            )
    return joints


def with_leaders(joints: tuple[Joint, ...], beside: frozenset[str]) -> tuple[tuple[Joint, ...], list[str]]:
    """A chain of which no joint follows one beside it, and what was changed for that.

    The first that follows such a joint, as one finger of a hand follows the other, has a variable of its own, and
    others that follow the same one follow it.
    """
    own, told, leaders = list[Joint](), list[str](), dict[tuple[str, str], tuple[Joint, Mimic]]()
    for joint in joints:
        mimic = joint.mimic
        if mimic is None or mimic.joint not in beside:
            own.append(joint)
        elif (joint.kind, mimic.joint) in leaders:
            leader, way = leaders[joint.kind, mimic.joint]
            share = Fraction(mimic.multiplier) / Fraction(way.multiplier)
            offset = Fraction(mimic.offset) - share * Fraction(way.offset)
            own.append(replace(joint, mimic=Mimic(leader.name, str(share), str(offset))))
        else:
            if Fraction(mimic.multiplier):
                leaders[joint.kind, mimic.joint] = joint, mimic
            own.append(replace(joint, mimic=None))
            told.append(f"{joint.name} follows {mimic.joint}, which is not on this chain: it has a variable of its own")
    return tuple(own), told


def _tree(model: Model) -> dict[str, Joint]:
    """The joint above each link that has one."""
    above: dict[str, Joint] = {}
    for joint in model.joints:
        for what, name in (("parent", joint.parent), ("child", joint.child)):
            if name not in model.links:
                hint = did_you_mean(name, model.links)
                raise FileError(Problem(f"joint {joint.name}: its {what} {name} is no link", joint.place, hint))
        if joint.child in above:
            message = f"joint {joint.name}: link {joint.child} is moved by {above[joint.child].name} already: a loop"
            raise FileError(Problem(message, joint.place, "a URDF is a tree; dhcli dof counts linkages with loops"))
        above[joint.child] = joint
    for link in model.links:
        seen, here = {link}, link
        while here in above:
            here = above[here].parent
            if here in seen:
                raise FileError(Problem(f"link {here} is below itself: a loop", above[here].place, "a URDF is a tree"))
            seen.add(here)
    return above


def _root(model: Model, above: dict[str, Joint]) -> str:
    roots = [link for link in model.links if link not in above]
    if not roots:
        raise FileError(Problem("has no link", Place(model.source)))
    if len(roots) > 1:
        moved = [link for link in roots if any(joint.parent == link for joint in model.joints)]
        if len(moved) == 1:
            return moved[0]
        raise FileError(Problem(f"has {len(roots)} links that hang on nothing: {listed(roots)}", Place(model.source)))
    return roots[0]


def tips_of(model: Model) -> list[str]:
    """The links at the ends of chains that move, from the root.

    Raises:
        FileError: Links and joints are no tree.
    """
    above = _tree(model)
    return _moving(model, above, _root(model, above))


def _moving(model: Model, above: dict[str, Joint], start: str) -> list[str]:
    leaves = _leaves(model, above, start)
    return [leaf for leaf in leaves if any(joint.kind != "fixed" for joint in _up(above, leaf, start) or ())]


def _tip(model: Model, above: dict[str, Joint], start: str) -> str:
    moving = _moving(model, above, start)
    if len(moving) == 1:
        return moving[0]
    if not moving:
        raise FileError(Problem(f"nothing below {start} moves", Place(model.source)))
    from shlex import quote  # few robots have two

    typed = "-" if model.source == source_of("-") else quote(model.source)
    likely = next((tip for tip in moving if _HAND.search(tip)), moving[0])
    made = f"dhcli new robot --from {typed} --tip {quote(likely)} makes a file of one"
    hint = f"--tip {listed(moving)}; {made}"
    raise FileError(Problem(f"has {len(moving)} tips: which one?", Place(model.source), hint))


def _leaves(model: Model, above: dict[str, Joint], start: str) -> list[str]:
    parents = {joint.parent for joint in model.joints}
    return [link for link in model.links if link not in parents and _up(above, link, start) is not None]


def _up(above: dict[str, Joint], end: str, start: str) -> tuple[Joint, ...] | None:
    """The joints between two links, None if the one is not below the other."""
    joints: list[Joint] = []
    while end != start:
        if end not in above:
            return None
        joints.append(above[end])
        end = above[end].parent
    return tuple(reversed(joints))


def _link(model: Model, name: str, what: str) -> str:
    if text_of(name, what) not in model.links:
        hint = did_you_mean(name, model.links) or f"links: {listed(list(model.links))}"
        raise UnknownNameError(Problem(f"there is no link {name}", Place(f"--{what}"), hint))
    return name
