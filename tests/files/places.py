"""Places where writing fails, in a process of its own: a disk that is full or read-only, a limit on files."""

import json
import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest
from tests.conftest import IMPORTS

Done = subprocess.CompletedProcess[str]

# In a mount namespace of its own, so that nothing of it is left.
_INSIDE = """
import os, subprocess, sys
folder, options = sys.argv[1:3]
os.makedirs(folder, exist_ok=True)
subprocess.run(["mount", "-t", "tmpfs", "-o", options.split(",ro")[0], "none", folder], check=True)
if sys.argv[3]:
    with open(os.path.join(folder, sys.argv[3]), "w") as old:
        old.write("what was there before")
if options.endswith(",ro"):
    subprocess.run(["mount", "-o", "remount,ro", folder], check=True)
done = subprocess.run(sys.argv[4:])
for name in sorted(os.listdir(folder)):
    with open(os.path.join(folder, name), "rb") as file:
        print("LEFT", name, file.read()[:21])
sys.exit(done.returncode if done.returncode >= 0 else 200 - done.returncode)
"""
PYTHON = (sys.executable, "-c", "from cotouch.__main__ import run; run()")
# Several commands, one after the other in one process: their arguments are given one a line.
_EACH = """
import json, sys
from tests.cli.commands import here
for line in sys.argv[1:]:
    done = here(*line.splitlines())
    print("DONE", json.dumps([done.returncode, done.stdout, done.stderr]))
"""


def on_a_small_disk(folder: Path, options: str, *command: str | Path, old: str = "") -> Done:
    """Runs cotouch with a file system of its own at `folder`; says what is left there in lines that begin with LEFT."""
    return subprocess.run(
        ["unshare", "--mount", sys.executable, "-c", _INSIDE, folder, options, old, *PYTHON, *command],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


def each_on_a_small_disk(folder: Path, options: str, *commands: Sequence[str | Path], old: str = "") -> list[Done]:
    """The same for several commands, which spares what starting each costs; what is left is in the last one's."""
    program = [sys.executable, "-c", _EACH, *("\n".join(map(str, command)) for command in commands)]
    inside = ["unshare", "--mount", sys.executable, "-c", _INSIDE, folder, options, old, *program]
    env = {**os.environ, "PYTHONPATH": IMPORTS}
    ran = subprocess.run(inside, capture_output=True, text=True, timeout=300, check=True, env=env)
    lines = ran.stdout.splitlines()
    told = [json.loads(line.removeprefix("DONE ")) for line in lines if line.startswith("DONE ")]
    return [Done(command, code, ran.stdout, err) for command, (code, _, err) in zip(commands, told, strict=True)]


def left(done: Done) -> list[str]:
    """What was left on the small disk."""
    return [line.removeprefix("LEFT ") for line in done.stdout.splitlines() if line.startswith("LEFT ")]


def mounts() -> bool:
    """Whether file systems can be mounted here."""
    command = ["unshare", "--mount", "mount", "-t", "tmpfs", "none", "/mnt"]
    try:
        return subprocess.run(command, capture_output=True, check=False).returncode == 0
    except FileNotFoundError:
        return False


needs_mounts = pytest.mark.skipif(not mounts(), reason="file systems cannot be mounted here")
