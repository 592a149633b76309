"""What a processor has that matters for numbers, and how to have all that is compared do without."""

from __future__ import annotations

import os
from pathlib import Path

try:
    from numpy._core import _multiarray_umath as numpy_core
except ImportError:  # numpy 1
    from numpy.core import _multiarray_umath as numpy_core

MATTER = {"AVX2": "AVX2", "FMA3": "FMA", "ASIMD": "NEON", "SVE": "SVE"}
"""What numpy, numba, JAX and PyTorch choose their code by, as numpy calls it and as people do; and AVX-512."""

WIDE = ("AVX512", "X86_V4")
"""How numpy's names for parts of AVX-512 begin."""

WITHOUT = {
    "NUMBA_CPU_NAME": "x86-64-v3",
    "NUMBA_CPU_FEATURES": "+sse4.2,+popcnt,+avx,+avx2,+fma,+f16c,+bmi,+bmi2,+lzcnt,+movbe",
    "XLA_FLAGS": "--xla_cpu_max_isa=AVX2",
    "ATEN_CPU_CAPABILITY": "avx2",
    "OPENBLAS_CORETYPE": "Haswell",
}
"""What has those libraries do without AVX-512; pinocchio and the Robotics Toolbox are built without."""


def processor() -> str:
    """Its model, where the system tells it, what it has that numpy uses in this run, and its caches."""
    told = Path("/proc/cpuinfo")
    lines = told.read_text("utf-8").splitlines() if told.exists() else []
    model = next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")
    has = [name for feature, name in MATTER.items() if numpy_core.__cpu_features__.get(feature)]
    if "AVX2" in has:
        has.append("AVX-512" if wide() else "no AVX-512")
    return ", ".join(filter(None, (model, *has, *caches())))


def wide() -> list[str]:
    """The parts of AVX-512 that numpy uses in this run."""
    features = numpy_core.__cpu_features__
    return [name for name in numpy_core.__cpu_dispatch__ if name.startswith(WIDE) and features.get(name)]


def caches() -> list[str]:
    """Those of one core: `L1 32K`, where the system tells them."""
    found = []
    for folder in sorted(Path("/sys/devices/system/cpu/cpu0/cache").glob("index*")):
        level, kind, size = ((folder / name).read_text("utf-8").strip() for name in ("level", "type", "size"))
        if kind != "Instruction":
            found.append(f"L{level} {size}")
    return found


def without_wide() -> dict[str, str]:
    """An environment in which programs do without AVX-512; empty where there is none."""
    parts = wide()
    return {**os.environ, **WITHOUT, "NPY_DISABLE_CPU_FEATURES": " ".join(parts)} if parts else {}
