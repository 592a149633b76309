"""What a user installs: the wheel and the sdist hold what they should, and the wheel works far from the checkout."""

import os
import shutil
import subprocess
import sys
import tarfile
from collections.abc import Callable
from email.parser import Parser
from math import cos, sin
from pathlib import Path
from zipfile import ZipFile

import pytest

_ROOT = Path(__file__).parents[2]
_DATA_FOLDERS = ("robots", "exercises")


def _run(*command: str | Path, cwd: Path, **environment: str) -> str:
    """Run a program that must succeed; its standard output."""
    inherited = {name: text for name, text in os.environ.items() if name != "PYTHONPATH"}
    done = subprocess.run(
        [str(word) for word in command],
        cwd=cwd,
        env=inherited | environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        encoding="utf-8",
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def _build(source: Path, to: Path, *targets: str) -> None:
    """Build without isolation: nothing is downloaded."""
    _run(sys.executable, "-m", "hatchling", "build", "-d", to, *targets, cwd=source)


def _only(folder: Path, pattern: str) -> Path:
    """The one file of a pattern."""
    (path,) = folder.glob(pattern)
    return path


def _names_in_wheel(wheel: Path) -> set[str]:
    """The files in a wheel."""
    with ZipFile(wheel) as archive:
        return set(archive.namelist())


def _data_files() -> set[str]:
    """Every robot and exercise of the checkout, by its path from the root."""
    return {path.relative_to(_ROOT).as_posix() for folder in _DATA_FOLDERS for path in (_ROOT / folder).rglob("*.yaml")}


@pytest.fixture(scope="module")
def dist(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a wheel and an sdist built from the checkout."""
    folder = tmp_path_factory.mktemp("dist")
    _build(_ROOT, folder, "-t", "wheel", "-t", "sdist")
    return folder


@pytest.fixture(scope="module")
def wheel(dist: Path) -> Path:
    """The wheel."""
    return _only(dist, "*.whl")


@pytest.fixture(scope="module")
def unpacked_sdist(dist: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder that the sdist unpacks to."""
    folder = tmp_path_factory.mktemp("sdist")
    with tarfile.open(_only(dist, "*.tar.gz")) as archive:
        archive.extractall(folder, filter="data")
    return _only(folder, "dhcli-*")


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the wheel installed and nothing else; what it depends on comes from the running Python."""
    folder = tmp_path_factory.mktemp("installed")
    pip = (sys.executable, "-m", "pip", "--disable-pip-version-check", "install", "--quiet", "--no-compile")
    _run(*pip, "--no-deps", "--no-index", "--target", folder, wheel, cwd=folder)
    return folder


@pytest.fixture
def dhcli(installed: Path, tmp_path: Path) -> Callable[..., str]:
    """Run the installed dhcli from an empty folder; what it prints."""
    return lambda *arguments: _run(
        sys.executable, "-m", "dhcli", *arguments, cwd=tmp_path, PYTHONPATH=str(installed), COLUMNS="200"
    )


def test_the_wheel_holds_the_package_and_its_data_and_nothing_else(wheel: Path) -> None:
    """No tests, nothing of the checkout beside the package, nothing compiled."""
    names = _names_in_wheel(wheel)
    version = wheel.name.split("-")[1]
    assert {name.split("/")[0] for name in names} == {"dhcli", f"dhcli-{version}.dist-info"}
    assert {"dhcli/__init__.py", "dhcli/__main__.py", "dhcli/py.typed"} <= names
    assert f"dhcli-{version}.dist-info/licenses/LICENSE" in names
    assert not [name for name in names if name.endswith(".pyc") or "test" in name]


def test_every_robot_and_exercise_is_in_the_wheel(wheel: Path) -> None:
    """They stand in `dhcli/_data`, and there is at least the robot that the tests below use."""
    in_wheel = {name for name in _names_in_wheel(wheel) if name.startswith("dhcli/_data/") and name.endswith(".yaml")}
    assert "dhcli/_data/robots/scara.yaml" in in_wheel
    assert in_wheel == {f"dhcli/_data/{name}" for name in _data_files()}


def test_the_sdist_holds_what_a_packager_needs(unpacked_sdist: Path) -> None:
    """The package, its data, its tests and its papers; no environment, no cache, nothing of the project's own."""
    top = {path.name for path in unpacked_sdist.iterdir()}
    needed = {"dhcli", "robots", "tests", "README.md", "LICENSE", "CHANGELOG.md", "pyproject.toml", "PKG-INFO"}
    assert needed <= top
    assert top <= needed | {"exercises", ".gitignore"}
    assert (unpacked_sdist / "tests" / "packaging" / "test_wheel.py").is_file()
    assert not [path for path in unpacked_sdist.rglob("*") if path.suffix == ".pyc" or path.name == "__pycache__"]


def test_a_wheel_built_from_the_sdist_is_the_same(unpacked_sdist: Path, wheel: Path, tmp_path: Path) -> None:
    """`pip install` of the sdist gives what the wheel gives."""
    _build(unpacked_sdist, tmp_path, "-t", "wheel")
    assert _names_in_wheel(_only(tmp_path, "*.whl")) == _names_in_wheel(wheel)


def test_the_metadata_name_the_extras_the_licence_and_the_readme(wheel: Path) -> None:
    """What a package index shows."""
    (name,) = (name for name in _names_in_wheel(wheel) if name.endswith("dist-info/METADATA"))
    with ZipFile(wheel) as archive:
        metadata = Parser().parsestr(archive.read(name).decode("utf-8"))
    assert metadata["Name"] == "dhcli"
    assert metadata["Version"] == wheel.name.split("-")[1]
    assert metadata["License-Expression"] == "MIT"
    assert metadata["Description-Content-Type"] == "text/markdown"
    assert set(metadata.get_all("Provides-Extra", [])) >= {"arrays", "dev", "draw", "fast", "test"}


def test_the_installed_package_is_the_one_that_runs_and_has_every_robot(installed: Path, tmp_path: Path) -> None:
    """Else the tests below would try the checkout; all of the checkout's robots are found, each by its name."""
    program = "import dhcli; from dhcli.files.library.entries import Kind, entries\n"
    program += "print(dhcli.__file__, *(entry.name for entry in entries(Kind.ROBOTS)))"
    place, *names = _run(sys.executable, "-c", program, cwd=tmp_path, PYTHONPATH=str(installed)).split()
    assert Path(place).resolve().is_relative_to(installed.resolve())
    robots = {path.stem for path in (_ROOT / "robots").glob("*.yaml")}
    assert robots
    assert set(names) == robots


def test_the_installed_dhcli_computes_a_pose(dhcli: Callable[..., str]) -> None:
    """The robot is found in the package; x and y of the SCARA's end as in Bajd, eq. (2.24)."""
    printed = dhcli("fk", "scara", "--q", "0.3,0.5,0.1")
    assert f"{-0.3 * sin(0.3) - 0.2 * sin(0.3 + 0.5):.4f}" in printed
    assert f"{0.3 * cos(0.3) + 0.2 * cos(0.3 + 0.5):.4f}" in printed


def test_the_console_script_runs_the_installed_dhcli(installed: Path, wheel: Path, tmp_path: Path) -> None:
    """`dhcli --version` names the version that the wheel's name has."""
    script = shutil.which("dhcli", path=str(installed / "bin"))
    assert script
    assert wheel.name.split("-")[1] in _run(script, "--version", cwd=tmp_path, PYTHONPATH=str(installed))
