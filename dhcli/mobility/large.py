"""Long chains: the constraint form, with the links eliminated one after the other.

A front holds the equations that touch links not yet finished. Orthogonal elimination (QR) of one link at a time leaves
a triangular factor with small blocks; its smallest singular values, those that decide the rank, come from inverse
iteration, which costs a few passes over the blocks. Work grows linearly with the length of a chain.

Source: George and Heath 1980, sparse orthogonal factorisation; inverse iteration as in Golub and Van Loan, section 8.2.
"""

from __future__ import annotations

from itertools import accumulate

import numpy as np

from dhcli.errors import Problem
from dhcli.frozen import frozen
from dhcli.geometry.rank import TIGHT, Rank, rank_of
from dhcli.geometry.twists import Array
from dhcli.mobility.constraints import Rows, constraints
from dhcli.mobility.decision import Truth, certain
from dhcli.mobility.draws import Draws
from dhcli.mobility.loops import closure, lambdas
from dhcli.mobility.model import Model
from dhcli.mobility.pairs import LinkageError

WIDEST = 1200
"""Columns of a front; a linkage with a wider one is no long chain."""

MOST = 2500
"""Equations of loops that a plain singular value decomposition takes in seconds."""

NEAR = 1e-8
"""A value of theirs that is kept and below this is looked at by links: it falls with the cube of a chain's length."""

SMALLEST = 12
"""Singular values that are looked for beside the freedoms that the formula counts; more where there are more."""

A_LINK, A_VALUE = 2e6, 1.5e4
"""What a link costs when it is eliminated, and for each value looked for, in multiplications of a decomposition."""

PASSES = 12
POWERS = 15
FLAT = 3
ZERO = 1e-10
"""Relative to the largest, below this a singular value of a long chain counts as zero; it is also the shift."""


@frozen
class Block:
    """One link's part of the triangular factor: `R x_link + rest x_others = 0`.

    Attributes:
        link: Place of the link among the unknowns.
        own: Inverse of the triangular block, shape (λ, λ).
        others: Places of the links it still depends on.
        rest: Shape (λ, λ · others).
    """

    link: int
    own: Array
    others: tuple[int, ...]
    rest: Array


def large_mobility(model: Model, tolerance: float = 0.0) -> Truth:
    """The mobility of a linkage with many links, where the rank alone settles it; undecided otherwise.

    Few loops have few equations, however long they are: then the loop form is the smaller one. It is so, too, where
    the links hang together like a net: their loops are short, and their fronts wide.
    """
    rank = rank_of(model.jacobian(), max(TIGHT, tolerance)) if _is_small_by_loops(model) else None
    if rank is None or (rank.kept is not None and rank.kept < NEAR):
        rank = _rank_of_links(model, tolerance)
    zeros, loops = model.motions - rank.rank, _lambdas(model)
    certificate = certain(model, rank, sum(loops) + len(model.ties), zeros)
    if certificate:
        return Truth(model, rank, zeros, loops, zeros, (zeros, zeros), certificate)
    words = "undecided: the loop equations are dependent, and of so many parts amplitudes are not tried"
    return Truth(model, rank, zeros, loops, None, (0, zeros), words)


def _is_small_by_loops(model: Model) -> bool:
    """Whether the rank is sooner found by the equations of loops than by those of links."""
    front = len(model.basis) * _widest(model)
    by_links = len(model.tree) * (A_LINK + A_VALUE * _wanted(model) + front**3 / 2)
    return model.equations <= MOST and model.equations**2 * model.motions <= by_links


def _wanted(model: Model) -> int:
    """How many of the smallest singular values tell the freedoms, if the formula counts them rightly."""
    return max(0, model.motions - model.equations) + SMALLEST


def _rank_of_links(model: Model, tolerance: float) -> Rank:
    """The rank by the constraint form."""
    size, unknown = len(model.basis), len(model.basis) * (len(model.linkage.links) - 1)
    equations, largest = _placed(model)
    blocks = eliminate(equations, len(model.tree), size, ZERO * largest)
    wanted = _wanted(model)
    while True:
        values = smallest_values(blocks, equations, unknown, min(wanted, unknown)) / largest
        zeros = int(np.count_nonzero(values < max(ZERO, tolerance)))
        if zeros < len(values) or wanted >= unknown:
            break
        wanted *= 4
    kept = float(values[zeros]) if zeros < len(values) else None
    dropped = float(values[zeros - 1]) if zeros else None
    return Rank(model.motions - zeros, kept, dropped, tuple(map(float, values[::-1])))


def _widest(model: Model) -> int:
    """The most links that wait in a front at once, where they are eliminated in the order in which they hang together.

    A link waits from when the first of its neighbours is eliminated; a link of a gear's carrier may wait longer.
    """
    order = {0: -1} | {link: i for i, link in enumerate(_order(model))}
    first = {link: place for link, place in order.items() if link}
    for step in model.steps:
        for link, other in ((step.tail, step.head), (step.head, step.tail)):
            if link and other:
                first[link] = min(first[link], order[other])
    change = [0] * len(order)
    for link, place in first.items():
        change[place] += 1
        change[order[link]] -= 1
    return max(accumulate(change))


def _order(model: Model) -> list[int]:
    """The links but the ground in the order in which they hang together."""
    return [step.tail if backwards else step.head for step, backwards in model.tree]


def _lambdas(model: Model) -> tuple[int, ...]:
    """λ of each loop; in the plane one with two pins in different places has 3, which needs no computing."""
    turning = model.twists[:, 2] != 0
    if len(model.basis) > FLAT:
        return lambdas(model)
    found = []
    for row in model.signs != 0:
        pins = model.twists[row & turning]
        found.append(FLAT if len(pins) and np.ptp(pins, axis=0).max() > ZERO else closure(model.twists[row]))
    return tuple(found)


def _placed(model: Model) -> tuple[list[Rows], float]:
    """The constraints and their largest singular value; links are numbered in the order in which they hang together."""
    order = _order(model)
    place = {link: i for i, link in enumerate(order)}
    found = [Rows(tuple(place[link] for link in r.links), r.block) for r in constraints(model) if r.block.size]
    return found, _largest_value(found, len(model.basis), len(order))


def _largest_value(equations: list[Rows], size: int, links: int) -> float:
    """The largest singular value of all equations, by power iteration; a few digits are enough for a scale."""
    x = Draws(4).normal(links * size, 1)
    largest = 0.0
    for _ in range(POWERS):
        ahead = np.zeros_like(x)
        for rows in equations:
            image = rows.block.T @ (rows.block @ _gathered(x, rows.links, size))
            for k, link in enumerate(rows.links):
                ahead[link * size : (link + 1) * size] += image[k * size : (k + 1) * size]
        largest = float(np.linalg.norm(ahead))
        if not largest:
            return 1.0
        x = ahead / largest
    return float(np.sqrt(largest))


def eliminate(equations: list[Rows], links: int, size: int, shift: float) -> list[Block]:
    """Eliminate the links one after the other, with the equations `shift · x = 0` added.

    The shift keeps the factor regular, and changes no singular vector: inverse iteration can then run over it.

    Raises:
        LinkageError: The front becomes too wide.
    """
    waiting: dict[int, list[Rows]] = {link: [Rows((link,), shift * np.eye(size))] for link in range(links)}
    for rows in equations:
        waiting[min(rows.links)].append(rows)
    blocks = []
    for link in range(links):
        own = waiting.pop(link)
        others = tuple(sorted({other for rows in own for other in rows.links} - {link}))
        if len(others) * size > WIDEST:
            problem = Problem(
                f"more than {WIDEST // size} links hang together at once: this linkage is too large to analyse"
            )
            raise LinkageError(problem)
        factor = np.asarray(np.linalg.qr(_front(own, (link, *others), size), mode="r"), dtype=np.float64)
        blocks.append(
            Block(link, np.asarray(np.linalg.inv(factor[:size, :size]), dtype=np.float64), others, factor[:size, size:])
        )
        if others and len(factor) > size:
            waiting[others[0]].append(Rows(others, factor[size:, size:]))
    return blocks


def smallest_values(blocks: list[Block], equations: list[Rows], unknown: int, wanted: int) -> Array:
    """The smallest singular values of the equations in rising order, by subspace iteration with the inverse."""
    size = len(blocks[0].own)
    x = np.linalg.qr(Draws(2).normal(unknown, wanted))[0]
    for _ in range(PASSES):
        x = np.linalg.qr(_solved(blocks, _solved_transposed(blocks, x, size), size))[0]
    # rows of zeros: with fewer equations than columns there are singular values that are zero
    product = np.concatenate([np.zeros((wanted, wanted)), *(r.block @ _gathered(x, r.links, size) for r in equations)])
    return np.asarray(np.sort(np.linalg.svd(product, compute_uv=False)))


def _front(own: list[Rows], columns: tuple[int, ...], size: int) -> Array:
    at = {link: size * k for k, link in enumerate(columns)}
    front = np.zeros((sum(len(rows.block) for rows in own), size * len(columns)))
    row = 0
    for rows in own:
        for k, link in enumerate(rows.links):
            front[row : row + len(rows.block), at[link] : at[link] + size] = rows.block[:, k * size : (k + 1) * size]
        row += len(rows.block)
    return front


def _gathered(x: Array, links: tuple[int, ...], size: int) -> Array:
    if not links:
        return np.zeros((0, x.shape[1]))
    return np.concatenate([x[link * size : (link + 1) * size] for link in links])


def _solved(blocks: list[Block], right: Array, size: int) -> Array:
    """R x = right by back substitution; `own` holds the inverses."""
    x = right.copy()
    for block in reversed(blocks):
        at = slice(block.link * size, (block.link + 1) * size)
        x[at] = block.own @ (x[at] - block.rest @ _gathered(x, block.others, size))
    return x


def _solved_transposed(blocks: list[Block], right: Array, size: int) -> Array:
    """Rᵀ x = right by forward substitution."""
    x = right.copy()
    for block in blocks:
        at = slice(block.link * size, (block.link + 1) * size)
        x[at] = block.own.T @ x[at]
        moved = block.rest.T @ x[at]
        for k, link in enumerate(block.others):
            x[link * size : (link + 1) * size] -= moved[k * size : (k + 1) * size]
    return x
