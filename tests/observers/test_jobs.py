import threading

import pytest

from cotouch.errors import SessionError
from cotouch.observers import Jobs


def asked(jobs: Jobs, job) -> tuple[threading.Thread, list[object]]:
    said: list[object] = []

    def run() -> None:
        try:
            said.append(jobs.ask(job))
        except SessionError as error:
            said.append(error)

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    return thread, said


def refuse() -> str:
    raise SessionError("no")


def test_another_thread_s_jobs_are_done_in_turn_and_mistakes_go_back() -> None:
    jobs, where = Jobs(), []

    def job() -> str:
        where.append(threading.get_ident())
        return "done"

    waiting = [asked(jobs, job), asked(jobs, refuse)]
    for _ in range(200):
        jobs.turn()
        if not any(thread.is_alive() for thread, _ in waiting):
            break
        for thread, _ in waiting:
            thread.join(0.01)
    assert waiting[0][1] == ["done"]
    assert where == [threading.get_ident()]
    assert str(waiting[1][1][0]) == "no"


def test_the_loop_s_own_jobs_are_done_at_once_and_none_after_the_end() -> None:
    jobs = Jobs()
    jobs.turn()
    assert jobs.ask(lambda: "now") == "now"
    thread, said = asked(jobs, lambda: "never")
    for _ in range(200):
        jobs.close()
        thread.join(0.01)
        if not thread.is_alive():
            break
    assert "over" in str(said[0])
    with pytest.raises(SessionError, match="over"):
        Jobs.ask(_closed(), lambda: "never")


def _closed() -> Jobs:
    jobs = Jobs()
    jobs.close()
    return jobs
