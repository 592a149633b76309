"""`dhcli transform`: products of moves, without a robot."""

from __future__ import annotations

from typing import Annotated

import typer

from dhcli.cli.shell.options import Forms, Settings
from dhcli.cli.shell.written import Shown

EXAMPLES = """
[bold]Examples[/]

dhcli transform "Trans(8,-6,14) Rot(y,90°) Rot(z,90°)" --steps

dhcli transform "Rot(z,theta1) Trans(l1,0,0)" --point 0,0,0.1
"""


def transform(
    product: Annotated[
        list[str],
        typer.Argument(
            metavar="PRODUCT", help="Moves and matrices, such as 'Trans(8,-6,14) Rot(y,90deg)'; - is stdin."
        ),
    ],
    steps: Annotated[bool, typer.Option("--steps", help="Every frame on the way.")] = False,
    fixed: Annotated[
        bool, typer.Option("--fixed", help="Moves are about the fixed frame, not the current one.")
    ] = False,
    symbolic: Annotated[bool, typer.Option("--symbolic", "-s", help="Stay exact, roots and all.")] = False,
    point: Annotated[
        list[str] | None, typer.Option(metavar="X,Y,Z", help="Where a point of the last frame is; repeatable.")
    ] = None,
    vector: Annotated[
        list[str] | None, typer.Option(metavar="X,Y,Z", help="A vector of the last frame, turned only; repeatable.")
    ] = None,
    symbols: Annotated[
        str | None, typer.Option(metavar="NAMES", help="Names that may stand in it besides l1, d_f, phi: shoulder,len.")
    ] = None,
    set_: Settings = None,
    as_: Forms = None,
    *,
    out: Shown,
) -> None:
    """Compose moves and matrices, in numbers or in symbols, and see where points go."""
    from dhcli.cli.shell.given import forms_of, names_of, point_of, product_of, settings_of
    from dhcli.errors import Place
    from dhcli.kinematics.transform import Wanted, compose, read_product, values_for
    from dhcli.notation.scope import usual

    kind = "steps" if steps else "transform"
    delivery = out.delivery("transform", kind)
    names = names_of(symbols or "", "--symbols")
    moves = read_product(*product_of(product), names)
    wanted = Wanted(
        "fixed" if fixed else "current",
        symbolic,
        [point_of(text, "--point", usual(names)) for text in point or []],
        [point_of(text, "--vector", usual(names)) for text in vector or []],
        forms_of(as_ or []),
    )
    values = values_for(moves, settings_of(set_ or []), Place("--set", text=" ".join(set_ or [])))
    result = compose(moves, values, wanted)
    delivery.hand_over(kind, result, result.warnings)
