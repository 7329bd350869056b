"""The work shared by processes of a Dask cluster, in a process of its own."""

import json
import subprocess
import sys

import pytest
from tests.conftest import ROOT

PROGRAM = """
import json
from distributed import LocalCluster
from cotouch import plan
from tests.planning.support import five_users

if __name__ == "__main__":
    with LocalCluster(processes=True, n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        found = plan(five_users(), links=6, objective="decay", dask=cluster.scheduler_address)
        print(json.dumps(found.numbers()))
"""


@pytest.mark.slow
def test_two_processes_of_a_dask_cluster_find_the_same(tmp_path):
    path = tmp_path / "program.py"
    path.write_text(PROGRAM)
    done = subprocess.run(
        [sys.executable, str(path)],
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
        env={"PATH": "/usr/bin:/bin", "PYTHONPATH": ROOT},
    )
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert (found["status"], found["graphs"]) == ("proved", 205)
    assert found["best"]["value"] == pytest.approx(-1.428553, abs=1e-6)
