"""The work shared by processes of a Dask cluster, some of which die, in a process of its own."""

import json
import subprocess
import sys

import pytest
from tests.conftest import IMPORTS

# The first report comes after the first round, in the middle of the run.
PROGRAM = """
import json
import subprocess
import sys
from distributed import LocalCluster
from cotouch import plan
from tests.planning.support import five_users

def worker(address):
    options = ("--nthreads", "1", "--no-nanny", "--no-dashboard", "--death-timeout", "60")
    return subprocess.Popen([sys.executable, "-m", "distributed.cli.dask_worker", address, *options])

if __name__ == "__main__":
    workers, lost = int(sys.argv[1]), int(sys.argv[2])
    options = {"links": 6, "objective": "decay", "method": "local", "starts": 12, "seed": 2}
    alone = plan(five_users(), **options)
    with LocalCluster(n_workers=0, processes=True, dashboard_address=None, host="127.0.0.1") as cluster:
        there = [worker(cluster.scheduler_address) for _ in range(workers)]
        if workers:
            from distributed import Client
            with Client(cluster.scheduler_address) as client:
                client.wait_for_workers(workers, timeout=120)

        def progress(done, total, best):
            for one in there[:lost]:
                one.kill()

        try:
            found = plan(five_users(), dask=cluster.scheduler_address, progress=progress, **options)
        finally:
            for one in there:
                one.kill()
                one.wait()
        same = [c.links for c in found.top] == [c.links for c in alone.top] and found.looked_at == alone.looked_at
        print(json.dumps(found.numbers() | {"same": same}))
"""


@pytest.mark.slow
@pytest.mark.parametrize(("workers", "lost"), [(2, 0), (2, 1), (2, 2), (0, 0)])
def test_processes_of_a_dask_cluster_find_the_same_whoever_is_lost(tmp_path, workers, lost):
    path = tmp_path / "program.py"
    path.write_text(PROGRAM)
    done = subprocess.run(
        [sys.executable, str(path), str(workers), str(lost)],
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
        env={"PATH": "/usr/bin:/bin", "PYTHONPATH": IMPORTS},
    )
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout.splitlines()[-1])
    assert found["same"]
    said = " ".join(found["notes"])
    assert ("All Dask workers were lost" in said) == (lost == workers > 0)
    assert ("has no workers" in said) == (workers == 0)
