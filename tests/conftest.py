"""Settings for every test: the same examples on every run, and helpers importable as `tests....`."""

import gc
import os
import signal
import sys
from collections.abc import Generator
from pathlib import Path

import pytest
from _pytest.runner import runtestprotocol
from hypothesis import HealthCheck, settings
from hypothesis.internal.conjecture import providers

# There are few circles of references in what is loaded, and to look for them took a seventh of collecting.
gc.set_threshold(50_000)
# Before numpy is loaded: the workers of one run must not fight for cores, and sums then have one order everywhere.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

ROOT = str(Path(__file__).parent.parent)
# For processes that import the tests' own modules: the tests and the sources beside them.
IMPORTS = os.pathsep.join((ROOT, str(Path(ROOT, "src"))))
if ROOT not in sys.path:
    sys.path.insert(0, ROOT)


def pytest_addoption(parser: pytest.Parser) -> None:
    """Two sizes of the suite, see `tests/thorough.py`; and what `tests/run.py` says."""
    parser.addoption("--thorough", action="store_true", help="more cases of everything: what `make test-all` runs")
    parser.addoption("--warm", action="store_true", help="the kernels are compiled already")


def pytest_configure(config: pytest.Config) -> None:
    """Compiles the kernels once, one process for each width, before several workers compile the same."""
    from tests import thorough

    if config.getoption("--thorough"):
        os.environ[thorough.VARIABLE] = "1"
    settings.register_profile(
        "cotouch",
        derandomize=True,
        deadline=None,  # the first example of a kernel includes its compilation
        max_examples=thorough.examples(30),
        suppress_health_check=[HealthCheck.too_slow],
    )
    settings.load_profile("cotouch")
    # It would also try numbers out of the sources that happen to be imported: others after other tests.
    none = providers.Constants()
    providers._get_local_constants = lambda: none
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        # A shell starts what runs in its background so, and every process below inherits it: Ctrl-C would do nothing.
        signal.signal(signal.SIGINT, signal.default_int_handler)
    from tests import leftovers, turns

    config.pluginmanager.register(leftovers)
    config.pluginmanager.register(turns)
    config.pluginmanager.register(thorough)
    alone = not getattr(config.option, "numprocesses", None) or hasattr(config, "workerinput")
    if not alone and not config.getoption("--warm"):
        from tests.warm_up import warm_up

        warm_up()


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Where workers share the tests, what takes long comes first."""
    if hasattr(config, "workerinput"):
        from tests.order import ordered

        items[:] = ordered(items)


def pytest_collection_finish() -> None:
    """What is there by now stays: that it was looked through again and again took a fourteenth of the tests' time."""
    gc.freeze()


@pytest.fixture(scope="session", autouse=True)
def state(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Nothing is kept in the home of who runs the tests."""
    os.environ["XDG_STATE_HOME"] = str(tmp_path_factory.mktemp("state"))


@pytest.fixture(scope="module")
def stalls(tmp_path_factory: pytest.TempPathFactory) -> Generator[object]:
    """Tells times when force was late from times when the machine stood still: `tests.stalls.Stalls`."""
    from tests.stalls import Stalls

    watch = Stalls(tmp_path_factory.mktemp("stalls"))
    yield watch
    watch.close()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> Generator[None, pytest.TestReport]:
    """Notes that a test failed because the machine stood still."""
    report = yield
    report.stalled = call.excinfo is not None and call.excinfo.typename == "Stalled"  # type: ignore[attr-defined]
    return report


def pytest_runtest_protocol(item: pytest.Item, nextitem: pytest.Item | None) -> bool | None:
    """Takes such a test again, twice at most."""
    if "stalls" not in getattr(item, "fixturenames", ()):
        return None
    item.ihook.pytest_runtest_logstart(nodeid=item.nodeid, location=item.location)
    for again in (True, True, False):
        reports = runtestprotocol(item, nextitem=nextitem, log=False)
        if not again or not any(getattr(report, "stalled", False) for report in reports):
            break
    for report in reports:
        item.ihook.pytest_runtest_logreport(report=report)
    item.ihook.pytest_runtest_logfinish(nodeid=item.nodeid, location=item.location)
    return True
