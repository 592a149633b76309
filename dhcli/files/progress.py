"""How far a student has come: the best verdict and the number of tries of each part.

One small file in the user's data folder, written whole or not at all. Whoever changes it holds its folder meanwhile, so
that twenty checks at once are twenty tries; where a system cannot hold folders, the last one wins.
"""

from __future__ import annotations

import errno
import json
import os
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

from dhcli.checking.verdicts import WORST_FIRST, Verdict
from dhcli.errors import FileError, Place, Problem
from dhcli.files.reading import read_text
from dhcli.frozen import frozen
from dhcli.storage.atomic import write_whole
from dhcli.storage.home import user_folder

FORMAT = 1
ORDER = (Verdict.SKIPPED.word, *(verdict.word for verdict in WORST_FIRST if verdict is not Verdict.SKIPPED))
"""Verdicts from worst to best; what was never tried is worst."""
PATIENCE = 5.0
"""Seconds after which somebody who holds a folder is taken for stuck; a change takes a few thousandths of one."""
_PAUSE = 0.005
_IS_HELD = {errno.EAGAIN, errno.EACCES}


@frozen
class Try:
    """What was reached at a part.

    Attributes:
        best: The word of the best verdict so far.
        tries: How often it was answered.
        hints: How many hints were shown.
    """

    best: str
    tries: int
    hints: int = 0


SOLVED = ("RIGHT", "EQUIVALENT")

Progress = Mapping[str, Mapping[str, Try]]
"""Parts by exercise."""


def path_of_progress() -> Path:
    """The file that holds the progress of this user."""
    return user_folder("XDG_DATA_HOME", ".local", "share") / "dhcli" / "progress.json"


def read_progress() -> tuple[Progress, str]:
    """The progress so far, and a message if it cannot be read; empty if all is well. A broken file is set aside."""
    path = path_of_progress()
    if not os.path.lexists(path):
        return {}, ""
    if not os.path.isfile(path):  # a pipe would be waited for
        return {}, _set_aside(path)
    try:
        content = json.loads(read_text(path, limit=4_000_000))
        if content["format"] != FORMAT:
            return {}, f"{path} was written by a newer dhcli; progress is not shown"
        return {
            str(exercise): {
                str(part): Try(_verdict(t["best"]), int(t["tries"]), int(t.get("hints", 0)))
                for part, t in parts.items()
            }
            for exercise, parts in content["exercises"].items()
        }, ""
    except (FileError, ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError):
        return {}, _set_aside(path)


def solved_parts(exercise: str) -> tuple[str, ...]:
    """The parts of an exercise that this user has solved; none if the progress cannot be read."""
    done = _progress_now().get(exercise, {})
    return tuple(part for part, reached in done.items() if reached.best in SOLVED)


@lru_cache(maxsize=1)
def _progress_at(_path: Path, _changed: int) -> Progress:
    return read_progress()[0]


def _progress_now() -> Progress:
    """The progress, read once as long as its file does not change."""
    path = path_of_progress()
    try:
        changed = os.stat(path).st_mtime_ns
    except OSError:
        return {}
    return _progress_at(path, changed)


def record(exercise: str, verdicts: Mapping[str, Verdict]) -> str:
    """Note the verdicts of a check; returns a message for the user, empty if all is well.

    A part that was skipped is not a try. A file of a newer format is left alone.
    """
    tried = {part: verdict.word for part, verdict in verdicts.items() if verdict is not Verdict.SKIPPED}

    def better(part: str, before: Try) -> Try:
        return replace(before, best=max(before.best, tried[part], key=ORDER.index), tries=before.tries + 1)

    return _change(exercise, tried, better) if tried else ""


def record_hint(exercise: str, part: str) -> str:
    """Note that one more hint was shown; returns a message for the user, empty if all is well."""
    return _change(exercise, (part,), lambda _, before: replace(before, hints=before.hints + 1))


def _change(exercise: str, parts: Iterable[str], change: Callable[[str, Try], Try]) -> str:
    path = path_of_progress()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with held(path.parent):
            return _change_held(path, exercise, parts, change)
    except (FileError, OSError) as error:
        return f"progress could not be saved: {error}"


def _change_held(path: Path, exercise: str, parts: Iterable[str], change: Callable[[str, Try], Try]) -> str:
    """Read the progress, change it and write it back, while nobody else does."""
    progress, message = read_progress()
    if message and os.path.lexists(path):  # of a newer dhcli, or it could not be set aside: it is not overwritten
        return message
    known = {name: dict(done) for name, done in progress.items()}
    own = known.setdefault(exercise, {})
    for part in parts:
        own[part] = change(part, own.get(part, Try("SKIPPED", 0)))
    content = {
        "format": FORMAT,
        "exercises": {
            name: {part: {"best": t.best, "tries": t.tries, "hints": t.hints} for part, t in done.items()}
            for name, done in known.items()
        },
    }
    write_whole(path, json.dumps(content, indent=1) + "\n", overwrite=True)
    return message


def _verdict(word: str) -> str:
    if word not in ORDER:
        raise ValueError(word)
    return word


def _set_aside(path: Path) -> str:
    """Move a broken file out of the way under a name that is free; what was done, for the user."""
    number = 1
    while os.path.lexists(aside := path.with_name(f"{path.name}.broken-{number}")):
        number += 1
    try:
        path.rename(aside)
    except OSError as error:
        return f"{path} could not be read, nor set aside: {error.strerror}; progress is neither shown nor saved"
    return f"{path} could not be read and was set aside as {aside.name}; progress starts anew"


@contextmanager
def held(folder: Path) -> Iterator[None]:
    """Hold a folder that exists.

    Raises:
        FileError: Somebody else does, and does not let go.
    """
    descriptor = _opened(folder)
    if descriptor is None:
        yield
        return
    try:
        _lock(descriptor, folder)
        yield
    finally:
        os.close(descriptor)  # which lets go


def _opened(folder: Path) -> int | None:
    """The folder as something that can be held; None where there is no such thing."""
    try:
        return os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    except (AttributeError, OSError):  # Windows knows no O_DIRECTORY
        return None


def _lock(descriptor: int, folder: Path) -> None:
    try:
        from fcntl import LOCK_EX, LOCK_NB, flock
    except ImportError:
        return
    until = time.monotonic() + PATIENCE
    while True:
        try:
            flock(descriptor, LOCK_EX | LOCK_NB)
        except OSError as error:
            if error.errno not in _IS_HELD:
                return  # this disk cannot
            if time.monotonic() > until:
                raise FileError(Problem("is held by another dhcli", Place(str(folder)))) from None
            time.sleep(_PAUSE)
        else:
            return
