"""A tape as formulas: they say what the fold computes, name what they share, and take no step for nothing."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from dhcli.algebra.arithmetic import evaluate_settled
from dhcli.algebra.floats import Floats
from dhcli.algebra.program import needed
from dhcli.algebra.tape import Cell
from dhcli.algebra.written import Lean, Written, written
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Chain, names
from dhcli.notation.tree import Call, Expr, Number, Power, Product, Sum, Symbol
from dhcli.notation.walk import symbols, walk
from tests.strategies import any_chains

drawn = st.floats(-3, 3).filter(lambda value: abs(value) > 1e-3)


def formulas_of(chain: Chain) -> Written:
    """The entries of the product of a chain."""
    tape = Lean(sorted(names(chain)))
    return written(tape, [entry for row in fold(chain, tape) for entry in row], {})


def played(formulas: Written, values: dict[str, float]) -> list[float]:
    """The results for values of the variables, definition by definition."""
    known = dict(values)
    for one in formulas.definitions:
        known[one.name] = evaluate_settled(one.expr, Floats(known))
    return [evaluate_settled(result, Floats(known)) for result in formulas.results]


@given(chain=any_chains, data=st.data())
def test_formulas_are_the_fold(chain: Chain, data: st.DataObject) -> None:
    """For any chain, at any values of its names."""
    values = {name: data.draw(drawn) for name in sorted(names(chain))}
    wanted = [entry for row in fold(chain, Floats(values)) for entry in row]
    found = played(formulas_of(chain), values)
    scale = 1 + max(map(abs, wanted))
    assert max(abs(a - b) for a, b in zip(found, wanted, strict=True)) <= 1e-13 * scale


@given(chain=any_chains)
def test_a_name_stands_before_it_is_used_and_for_something_shared(chain: Chain) -> None:
    """Names in order; each is used twice, or is a cosine or sine."""
    formulas = formulas_of(chain)
    known = set(names(chain))
    every: list[Expr] = [*(one.expr for one in formulas.definitions), *formulas.results]
    uses = [node.name for expr in every for node in walk(expr) if type(node) is Symbol]
    for one in formulas.definitions:
        assert symbols(one.expr) <= known
        assert one.name not in known
        known.add(one.name)
        assert uses.count(one.name) > 1 or (type(one.expr) is Call and uses.count(one.name) == 1)
    assert len({one.expr for one in formulas.definitions}) == len(formulas.definitions)


@given(chain=any_chains)
def test_no_step_adds_nothing(chain: Chain) -> None:
    """No 0 and no 1 stands in a sum or a product."""
    for expr in (*(one.expr for one in formulas_of(chain).definitions), *formulas_of(chain).results):
        for node in walk(expr):
            if type(node) is Sum:
                assert not any(type(term) is Number and term.value == 0 for term in node.terms)
            if type(node) is Product:
                assert not any(type(factor) is Number and factor.value in (0, 1) for factor in node.factors)


def test_a_lean_tape_takes_no_step_for_0_and_1() -> None:
    """Nor for what is subtracted from itself; a root below a line is 1 over a root."""
    tape = Lean(["x", "y"])
    x, y = tape.variables["x"], tape.variables["y"]
    assert x * 0.0 == 0.0
    assert x * 1.0 == x
    assert x + 0.0 == x
    assert x + -x == 0.0
    assert -x + 0.0 == -x
    assert not tape.steps
    root = tape.power(x * x + y * y, -0.5)  # type: ignore[arg-type, operator]  # a fraction in use
    formulas = written(tape, [root], {})
    assert played(formulas, {"x": 3.0, "y": 4.0}) == [0.2]
    assert any(type(node) is Power for node in walk(formulas.results[0]))
    assert isinstance(root, Cell)
    assert len(needed(tape, [root.column])) == 4


def test_the_cosine_of_a_sum_has_its_indices_in_order() -> None:
    """However it was added up: theta3 + theta2 is that of theta2 and theta3."""
    tape = Lean(["theta1", "theta2", "theta3"])
    one, two, three = (tape.variables[f"theta{k}"] for k in (1, 2, 3))
    pair = three + two
    whole = pair + one
    assert isinstance(pair, Cell)
    assert isinstance(whole, Cell)
    cosines = [tape.step("cos", angle.column) for angle in (pair, whole)]
    formulas = written(tape, cosines, {f"theta{k}": str(k) for k in (1, 2, 3)})
    assert {one.name for one in formulas.definitions} == {"q23", "c23", "c123"}
