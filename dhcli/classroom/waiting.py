"""What waits to be done by several, like beside like."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Hashable, Iterable, Sequence
from typing import Generic, TypeVar

Task = TypeVar("Task")


class Waiting(Generic[Task]):
    """Tasks that wait, each of a kind: whoever has begun with a kind knows what all of that kind need.

    So everyone goes on with the kind he has, takes then one that nobody has, and when there is none helps with the
    one of which most is left.
    """

    def __init__(self, tasks: Iterable[Task], alike: Callable[[Task], Hashable]) -> None:
        """Let tasks wait; those for which `alike` says the same are of a kind."""
        self._alike = alike
        self._count = 0
        self._kinds: dict[Hashable, deque[Task]] = {}
        self._held: dict[Hashable, Hashable] = {}
        for task in tasks:
            self._kind(task).append(task)

    def __len__(self) -> int:
        """How many there are."""
        return self._count

    def take(self, whose: Hashable) -> Task:
        """The next one for somebody.

        Raises:
            LookupError: None is left.
        """
        if not self._kinds:
            raise LookupError("nothing waits")
        kinds = self._kinds
        if self._held.get(whose, self) not in kinds:
            held = {*self._held.values()}
            most = max(kinds, key=lambda each: len(kinds[each]))
            self._held[whose] = next((each for each in kinds if each not in held), most)
        kind = self._held[whose]
        task = kinds[kind].popleft()
        self._count -= 1
        if not kinds[kind]:
            del kinds[kind]
        return task

    def give_back(self, whose: Hashable, tasks: Sequence[Task]) -> None:
        """Take back what somebody who is gone has not begun, to be done next."""
        self._held.pop(whose, None)
        for task in reversed(tasks):
            self._kind(task).appendleft(task)

    def _kind(self, task: Task) -> deque[Task]:
        """Where a task goes that is about to wait."""
        self._count += 1
        return self._kinds.setdefault(self._alike(task), deque())
