"""Finding robots, linkages and exercises by name."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from dhcli.errors import UnknownNameError
from dhcli.files.library import entries as library
from dhcli.files.library.entries import Entry, Kind, entries
from dhcli.files.library.lookup import find
from tests.row_by_row import row_by_row


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An installed dhcli with two robots, a user with an empty home, working in an empty folder."""
    for folder in ("work", "home", "package"):
        (tmp_path / folder).mkdir()
    write(
        tmp_path / "package/_data", "robots/puma560", "robots/scara", "robots/linkages/four-bar", "exercises/wpi/fk-1"
    )
    monkeypatch.chdir(tmp_path / "work")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setenv("USERPROFILE", str(tmp_path / "home"))
    monkeypatch.delenv("XDG_DATA_HOME", raising=False)
    monkeypatch.delenv("DHCLI_PATH", raising=False)
    monkeypatch.setattr(library, "_PACKAGE", tmp_path / "package")
    return tmp_path


def write(root: Path, *names: str, suffix: str = ".yaml") -> None:
    """Write files that hold no YAML at all: nobody may look into them."""
    for name in names:
        path = root / (name + suffix)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b"\0 not yaml")


def listed(kind: Kind) -> list[tuple[str, str]]:
    """Name and origin of everything of a kind."""
    return [(entry.name, entry.origin) for entry in entries(kind)]


def hint_for(kind: Kind, name: str) -> str:
    """What is said of an unknown name."""
    with pytest.raises(UnknownNameError) as caught:
        find(kind, name)
    (problem,) = caught.value.problems
    assert problem.message == f"there is no {kind.noun} '{name}'"
    return problem.hint


def test_every_kind_has_its_folder() -> None:
    """Linkages stand in a folder of the robots and are none; an exercise's id has its folder in it."""
    assert listed(Kind.ROBOTS) == [("puma560", "built-in"), ("scara", "built-in")]
    assert listed(Kind.LINKAGES) == [("four-bar", "built-in")]
    assert listed(Kind.EXERCISES) == [("wpi/fk-1", "built-in")]


def test_a_kind_is_the_word_on_the_command_line() -> None:
    """And knows its own noun."""
    assert [(Kind(word).folder, Kind(word).noun) for word in ("robots", "linkages", "exercises")] == [
        ("robots", "robot"),
        ("robots/linkages", "linkage"),
        ("exercises", "exercise"),
    ]


def test_the_users_folders_come_before_what_is_built_in(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """In the documented order, each called as the user would write it."""
    write(home / "work", "robots/a")
    write(home / "one", "robots/b")
    write(home / "home/two", "robots/c")
    write(home / "home/.local/share/dhcli", "robots/d")
    monkeypatch.setenv("DHCLI_PATH", os.pathsep.join([str(home / "one"), "", "~/two", str(home / "nowhere")]))
    assert listed(Kind.ROBOTS) == [
        ("a", "./robots"),
        ("b", str(home / "one/robots")),
        ("c", "~/two/robots"),
        ("d", "~/.local/share/dhcli/robots"),
        ("puma560", "built-in"),
        ("scara", "built-in"),
    ]


def test_a_robot_of_the_user_hides_the_built_in_one(home: Path) -> None:
    """Both are listed, and the first is found."""
    write(home / "work", "robots/scara")
    built_in = home / "package/_data/robots/scara.yaml"
    assert entries(Kind.ROBOTS)[0] == Entry("scara", Path("robots/scara.yaml"), "./robots")
    assert entries(Kind.ROBOTS)[2] == Entry("scara", built_in, "built-in", shadowed=True)
    assert find(Kind.ROBOTS, "scara") == Path("robots/scara.yaml")


def test_an_entry_of_the_path_may_be_a_folder_of_robots(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """If it has no `robots/` or `exercises/` in it, its files are robots, not exercises."""
    write(home / "arms", "r1", "linkages/l1", "course/e1")
    monkeypatch.setenv("DHCLI_PATH", str(home / "arms"))
    assert find(Kind.ROBOTS, "r1") == home / "arms/r1.yaml"
    assert find(Kind.LINKAGES, "l1") == home / "arms/linkages/l1.yaml"
    assert [name for name, _ in listed(Kind.ROBOTS)] == ["r1", "puma560", "scara"]
    assert listed(Kind.EXERCISES) == [("wpi/fk-1", "built-in")]


def test_an_entry_of_the_path_with_exercises_only_holds_no_robots(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A stray file beside `exercises/` is nothing."""
    write(home / "course", "notes", "exercises/week-1/e1")
    monkeypatch.setenv("DHCLI_PATH", str(home / "course"))
    assert [name for name, _ in listed(Kind.ROBOTS)] == ["puma560", "scara"]
    assert [name for name, _ in listed(Kind.EXERCISES)] == ["week-1/e1", "wpi/fk-1"]


def test_the_data_folder_of_the_user_may_be_elsewhere(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`XDG_DATA_HOME` counts if it is absolute, as its standard says."""
    write(home / "data/dhcli", "robots/mine")
    write(home / "home/.local/share/dhcli", "robots/usual")
    monkeypatch.setenv("XDG_DATA_HOME", str(home / "data"))
    assert listed(Kind.ROBOTS)[0] == ("mine", str(home / "data/dhcli/robots"))
    monkeypatch.setenv("XDG_DATA_HOME", "data")
    assert listed(Kind.ROBOTS)[0] == ("usual", "~/.local/share/dhcli/robots")


def test_in_a_checkout_the_data_stand_beside_the_package(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """And are built in, also for someone who works in the checkout itself."""
    write(home / "checkout", "robots/scara")
    (home / "checkout/dhcli").mkdir()
    monkeypatch.setattr(library, "_PACKAGE", home / "checkout/dhcli")
    monkeypatch.chdir(home / "checkout")
    assert entries(Kind.ROBOTS) == (Entry("scara", home / "checkout/robots/scara.yaml", "built-in"),)


def test_a_folder_named_twice_is_searched_once(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Otherwise every robot would seem to hide itself."""
    write(home / "work", "robots/a")
    monkeypatch.setenv("DHCLI_PATH", os.pathsep.join([".", str(home / "work"), str(home / "work/robots")]))
    assert [name for name, _ in listed(Kind.ROBOTS)] == ["a", "puma560", "scara"]


def test_only_visible_yaml_files_are_listed(home: Path) -> None:
    """Notes, hidden files and folders with the suffix of a file are left out; a name may hold a dot."""
    write(home / "work", "robots/b.v2", "robots/.hidden")
    write(home / "work", "robots/a", suffix=".YML")
    write(home / "work", "robots/notes", suffix=".md")
    (home / "work/robots/folder.yaml").mkdir()
    assert [name for name, origin in listed(Kind.ROBOTS) if origin != "built-in"] == ["a", "b.v2"]


def test_a_folder_that_cannot_be_read_does_not_stop_the_search(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulated, because the tests may run as root, who may read everything."""
    write(home / "work", "robots/a")
    scandir = os.scandir

    def refuse(folder: Path) -> object:
        if Path(folder) == Path("robots"):
            raise PermissionError
        return scandir(folder)

    monkeypatch.setattr(os, "scandir", refuse)
    assert find(Kind.ROBOTS, "scara").name == "scara.yaml"


def test_an_installation_without_data_lists_nothing(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A name then is just unknown."""
    monkeypatch.setattr(library, "_PACKAGE", home / "home/dhcli")
    assert entries(Kind.ROBOTS) == ()
    assert hint_for(Kind.ROBOTS, "scara") == "dhcli list robots shows what there is"


@row_by_row("kind", Kind)
@row_by_row("path", ["-", "scara.yaml", "a.yml", "A.YAML", "./scara", "/etc/scara", "../x/scara", "a/b/c"])
def test_a_text_that_looks_like_a_path_is_one(kind: Kind, path: str) -> None:
    """Whether it exists is for the reader to say."""
    assert find(kind, path) == Path(path)


def test_a_slash_makes_a_path_of_a_robot_and_an_id_of_an_exercise(home: Path) -> None:
    """Unless a file is called like the id."""
    assert find(Kind.ROBOTS, "wpi/arm-1") == Path("wpi/arm-1")
    assert find(Kind.EXERCISES, "wpi/fk-1") == home / "package/_data/exercises/wpi/fk-1.yaml"
    write(home / "work", "wpi/fk-1", suffix="")
    assert find(Kind.EXERCISES, "wpi/fk-1") == Path("wpi/fk-1")


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("arm", "did you mean yim/arm-1 or yim/arm-2?"),
        ("rm-2", "did you mean yim/arm-2?"),
        ("m", "known: "),
        ("scara", "'scara' is the name of a robot; did you mean bajd/scara-a or "),
    ],
)
def test_the_beginning_of_a_name_or_a_piece_of_it_suggests_what_has_it(home: Path, name: str, hint: str) -> None:
    """At most four of them; a piece has three letters at least."""
    for exercise in ("yim/arm-1", "yim/arm-2", *(f"bajd/scara-{letter}" for letter in "abcdef")):
        write(home / "package/_data/exercises", exercise)
    said = hint_for(Kind.EXERCISES, name)
    assert said.startswith(hint)
    assert ("(and 2 more)" in said) is (name == "scara")


@pytest.mark.parametrize(
    ("kind", "name", "hint"),
    [
        (Kind.ROBOTS, "SCRA", "did you mean scara?; dhcli list robots shows what there is"),
        (Kind.ROBOTS, "xyz", "known: puma560, scara; dhcli list robots shows what there is"),
        (Kind.ROBOTS, "four-bar", "'four-bar' is the name of a linkage; dhcli list robots shows what there is"),
        (Kind.ROBOTS, "wpi/fk-1", "'wpi/fk-1' is the name of an exercise; dhcli list robots shows what there is"),
        (Kind.ROBOTS, "fk-1", "'fk-1' is the name of an exercise; dhcli list robots shows what there is"),
        (Kind.LINKAGES, "scara", "'scara' is the name of a robot; dhcli list linkages shows what there is"),
        (Kind.EXERCISES, "fk", "did you mean wpi/fk-1?; dhcli list exercises shows what there is"),
        (Kind.EXERCISES, "wpi/fk1", "did you mean wpi/fk-1?; dhcli list exercises shows what there is"),
        (Kind.EXERCISES, "scara", "'scara' is the name of a robot; dhcli list exercises shows what there is"),
    ],
)
def test_an_unknown_name_is_told_the_nearest_and_the_next_command(kind: Kind, name: str, hint: str) -> None:
    """Or what else has that name."""
    assert hint_for(kind, name) == hint


def test_a_name_that_is_found_imports_nothing_that_proposes_others(monkeypatch: pytest.MonkeyPatch) -> None:
    """It comes with the first that is not."""
    monkeypatch.delitem(sys.modules, "dhcli.files.library.near", raising=False)
    find(Kind.ROBOTS, "scara")
    assert "dhcli.files.library.near" not in sys.modules
    hint_for(Kind.ROBOTS, "skara")
    assert "dhcli.files.library.near" in sys.modules


def test_a_name_is_not_silently_a_file_in_this_folder(home: Path) -> None:
    """But the hint says how to name the file."""
    write(home / "work", "mine")
    assert hint_for(Kind.ROBOTS, "mine").startswith("for the file in this folder type ./mine.yaml")


@pytest.mark.parametrize("name", ["", ".", "..", "x" * 5000, "θ", "a\0b"])
def test_no_name_is_too_strange(name: str) -> None:
    """It is just not known."""
    assert "dhcli list robots" in hint_for(Kind.ROBOTS, name)


def test_what_stands_in_a_folder_above_is_pointed_at(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whoever has gone into the folder of the sheets is told the path to the exercise."""
    for name in ("robots/my-arm.yaml", "exercises/mine/first.yaml", "sheets/deep/one.yaml"):
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()
    monkeypatch.chdir(tmp_path / "sheets" / "deep")
    for kind, name, path in (
        (Kind.ROBOTS, "my-arm", "../../robots/my-arm.yaml"),
        (Kind.EXERCISES, "mine/first", "../../exercises/mine/first.yaml"),
        (Kind.EXERCISES, "first", "../../exercises/mine/first.yaml"),
    ):
        with pytest.raises(UnknownNameError) as caught:
            find(kind, name)
        assert f"in a folder above there is one: type {path}, or go" in caught.value.problems[0].hint
