"""A program played over a grid: each step over the axes that it depends on, and no others."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from dhcli.algebra.program import Program

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Axes: TypeAlias = NDArray[np.float64] | np.float64

Node: TypeAlias = int
"""A number of the program by its place: first the variables, then one for each step."""


class Spread:
    """A program over a grid of which some axes stay as they are, and the others are given part by part.

    What only the axes that stay lead to is worked out once.
    """

    def __init__(self, program: Program, staying: Mapping[int, Axes]) -> None:
        """Work out what can be by now.

        Args:
            program: What to play.
            staying: The values of some variables, by their number; arrays that broadcast against one another and
                against those that come later.
        """
        count = program.inputs.stop - program.inputs.start
        homes = dict(enumerate(range(count), program.inputs.start))  # the node that stands in each register by now
        self._known: dict[Node, Axes] = dict(staying)
        self._steps: list[tuple[np.ufunc, list[Node | float], Node]] = []
        for node, step in enumerate(program.instructions, count):
            *read, written = step.operands
            operands: list[Node | float] = [
                homes[operand] if isinstance(operand, int) else float(operand) for operand in read
            ]
            ufunc = getattr(np, step.ufunc)
            if all(not isinstance(operand, int) or operand in self._known for operand in operands):
                with np.errstate(all="ignore"):
                    self._known[node] = ufunc(*(self._known[o] if isinstance(o, int) else o for o in operands))
            else:
                self._steps.append((ufunc, operands, node))
            homes[int(written)] = node
        self._results = [
            program.constants[k] if k in program.constants else homes[k] for k in range(program.inputs.start)
        ]
        last = {operand: node for _, operands, node in self._steps for operand in operands if isinstance(operand, int)}
        self._done: dict[Node, list[Node]] = {node: [] for _, _, node in self._steps}
        for operand, node in last.items():
            if operand not in self._results:
                self._done[node].append(operand)

    def play(self, moving: Mapping[int, Axes]) -> list[Axes]:
        """The results for a part of the grid, each over the axes that it depends on.

        Args:
            moving: The values of the other variables there.
        """
        values = self._known | dict(moving)
        with np.errstate(all="ignore"):
            for ufunc, operands, node in self._steps:
                values[node] = ufunc(*(values[o] if isinstance(o, int) else o for o in operands))
                for operand in self._done[node]:  # its memory is used again while it is in the cache
                    del values[operand]
        return [values[found] if isinstance(found, int) else np.float64(found) for found in self._results]
