"""What a worker tells of a test: its verdict once, and all there is to say where something is wrong.

pytest tells of each test five times, and each time xdist sends it from the worker to the process that prints; for
thousands of tests that pass in a millisecond this took longer than many of the tests.
"""

from __future__ import annotations

import pytest
from _pytest.runner import runtestprotocol

ASKED = ("durations", "maxfail", "setupshow", "xmlpath")
"""Options of pytest that use more than a verdict: the times of all three phases, say, or a failure before its end."""


class Shortly:
    """Runs tests as pytest does, and tells what is not plain success in full, and the rest in one report."""

    @pytest.hookimpl
    def pytest_runtest_protocol(self, item: pytest.Item, nextitem: pytest.Item | None) -> bool:
        """Run a test from its setup to its teardown."""
        reports = runtestprotocol(item, log=False, nextitem=nextitem)
        passed = all(report.passed for report in reports)
        for report in reports:
            if passed:
                report.keywords = {}  # the names of all that the test stands in
            if not passed or report.when == "call":
                item.ihook.pytest_runtest_logreport(report=report)
        return True


def pytest_configure(config: pytest.Config) -> None:
    """Tell shortly, in a worker of whose tests nobody asked to hear more."""
    if hasattr(config, "workerinput") and config.get_verbosity() <= 0 and not any(map(config.getoption, ASKED)):
        config.pluginmanager.register(Shortly())
