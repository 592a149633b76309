"""A test that passes is told of once, and one that does not in all its phases."""

from pathlib import Path

import pytest

from tests.reporting import Shortly

PROGRAM = """
import pytest

@pytest.fixture
def broken():
    yield
    raise OSError("left behind")

def test_passes(): print("on the way")
def test_fails(): assert 1 + 1 == 3
def test_is_skipped_on_the_way(): pytest.skip("not today")
@pytest.mark.skip(reason="not here")
def test_is_skipped(): pass
def test_leaves_something(broken): pass
@pytest.mark.xfail
def test_fails_as_it_should(): assert 1 + 1 == 3
"""

TOLD = {
    "passes": {"call": "passed"},
    "fails": {"setup": "passed", "call": "failed", "teardown": "passed"},
    "is_skipped_on_the_way": {"setup": "passed", "call": "skipped", "teardown": "passed"},
    "is_skipped": {"setup": "skipped", "teardown": "passed"},
    "leaves_something": {"setup": "passed", "call": "passed", "teardown": "failed"},
    "fails_as_it_should": {"setup": "passed", "call": "skipped", "teardown": "passed"},
}


class Listener:
    """Writes down what it is told."""

    def __init__(self) -> None:
        """Nothing yet."""
        self.told: dict[str, dict[str, str]] = {}

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Each report of a test by its phase."""
        phases = self.told.setdefault(report.nodeid.partition("::test_")[2], {})
        assert report.when not in phases
        phases[report.when] = report.outcome


def test_what_is_not_plain_success_is_told_in_full(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Also where only the end of a test goes wrong; and the run fails as it would with every report."""
    monkeypatch.setenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")
    (tmp_path / "test_all.py").write_text(PROGRAM, encoding="utf-8")
    words = [f"--rootdir={tmp_path}", "-p", "no:cacheprovider", "--import-mode=importlib", "-q", str(tmp_path)]
    words += [
        "-p",
        "no:unraisableexception",
    ]  # it would search all this worker holds for garbage
    listener = Listener()
    assert pytest.main(words, plugins=[Shortly(), listener]) == pytest.ExitCode.TESTS_FAILED
    assert listener.told == TOLD
