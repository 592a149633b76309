"""How one robot file writes its angles, lengths and moves."""

from __future__ import annotations

from dhcli.errors import NotationError
from dhcli.files.yaml.fields import Problems
from dhcli.files.yaml.placed import PlacedScalar
from dhcli.files.yaml.typed import NOTHING, read_value
from dhcli.frozen import frozen
from dhcli.kinematics.derived import Value
from dhcli.kinematics.moves import Chain, read_chain, sharpened
from dhcli.notation.scope import Scope


@frozen
class Reader:
    """Reads the values and the moves of one file.

    Attributes:
        problems: Where to note what is wrong.
        scope: The names that the file declares.
        remarks: Where to say that 1.5708 rad was taken as 90°; None to take angles as they stand.
        unit: The unit of a bare length; empty for metres.
    """

    problems: Problems
    scope: Scope
    remarks: list[str] | None
    unit: str

    def value(self, scalar: PlacedScalar, key: str, *, is_angle: bool, scope: Scope = NOTHING) -> Value | None:
        """An angle or a length [m], constant but for the names of a scope; None if it is neither."""
        return read_value(
            self.problems, scalar, key, is_angle=is_angle, scope=scope, remarks=self.remarks, unit=self.unit
        )

    def moves(self, scalar: PlacedScalar) -> Chain:
        """A product of moves; none where it cannot be read."""
        try:
            chain = read_chain(scalar.text, self.scope, scalar.place_of(0), self.remarks, self.unit)
            return sharpened(chain, self.remarks)
        except NotationError as error:
            self.problems.take(error)
            return ()
