"""A tape made ready to be played: only the steps that are needed, on as few registers as will do."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeAlias

from dhcli.algebra.tape import Cell, Column, Number, Operation, Tape
from dhcli.frozen import frozen

Register: TypeAlias = int


@frozen
class Instruction:
    """A step on registers.

    Attributes:
        ufunc: The operation by its name in numpy.
        operands: Registers or constants; the last one is the register that is written, perhaps one that is read.
    """

    ufunc: str
    operands: tuple[Register | float, ...]


@frozen
class Program:
    """Instructions. The first registers end as the results, the next ones begin as the joint values.

    Attributes:
        registers: How many there are.
        inputs: Which of them hold the joint values, in their order.
        constants: Results that no joint moves, by their register.
        instructions: What to do, in order.
    """

    registers: int
    inputs: slice
    constants: dict[Register, float]
    instructions: tuple[Instruction, ...]


def assemble(tape: Tape, results: Sequence[Number]) -> Program:
    """Give every column of a tape a register, and the same one to columns that are not needed at the same time."""
    constants = {k: result for k, result in enumerate(results) if not isinstance(result, Cell)}
    wanted = {k: tape.column(result) for k, result in enumerate(results) if isinstance(result, Cell)}
    inputs = slice(len(results), len(results) + len(tape.variables))
    homes = {cell.column: inputs.start + k for k, cell in enumerate(tape.variables.values())}
    homes.update((column, k) for k, column in wanted.items() if column not in homes)
    kept = needed(tape, wanted.values())
    uses = {column: step.columns for column, step in kept.items()}
    last_use = {operand: column for column, operands in uses.items() for operand in operands}
    stay = set(wanted.values())
    top, free = inputs.stop, set[Register]()
    instructions = []
    for column, step in kept.items():
        operands = tuple(homes[o] if isinstance(o, Column) else o for o in step.operands)
        if column not in homes:
            homes[column] = free.pop() if free else top
            top = max(top, homes[column] + 1)
        free.update(homes[o] for o in uses[column] if last_use[o] == column and o not in stay)
        instructions.append(Instruction(step.ufunc, (*operands, homes[column])))
    for k, column in wanted.items():
        if homes[column] != k:  # the same number twice, or a joint value as it is
            instructions.append(Instruction("positive", (homes[column], k)))
    return Program(top, inputs, constants, tuple(instructions))


def needed(tape: Tape, columns: Iterable[Column]) -> dict[Column, Operation]:
    """The steps that lead to some columns, in their order."""
    needed = set(columns)
    kept = {}
    for step, column in reversed(tape.steps.items()):
        if column in needed:
            needed.update(step.columns)
            kept[column] = step
    return dict(reversed(kept.items()))
