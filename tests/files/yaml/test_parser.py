"""PyYAML imported without its parser in Python, and whole for whoever asks."""

import os
import subprocess
import sys

import pytest

READ = """
import sys
from dhcli.errors import FileError
from dhcli.files.yaml.placed import read_yaml
assert read_yaml("format: 1", "file").entries[0][1].text == "1"
"""


def run(code: str) -> None:
    """Run a program in a process that knows nothing yet."""
    done = subprocess.run([sys.executable, "-c", READ + code], capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stderr


@pytest.fixture(autouse=True)
def with_libyaml() -> None:
    """Without it there is nothing to leave out."""
    pytest.importorskip("yaml._yaml")


def test_reading_a_file_leaves_out_what_libyaml_makes_superfluous() -> None:
    """The parser in Python, and everything that writes."""
    run("assert not {'yaml.scanner', 'yaml.parser', 'yaml.constructor', 'yaml.emitter'} & set(sys.modules)")


ASKED = r"""
import yaml; assert yaml.safe_load('a: [1]') == {'a': [1]}
from yaml import safe_dump; assert safe_dump({'a': 1}) == 'a: 1\n'
import yaml; assert yaml.load('a: 1', yaml.CSafeLoader) == {'a': 1}
import yaml.scanner; assert yaml.scanner.Scanner
from yaml import *; assert safe_load('1') == 1
import yaml; assert yaml.YAMLError is yaml.error.YAMLError and yaml.__with_libyaml__
import yaml, importlib; assert importlib.reload(yaml).safe_load('1') == 1
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="a process for each is forked")
def test_another_library_finds_all_of_it() -> None:
    """Also after dhcli has read a file, and dhcli goes on reading; each way to ask in a process of its own."""
    asked = ASKED.strip().split("\n")
    run(f"""
import os
for asked in {asked!r}:
    if not os.fork():
        exec(asked)
        read_yaml("format: 1", "file")
        sys.exit()
    assert os.wait()[1] == 0, asked
""")


def test_what_is_not_there_is_not_there() -> None:
    """Asking the package for what no version has is an AttributeError, as ever."""
    run("import yaml\nassert not hasattr(yaml, 'no_such_name')\nassert yaml.safe_load('1') == 1")


def test_what_is_no_yaml_is_told_as_by_the_whole_package() -> None:
    """The error of libyaml's parser is a class of a module that is imported for it."""
    run(
        "try: read_yaml('format: [1', 'file')\n"
        "except FileError as error: assert 'never closed' in str(error), error\n"
        "else: raise SystemExit('it was read')"
    )
