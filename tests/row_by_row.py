"""One test over a table of short cases, where pytest would start a test for each: that takes longer than the cases."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable
from functools import wraps
from typing import Any

import pytest

_OUTCOMES = (pytest.fail.Exception, pytest.skip.Exception, BaseExceptionGroup)
"""What ends a row besides an error: words of pytest, and a table of rows inside."""

SHOWN = 200
"""So many characters of a row are shown, and of what is wrong with it."""


def row_by_row(
    names: str | tuple[str, ...], rows: Iterable[Any]
) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Do as `pytest.mark.parametrize`, in one test: every row is tried, and all that fail are named.

    For rows of a millisecond that leave nothing behind; what a fixture gives is the same for all of them, and to skip
    one is a failure: it would skip the others too.
    """
    given = [name.strip() for name in names.split(",")] if isinstance(names, str) else list(names)
    table = [row if len(given) > 1 else (row,) for row in rows]
    assert table, "a test over no rows cannot fail"
    assert all(len(row) == len(given) for row in table), f"not every row has {', '.join(given)}"

    def over(test: Callable[..., None]) -> Callable[..., None]:
        @wraps(test)
        def every_row(**fixtures: object) -> None:
            failures = list[BaseException]()
            told = list[str]()
            for row in table:
                try:
                    test(**dict(zip(given, row, strict=True)), **fixtures)
                except (Exception, *_OUTCOMES) as error:  # noqa: BLE001  told below
                    failures.append(error)
                    told.append(
                        f"{_short(', '.join(map(repr, row)))}\n    {type(error).__name__}: {_short(str(error))}"
                    )
            if failures:
                count = f"{len(failures)} of {len(table)} rows fail:"
                raise BaseExceptionGroup("\n  ".join([count, *told]), failures)

        signature = inspect.signature(test)
        others = [parameter for name, parameter in signature.parameters.items() if name not in given]
        every_row.__signature__ = signature.replace(parameters=others)  # type: ignore[attr-defined]  # pytest's fixtures
        return every_row

    return over


def _short(text: str) -> str:
    return text if len(text) <= SHOWN else f"{text[:SHOWN]}..."
