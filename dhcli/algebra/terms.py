"""Our own terms: symbolic results in textbook form."""

from __future__ import annotations

from dhcli.algebra.arithmetic import right_angle
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Expr, Number, number
from dhcli.notation.trig import cosine, sine


class Terms:
    """Expressions; every name stands for itself."""

    def cos_sin(self, angle: Angle) -> tuple[Expr | int, Expr | int]:
        """`c1` and `s1`, or structural integers for right angles."""
        return right_angle(angle) or (cosine(angle), sine(angle))

    def length(self, expr: Expr) -> Expr | int:
        """The expression itself."""
        return 0 if type(expr) is Number and not expr.value else expr

    def constant(self, value: int) -> Expr:
        """A structural integer as a number in the tree."""
        return number(value)


TERMS = Terms()
