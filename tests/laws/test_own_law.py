"""A researcher's own law, in this one file; laws that lie; what is wrong with a law's options."""

import re
import runpy
from dataclasses import replace
from math import inf, nan
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.laws.scenes import OTHERS, two

from cotouch import laws as cotouch_laws
from cotouch.errors import NetworkError, ScenarioError
from cotouch.laws import (
    PAID,
    WAVE,
    BoundEnd,
    End,
    Facts,
    Law,
    OriginForce,
    Parameter,
    Tone,
    brake,
    copy,
    given_power,
    laws,
    register,
    square,
)
from cotouch.scenario import Scenario
from cotouch.simulation import judge, prepare, simulate, summary


# --- a law: a spring to where the neighbour will be, if it goes on as it goes ----------------------------------------
def _before(end: End) -> None:
    for i in range(end.target.shape[0]):
        end.target[i] = end.sample[i] + end.parameters[0] * end.age * end.received[0, i]
    end.gains[0] = end.spring


def _after(end: End) -> None:
    copy(end.sent[0], end.mean)


AHEAD = register(
    Law(
        name="foresight",
        before=_before,
        after=_after,
        parameters=(Parameter(name="fraction", meaning="of the age that it looks ahead", default=1.0, most=2.0),),
        sends=("v",),
        passive=False,
    )
)
# ---------------------------------------------------------------------------------------------------------------------


def scenario(law: object, *, delay: float = 0.1, **tables: object) -> Scenario:
    return Scenario.make(
        network=two(delay),
        **{"steps": {"duration": 4.0}, **tables},
        synchronisation={"law": law},
        hands=[{"user": 1, "stiffness": 300, "path": 0.1}, {"user": 2, "stiffness": 300, "path": 0.0}],
    )


def test_a_law_of_ones_own_runs() -> None:
    run = simulate(scenario({"kind": "foresight", "fraction": 0.5}, delay=0.01))
    assert run.attrs["law"] == "foresight"
    assert run.attrs["energy_residual"] < 1e-12
    assert run["position"].values[1, -1, 0, 0] > 0.001
    other = simulate(scenario({"kind": "foresight", "fraction": 1.0}, delay=0.01))
    assert abs(run["position"].values - other["position"].values).max() > 1e-4


def test_an_end_that_lasts_says_what_changed() -> None:
    fields = dict.fromkeys(("weight", "position", "velocity", "mean", "hand", "touch", "push"), np.zeros(3))
    tables = dict.fromkeys(("memory", "shared"), np.zeros((0, 3)))
    target, gains, sent = np.zeros(3), np.zeros(2), np.zeros((1, 3))
    first = End(
        **fields,
        **tables,
        **dict.fromkeys(("received_scalars", "scalars", "shared_scalars", "sent_scalars"), np.zeros(0)),
        **dict.fromkeys(("T", "age"), 0.5),
        **dict.fromkeys(("sample_index", "step", "side", "copies", "width"), 1),
        **dict.fromkeys(("new", "first", "last"), True),
        spring=7.0,
        parameters=np.array([2.0]),
        sample=np.array([1.0, 2.0, 3.0]),
        received=np.array([[0.0, 10.0, 0.0]]),
        target=target,
        gains=gains,
        sent=sent,
    )
    end = BoundEnd(first)
    end.run(AHEAD.parts[0])
    assert target.tolist() == [1.0, 12.0, 3.0]
    assert gains[0] == 7.0
    first.sample[0] = 4.0  # what is in an array is read where it lies
    end.write(age=1.0, spring=8.0, received=np.array([[0.0, 1.0, 0.0]]))
    end.run(AHEAD.parts[0])
    assert target.tolist() == [4.0, 4.0, 3.0]
    assert gains[0] == 8.0
    other = np.array([-1.0, -2.0])  # another size, too
    end.write(sample=other, received=np.array([[0.0, 0.0]]), target=(shorter := np.zeros(2)))
    end.run(AHEAD.parts[0])
    assert shorter.tolist() == [-1.0, -2.0]
    assert target.tolist() == [4.0, 4.0, 3.0]
    end.write(mean=np.array([5.0, 6.0, 7.0]))
    end.run(AHEAD.parts[1])
    assert sent.tolist() == [[5.0, 6.0, 7.0]]
    with pytest.raises(AssertionError, match="mean"):
        end.write(mean=np.zeros(6)[::2])


def test_the_law_in_the_documents_is_one_file_and_runs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = (Path(__file__).parents[2] / "docs" / "laws.md").read_text(encoding="utf-8")
    law, use = re.findall(r"```python(?: title=\"my_law.py\")?\n(.*?)```", text, re.DOTALL)
    path = tmp_path / "ahead.py"
    path.write_text(law + use.replace("import my_law\n", ""), encoding="utf-8")
    assert len(path.read_text(encoding="utf-8").splitlines()) < 60
    assert runpy.run_path(str(path))["run"].attrs["energy_residual"] < 1e-12
    assert capsys.readouterr().out.startswith("ahead ")


def test_the_documents_name_every_law() -> None:
    text = (Path(__file__).parents[2] / "docs" / "laws.md").read_text(encoding="utf-8")
    for name in OTHERS:
        assert f"| `{name}`" in text or not laws()[name].before.__module__.startswith("cotouch.")


def test_a_law_that_lies_about_its_energy_is_caught() -> None:
    register(replace(AHEAD, name="liar", passive=True, _parts=[]))
    judged = judge(simulate(scenario("liar")))
    assert judged["promised"]
    assert judged["made_j"] > judged["initial_energy_j"] == 0.0
    assert not judged["kept"]
    assert judged["law"] == "liar"


def _too_far(end: End) -> None:
    end.push[0] = nan if end.step > 10 else 0.0
    end.gains[1] = 1.0


def test_a_law_whose_motion_leaves_floating_point_keeps_no_promise() -> None:
    register(Law(name="mad", before=_too_far, after=_silent))
    run = simulate(scenario("mad", steps={"duration": 0.1}))
    assert not run.attrs["finished"]
    judged = judge(run)
    assert judged["promised"]
    assert not judged["kept"]
    assert judged["made_j"] == inf


def _mad_at_once(end: End) -> None:
    end.push[0] = nan
    end.gains[1] = 1.0


@pytest.mark.parametrize(("half", "steps"), [(_mad_at_once, 0), (_too_far, 11)])
def test_the_step_in_which_the_motion_leaves_floating_point_is_none_of_the_run(half: Any, steps: int) -> None:
    """What was in memory before was shown as where users were after that step, and as energies."""
    register(Law(name="mad", before=half, after=_silent))
    mad = scenario("mad", steps={"duration": 0.1})
    run = simulate(mad)
    found = summary(run, mad.build_body())
    assert found["steps"] == run.attrs["steps"] == steps
    assert np.isfinite(run.position.values).any(axis=(0, 2, 3)).tolist() == [True] * (steps + 1) + [False] * (
        100 - steps
    )
    assert np.isfinite([*found["age_s"].values(), *found["energy_j"].values()]).all()


def _slip(end: End) -> None:
    end.gains[0] = end.sprung  # pyright: ignore[reportAttributeAccessIssue]


def _new_array(end: End) -> None:
    end.push[:] = end.spring * (end.sample - end.position)


def _moves(end: End) -> None:
    end.velocity[0] *= 1.01


def _moves_by_copying(end: End) -> None:
    copy(end.position, end.sample)


def _two(end: End, other: End) -> None:
    copy(end.push, other.push)


@pytest.mark.parametrize(
    ("half", "cause"),
    [
        (_slip, r"Unknown attribute 'sprung' of type End \(test_own_law.py, line \d+\)"),
        (_new_array, "it makes a new array, .* loop over the numbers"),
        (_moves, "it writes an array of End that is no result, memory or message of its own"),
        (_moves_by_copying, "it writes an array of End that is no result, memory or message of its own"),
        (_two, r"Signature mismatch: 1 argument types given, but function takes 2 arguments \(.*, function _two\)"),
        (print, "is no function written in Python"),
    ],
)
def test_what_cannot_be_compiled_is_one_sentence(half: Any, cause: str) -> None:
    """It ended the process when a run asked for the machine code; what moves copies without work would be no law."""
    for law in (Law(name="wrong", before=half, after=_silent), Law(name="wrong", before=_silent, after=half)):
        with pytest.raises(NetworkError, match=f'^law "wrong" cannot be compiled: .*{cause}') as caught:
            _ = law.parts
        assert "\n" not in str(caught.value)


def _raises(end: End) -> None:
    if end.step > 3:
        raise ValueError


def _asserts_within(end: End) -> None:
    _positive(end.T)


def _positive(number: float) -> None:
    assert number > 0.0


@pytest.mark.parametrize("half", [_raises, _asserts_within])
def test_what_raises_is_refused_as_nobody_would_hear_of_it(half: Any) -> None:
    """Machine code wrote the error to the terminal in every step, and the run went on with what was written before."""
    law = Law(name="wrong", before=half, after=_silent)
    with pytest.raises(NetworkError, match=r'^law "wrong" raises an error or asserts \(test_own_law.py, line \d+\)'):
        _ = law.parts


@pytest.mark.parametrize(
    ("default", "sentence"),
    [
        (lambda facts: 1.0 / 0.0, r'the default of "share" cannot be worked out: .*division by zero \(ZeroDivisionEr'),
        (lambda facts: nan, 'the default of "share" is nan; it must be a number from 0 to 1'),
        (2.0, 'the default of "share" is 2; it must be a number from 0 to 1'),
    ],
)
def test_a_default_that_is_none_is_one_sentence(default: Any, sentence: str) -> None:
    share = Parameter(name="share", meaning="of nothing", default=default, most=1.0)
    with pytest.raises(NetworkError, match=f'^law "wrong": {sentence}'):
        Law(name="wrong", before=_silent, after=_silent, parameters=(share,)).values(
            Facts(spring=50.0, age=0.1, age_back=0.1), {}
        )


@pytest.mark.parametrize(
    ("linear", "sentence"),
    [
        (lambda tone: 1 / 0, r"linear\(tone\) cannot be worked out: division by zero \(ZeroDivisionError\)$"),
        (lambda tone: tone.s, r"linear\(tone\) cannot be worked out: .*\(TypeError\)$"),
        (lambda tone: (nan, tone.s), r"linear\(tone\) is nan.*, 0\+2j at 2 1/s; it must be finite$"),
    ],
)
def test_a_linear_law_that_is_none_is_one_sentence(linear: Any, sentence: str) -> None:
    law = Law(name="wrong", before=_silent, after=_silent, linear=linear)
    with pytest.raises(NetworkError, match=f'^law "wrong": {sentence}'):
        law.response(Tone(s=2j, spring=50.0, parameters=(), there=1.0, back=1.0))


def _too_many_rows(end: End) -> None:
    for i in range(end.push.shape[0] + 1):
        end.push[i] = end.spring


def _undeclared(end: End) -> None:
    end.scalars[0] = end.T


def _undeclared_message(end: End) -> None:
    copy(end.sent[1], end.mean)


def _longer_than_its_source(end: End) -> None:
    cotouch_laws.copy(end.gains, end.sent[0])  # what is compiled for kernels only runs as it is written, too


def _only_where_it_is_not_the_first(end: End) -> None:
    if end.step > 3 and end.sample_index >= 0:
        end.parameters[1]


@pytest.mark.parametrize(
    ("half", "cause"),
    [
        (_too_many_rows, "index 1 is out of bounds for axis 0 with size 1"),
        (_undeclared, "index 0 is out of bounds for axis 0 with size 0"),
        (_undeclared_message, "index 1 is out of bounds for axis 0 with size 1"),
        (_longer_than_its_source, "index 1 is out of bounds for axis 0 with size 1"),
        (_only_where_it_is_not_the_first, "index 1 is out of bounds for axis 0 with size 1"),
    ],
)
def test_an_index_beyond_what_a_law_declares_is_one_sentence(half: Any, cause: str) -> None:
    """Machine code wrote into other people's memory: energies of kilojoules, and the process ended with it."""
    declared = {"sends": ("v",), "parameters": (Parameter(name="one", meaning="", default=1.0),)}
    for halves in ({"before": half, "after": _silent}, {"before": _silent, "after": half}):
        with pytest.raises(NetworkError, match=rf'^law "far" leaves an array: {cause} \(\S+\.py, line \d+\)$'):
            _ = Law(name="far", **halves, **declared).parts


def test_what_laws_are_written_with_keeps_within() -> None:
    """Also where Python cannot do what machine code does: that says nothing against a law."""

    def before(end: End) -> None:
        end.gains[1] = 1.0 / (end.T - end.T)
        brake(end, given_power(end), 0.0, square(end.weight, end.push))

    assert len(Law(name="near", before=before, after=_silent).parts) == 2


def _negative(end: End) -> None:
    end.gains[1] = -1.0 if end.step > 10 else 0.0


def _infinite(end: End) -> None:
    end.gains[0] = nan if end.step > 10 else 0.0


def _silent(end: End) -> None:
    pass


@pytest.mark.parametrize("before", [_negative, _infinite])
def test_gains_that_no_link_can_have_are_refused_by_name(before: object) -> None:
    register(Law(name="mad", before=before, after=_silent))  # pyright: ignore[reportArgumentType]
    with pytest.raises(
        ScenarioError, match='law "mad" gives a link of user 1 a stiffness or damping that is not a finite'
    ):
        simulate(scenario("mad"))


def test_a_law_for_constant_delays_refuses_a_channel_that_varies() -> None:
    register(replace(WAVE, name="strict", constant_delay=True, _parts=[]))
    simulate(scenario("strict", steps={"duration": 0.1}))
    with pytest.raises(ScenarioError, match='"strict", which needs a constant delay, but the channel\'s varies'):
        prepare(scenario("strict", channel={"loss": 0.1}))
    with pytest.raises(ScenarioError, match="with steps of different lengths ages vary; give all the"):
        prepare(scenario("strict", steps={"duration": 0.1, "random": {"low": 0.001, "high": 0.004}}))


def test_a_law_for_constant_delays_has_them_by_an_index() -> None:
    """As the refusal says. Its promise holds as long as every sample is there in time."""
    register(replace(WAVE, name="strict", constant_delay=True, _parts=[]))
    strict, free = (
        scenario(law, channel={"jitter": {"scale": 0.02}}, steps={"duration": 0.5}).replace(
            synchronisation__mode="constant"
        )
        for law in ("strict", "wave")
    )
    promises = [
        simulate(each).attrs["law_promises"]
        for each in (strict, strict.replace(synchronisation__quantile=0.9), free.replace(synchronisation__quantile=0.9))
    ]
    assert promises == [1, 0, 1]


@pytest.mark.parametrize(
    ("law", "message"),
    [
        ("wvae", 'synchronisation.law is "wvae"; it must be one of '),
        ({"impedance": 1.0}, "synchronisation.law is .*give a law's name, or a table with it as kind"),
        ({"kind": "wave", "impedance": -1.0}, "synchronisation.law.impedance is -1.0; it must be a number at least 0"),
        ({"kind": "foresight", "fraction": 3}, "synchronisation.law.fraction is 3; it must be a number from 0 to 2"),
        ({"kind": "wave", "filter": nan}, "synchronisation.law.filter is nan; it must be a number at least 0"),
        (
            {"kind": "wave", "width": 1.0},
            'law.width is not a parameter of law "wave", which has: impedance, filter, initial_energy',
        ),
    ],
)
def test_wrong_options_are_one_sentence(law: object, message: str) -> None:
    with pytest.raises(ScenarioError, match=message) as caught:
        scenario(law)
    assert "\n" not in str(caught.value)


HAND = OriginForce(force="w", integral="P", double="Q", stiffness="k", damping="b", plain="as one")


@pytest.mark.parametrize(
    ("declared", "sentence"),
    [
        ({"initial_energy": "energy"}, 'declares the initial energy "energy", which is not one of its parameters'),
        ({"energies": ("E",)}, 'declares "E", which is not one of the numbers that it sends'),
        ({"sums": ("w", "no")}, 'declares the sum "no", which is not one of the fields that it sends'),
        ({"origin_force": replace(HAND, force="P")}, 'declares "P" of a hand, which is not a field that is no sum'),
        ({"origin_force": replace(HAND, double="w")}, 'declares "w" of a hand, which is not a sum'),
        ({"origin_force": replace(HAND, plain="w")}, 'declares "w" of a hand, which is not a number'),
    ],
)
def test_a_law_that_declares_what_it_has_not_is_one_sentence(declared: dict[str, Any], sentence: str) -> None:
    with pytest.raises(NetworkError, match=f'^law "odd" {sentence}'):
        register(replace(PAID, name="odd", **declared))
    assert "odd" not in laws()
