"""What is found out about a linkage; a plain value that knows no numpy."""

from __future__ import annotations

from dhcli.frozen import frozen
from dhcli.mobility.counting import Counts
from dhcli.mobility.linkage import Linkage


@frozen
class Mobility:
    """Counts, formula, truth, and why they differ. Mobility is a property of the given position and assembly.

    Attributes:
        counts: What went into the formula.
        linkage: The joint graph; None where only counts were given.
        other: The counts if a pattern is read the other way.
        mobility: Freedoms that it truly has; None if it is undecided or there is no geometry.
        bounds: Lowest and highest possible mobility, where something is known.
        certificate: How the mobility is known: `exact: ...`, `numerical: ...`, `undecided: ...`; empty without.
        instantaneous: Freedoms at this instant, Σf less the rank.
        idle: The idle freedoms, in words; they count in both numbers.
        lambdas: λ of each loop, as its own motions span it.
        redundant: Constraints that repeat others: the mobility less the F of the formula.
        output: The link whose motion is described.
        motion: Type of its motion such as `3T0R`: independent translations, then rotations.
        branches: Dimensions of the different families of motions through this position.
        order: The power of the amplitude with which a shaky structure resists; 2 is the usual one.
        singular_values: Of the loop equations, relative to the largest, largest first.
        kept: The smallest of them that counts as not zero.
        dropped: The largest of them that counts as zero.
        reasons: Why the formula and the truth differ, or what else is special here, in sentences.
        settles: What this input could settle, in a sentence.
    """

    counts: Counts
    linkage: Linkage | None = None
    other: Counts | None = None
    mobility: int | None = None
    bounds: tuple[int, int] | None = None
    certificate: str = ""
    instantaneous: int | None = None
    idle: tuple[str, ...] = ()
    lambdas: tuple[int, ...] = ()
    redundant: int | None = None
    output: str = ""
    motion: str = ""
    branches: tuple[int, ...] = ()
    order: int | None = None
    singular_values: tuple[float, ...] = ()
    kept: float | None = None
    dropped: float | None = None
    reasons: tuple[str, ...] = ()
    settles: str = ""

    def __repr__(self) -> str:
        """One line, as the prompt shows it; `dhcli dof` and the attributes have the rest."""
        found = "unknown" if self.mobility is None else self.mobility
        return f"<Mobility of {self.counts.title or 'a linkage'}: {found}; by the formula {self.counts.by_freedoms}>"

    @property
    def gruebler(self) -> int | None:
        """F of the formula; None where it is itself a formula in names."""
        return self.counts.gruebler

    @property
    def formula_holds(self) -> bool | None:
        """Whether the formula gives the true mobility; None if that is not known."""
        return None if self.mobility is None or self.gruebler is None else self.mobility == self.gruebler
