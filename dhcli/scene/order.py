"""Which of several bodies is in front: by lines of sight through points all over them."""

from __future__ import annotations

from dhcli.scene.bodies import Body
from dhcli.scene.camera import Camera


def ordered(bodies: list[Body], camera: Camera) -> list[Body]:
    """Bodies from back to front."""
    seen = [_Seen(body, camera) for body in bodies]
    before = [[one is not other and one.is_behind(other, camera) for other in seen] for one in seen]
    left, found = set(range(len(bodies))), []
    while left:
        free = [i for i in left if not any(before[j][i] for j in left if j != i)] or list(left)
        first = min(free, key=lambda i: (camera.depth(bodies[i].centre), i))
        left.remove(first)
        found.append(bodies[first])
    return found


class _Seen:
    """A body with points of its surface, and the rectangle that they fill on paper."""

    def __init__(self, body: Body, camera: Camera) -> None:
        self.body, self.samples = body, body.samples()
        flats = [camera.flat_direction(point) for point in self.samples]
        self.low = min(x for x, _ in flats), min(y for _, y in flats)
        self.high = max(x for x, _ in flats), max(y for _, y in flats)

    def is_behind(self, other: _Seen, camera: Camera) -> bool:
        """Whether it hides less of another than that hides of it."""
        if any(self.high[i] < other.low[i] or other.high[i] < self.low[i] for i in (0, 1)):
            return False
        votes = 0
        for one, by, sign in ((self, other, 1), (other, self, -1)):
            for point in one.samples:
                span = by.body.span(point, camera.towards)
                if span is not None:
                    votes += sign if span[0] + span[1] > 0 else -sign
        return votes > 0
