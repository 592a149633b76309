"""The table of results over the mechanisms of the literature: `python tests/bench/mechanisms.py`."""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
sys.path.insert(0, str(Path(__file__).parents[2]))

from dhcli.mobility.finding import mobility_of
from tests.mobility.mechanisms import MECHANISMS, linkage


def main() -> None:
    """Print a line for each mechanism, then how many came out right, wrong and undecided."""
    verdicts, times = [], []
    print(
        f"{'mechanism':22}{'F':>4}{'inst.':>6}{'true':>6}{'idle':>5}  {'motion':8}{'verdict':10}{'ms':>7}  certificate"
    )
    for name, mechanism in MECHANISMS.items():
        subject = linkage(name)
        start = time.perf_counter()
        found = mobility_of(subject)
        times.append((time.perf_counter() - start) * 1000)
        truth = mechanism["truth"]
        got = (found.gruebler, found.instantaneous, found.mobility, len(found.idle))
        right = got == (truth["gruebler"], truth["inst"], truth["dof"], truth["idle"])
        verdicts.append("undecided" if found.mobility is None else "right" if right else "WRONG")
        figures = f"{got[0]:>4}{got[1]:>6}{got[2]!s:>6}{got[3]:>5}"
        certificate = found.certificate.partition(":")[0]
        print(f"{name:22}{figures}  {found.motion:8}{verdicts[-1]:10}{times[-1]:7.1f}  {certificate}")
    counted = ", ".join(f"{verdicts.count(word)} {word}" for word in ("right", "WRONG", "undecided"))
    formula = sum(m["truth"]["gruebler"] == m["truth"]["dof"] for m in MECHANISMS.values())
    instant = sum(m["truth"]["inst"] == m["truth"]["dof"] for m in MECHANISMS.values())
    print(f"{counted} of {len(verdicts)}; the formula alone {formula} right, the rank alone {instant} right")
    print(f"median {sorted(times)[len(times) // 2]:.1f} ms, slowest {max(times):.0f} ms, all {sum(times) / 1000:.1f} s")


if __name__ == "__main__":
    main()
