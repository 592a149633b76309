"""The constraint form of a linkage as one dense matrix: what its elimination link by link is compared with."""

from __future__ import annotations

import numpy as np

from dhcli.geometry.rank import TIGHT, Rank, rank_of
from dhcli.geometry.twists import Array
from dhcli.mobility.constraints import constraints
from dhcli.mobility.model import Model


def constraint_rank(model: Model, tolerance: float = TIGHT) -> tuple[Rank, int]:
    """The rank of all constraints, and the instantaneous mobility that it leaves."""
    matrix = constraint_matrix(model)
    found = rank_of(matrix, tolerance)
    return found, matrix.shape[1] - found.rank


def constraint_matrix(model: Model) -> Array:
    """All constraints, shape (ΣC, λ(n - 1))."""
    size = len(model.basis)
    found = []
    for rows in constraints(model):
        block = np.zeros((len(rows.block), size * (len(model.linkage.links) - 1)))
        for k, link in enumerate(rows.links):
            block[:, size * (link - 1) : size * link] = rows.block[:, size * k : size * (k + 1)]
        found.append(block)
    return np.concatenate(found) if found else np.zeros((0, 0))
