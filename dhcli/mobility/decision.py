"""What is decided: first by the rank, then over all directions that were followed where the rank says nothing."""

from __future__ import annotations

import numpy as np

from dhcli.frozen import frozen
from dhcli.geometry.rank import Rank
from dhcli.geometry.twists import Array
from dhcli.mobility.branches import Branch
from dhcli.mobility.idle import Idle
from dhcli.mobility.landing import Path, Trial
from dhcli.mobility.model import Model
from dhcli.mobility.outputs import freedoms_of, motion_type
from dhcli.mobility.pebbles import generic_freedoms


@frozen
class Decision:
    """What was decided beyond the rank.

    Attributes:
        mobility: The true one; None if undecided.
        certificate: How it is known.
        motion: Type of the output link's motion.
        least: The smallest possible mobility where it is undecided.
        branches: Dimensions of the families of motion found.
        order: Power of the amplitude with which a shaky structure resists.
        landings: World twists at the landings on the largest branches.
        kinds: Types of the output link's motion on these.
    """

    mobility: int | None
    certificate: str
    motion: str = ""
    least: int = 0
    branches: tuple[int, ...] = ()
    order: int | None = None
    landings: tuple[Array, ...] = ()
    kinds: tuple[str, ...] = ()


@frozen
class Truth:
    """What the geometry says; see `Mobility` for the words.

    Attributes:
        model: The linkage in numbers.
        rank: The rank in the given position.
        instantaneous: Freedoms at this instant.
        lambdas: λ of each loop of the spanning tree.
        mobility: The true one; None if undecided.
        bounds: Lowest and highest possible mobility.
        certificate: How it is known.
        idle: Idle freedoms.
        passing: Motions of a part alone that exist in this position only, and are lost when the rest moves.
        branches: Dimensions of the families of motion found, with idle freedoms.
        order: Power of the amplitude with which a shaky structure resists.
        motion: Type of the output link's motion.
        kinds: Its types on the branches that meet here, where they have the same number of freedoms.
    """

    model: Model
    rank: Rank
    instantaneous: int
    lambdas: tuple[int, ...]
    mobility: int | None
    bounds: tuple[int, int]
    certificate: str
    idle: tuple[Idle, ...] = ()
    passing: tuple[Idle, ...] = ()
    branches: tuple[int, ...] = ()
    order: int | None = None
    motion: str = ""
    kinds: tuple[str, ...] = ()


@frozen
class Setting:
    """What was looked at.

    Attributes:
        model: The linkage.
        frozen: Orthonormal rows of the idle freedoms that are held.
        most: The instantaneous mobility without them, less what the second order test stops.
        tolerance: Relative error of rounded input; 0 for exact input.
        least: Power of A that a gap must grow with at least to speak against a motion.
    """

    model: Model
    frozen: Array
    most: int
    tolerance: float
    least: float


@frozen
class Landed:
    """A direction that was followed, and the family of motions that stands at its end."""

    path: Path
    branch: Branch

    def motion(self, setting: Setting) -> str:
        """The output link's motion on this branch."""
        branch = self.branch
        return motion_type(setting.model, branch.motions, branch.twists, blur=branch.blur, tolerance=setting.tolerance)


def certain(model: Model, rank: Rank, equations: int, instantaneous: int) -> str:
    """A certificate that needs no more than the rank and the joint graph; empty if there is none."""
    if not model.chords and not len(model.ties):
        return "exact: there is no loop, so every joint moves freely"
    if instantaneous == 0:
        return "exact: nothing can move, not even for an instant"
    if rank.rank == equations:
        return "exact: the loop equations are independent here, so every instantaneous motion goes on"
    if generic_freedoms(model) == instantaneous:
        return "exact: no other places of these joints leave fewer motions, so every instantaneous motion goes on"
    return ""


def decided(trials: list[Trial], landed: list[Landed], setting: Setting) -> Decision:
    """What is decided, first by the rank and then over all directions tried."""
    idle = len(setting.frozen)
    orders = [trial.order for trial in trials if trial.order is not None and trial.moves is False]
    order = round(float(np.median(orders))) if orders else None
    seen = [trial.order for trial in trials if trial.moves]
    if seen and all(power is not None and power > setting.least for power in seen):
        words = "undecided: within this tolerance a shaky structure cannot be told from a motion"
        return Decision(None, words, least=idle)
    if any(one.branch.dimension is not None for one in landed):
        return _moving(landed, order, setting)
    if orders and len(orders) == len(trials) and min(orders) > setting.least:
        words = f"numerical: the loops cannot close; the gap grows like the amplitude to the power {order}"
        return Decision(idle, words, motion_type(setting.model, setting.frozen.T), order=order)
    return Decision(None, "undecided: the loops neither close nor leave a gap with a clear trend", least=idle)


def _moving(landed: list[Landed], order: int | None, setting: Setting) -> Decision:
    """The verdict where at least one branch was reached."""
    idle, sizes = len(setting.frozen), [one.branch.dimension for one in landed]
    known = {size for size in sizes if size is not None}
    dimension, dimensions = max(known), tuple(sorted((size + idle for size in known), reverse=True))
    largest = [one for one, size in zip(landed, sizes, strict=True) if size == dimension]
    kinds = sorted({one.motion(setting) for one in largest}, key=lambda kind: (freedoms_of(kind), kind), reverse=True)
    best, motion = next(one for one in largest if one.motion(setting) == kinds[0]), kinds[0]
    found = dimension + idle
    if None in sizes and dimension < setting.most:
        words = "undecided: some motions were found whose number of freedoms stayed unclear"
        return Decision(None, words, motion, found, dimensions)
    if best.branch.exact and dimension == setting.most:
        words = "exact: the loop equations are independent at a position that was reached"
    elif best.branch.exact or setting.tolerance or best.path.goes_on():
        words = "numerical: the loops close to rounding at amplitudes 0.3, 0.1 and 0.03, and all round a place reached"
    else:
        words = "undecided: the loops seem to close, but leave a gap at larger amplitudes that grows by degrees"
        return Decision(None, words, least=idle)
    landings = tuple(one.branch.twists for one in largest)
    return Decision(found, words, motion, branches=dimensions, order=order, landings=landings, kinds=tuple(kinds))
