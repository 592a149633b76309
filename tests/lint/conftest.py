"""What the tests of lint share."""

import pytest

from dhcli.lint import variants
from tests.nightly import some


@pytest.fixture(autouse=True)
def few_seeds(monkeypatch: pytest.MonkeyPatch) -> None:
    """A few of the two hundred variants that lint draws, the first and the last among them."""
    monkeypatch.setattr(variants, "SEEDS", some(variants.SEEDS, 50))
