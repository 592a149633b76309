"""When the compiled loop is loaded, from where, and what happens if that is broken."""

from __future__ import annotations

import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from dhcli.algebra import kernel as kernels
from dhcli.algebra.loop import loop

PLAYED = """
import numba, numpy, sys
from dhcli import forward_batch, load_robot
from dhcli.algebra import kernel
q = numpy.random.default_rng(1).uniform(-3, 3, (100, 3))
found = forward_batch(load_robot("scara"), q)
assert kernel._LOADED.loop is not None
print(sum(kernel._LOADED.loop.stats.cache_hits.values()), float(abs(found).sum()))
"""


@pytest.mark.nightly
@pytest.mark.skipif(find_spec("numba") is None, reason="the extra [fast] is not installed")
def test_what_is_kept_on_disk_is_used_and_made_again_where_it_is_broken_or_old(tmp_path: Path) -> None:
    """Compiled the first time, read the second; index or code cut short, or of another numba: compiled again."""
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)}

    def run() -> tuple[int, str]:
        program = [sys.executable, "-c", PLAYED]
        done = subprocess.run(program, env=environment, capture_output=True, encoding="utf-8", check=False)
        assert done.returncode == 0, done.stderr
        hits, total = done.stdout.split()
        return int(hits), total

    first, total = run()
    assert first == 0
    assert run() == (2, total)
    for suffix, text in (("nbi", b""), ("nbc", b"\x80nonsense"), ("nbi", b"\x80\x05\x8c\x060.0.01\x94.")):
        for file in tmp_path.rglob(f"*.{suffix}"):
            file.write_bytes(text)
        assert run()[1] == total
        assert run() == (2, total)


def test_numba_is_loaded_when_it_pays(monkeypatch: pytest.MonkeyPatch) -> None:
    """Not for a few rows; for many, at once or over time; and not looked for again where it is not found."""
    asked = []
    monkeypatch.setattr(kernels, "_compiled_loop", lambda: asked.append(1))
    monkeypatch.delitem(sys.modules, "numba", raising=False)
    loader = kernels._Loader()
    assert not loader.is_ready(kernels.PAYS // 2)
    assert asked == []
    assert not loader.is_ready(kernels.PAYS // 2)
    assert asked == [1]
    assert not loader.is_ready(kernels.PAYS)
    assert asked == [1]


def test_without_numba_there_is_no_compiled_loop(monkeypatch: pytest.MonkeyPatch) -> None:
    """None is found, or one that does not go with this numpy."""
    monkeypatch.setattr(kernels, "find_spec", lambda name: None)
    assert kernels._compiled_loop() is None
    monkeypatch.setattr(kernels, "find_spec", lambda name: object())
    monkeypatch.setitem(sys.modules, "numba", None)
    assert kernels._compiled_loop() is None


class Numba:
    """What stands for numba where only the way around it is tested: it cannot read what it kept, so many times."""

    float64 = float32 = None

    def __init__(self, folder: Path, fails: int) -> None:
        """Keep things in a folder."""
        self.folder, self.fails = folder, fails

    def njit(self, *, cache: bool, **options: object) -> Any:  # noqa: ANN401
        """The decorator."""

        def compile_(signature: object) -> None:
            if cache and self.fails:
                self.fails -= 1
                raise EOFError

        stats = SimpleNamespace(cache_path=str(self.folder))
        return lambda function: SimpleNamespace(
            compile=compile_, stats=stats, disable_compile=lambda: None, function=function, cache=cache
        )


@pytest.mark.parametrize(("fails", "is_kept"), [(0, True), (1, True), (2, False)])
def test_what_cannot_be_read_is_removed_and_compiled_again(
    fails: int, is_kept: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Only what is kept of the loop; and where nothing can be kept, it is compiled without."""
    monkeypatch.setattr(kernels, "find_spec", lambda name: object())
    monkeypatch.setattr(kernels, "_signature", lambda kind: None)
    monkeypatch.setitem(sys.modules, "numba", Numba(tmp_path, fails))  # type: ignore[arg-type]
    for name in (
        "loop.loop-34.py311.nbi",
        "loop.loop-34.py311.1.nbc",
        "loop.other-3.py311.nbi",
        "loop.cpython-311.pyc",
    ):
        (tmp_path / name).touch()
    found = kernels._compiled_loop()
    assert found.function is loop
    assert found.cache is is_kept
    kept = {file.name for file in tmp_path.iterdir()}
    assert {"loop.other-3.py311.nbi", "loop.cpython-311.pyc"} <= kept
    assert (len(kept) == 4) is (fails == 0)


def test_a_batch_is_played_by_numpy_until_the_loop_is_there(monkeypatch: pytest.MonkeyPatch) -> None:
    """And by the loop from then on, in the same call pattern, to the same digits."""
    from dhcli import forward_batch, load_robot

    robot, q = load_robot("scara"), np.random.default_rng(1).uniform(-3, 3, (40, 3))
    loader = kernels._Loader()
    monkeypatch.setattr(kernels, "_LOADED", loader)
    monkeypatch.setattr(kernels, "_compiled_loop", lambda: loop)
    monkeypatch.setattr(kernels, "PAYS", 100)
    monkeypatch.delitem(sys.modules, "numba", raising=False)
    found = []
    for is_there in (False, False, True, True):
        found.append(forward_batch(robot, q))
        assert (loader.loop is not None) is is_there
    assert np.abs(found[-1] - found[0]).max() <= 1e-15
