"""What every device coupling must do: conformance over the registry, and the accounts of both ends."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
import pytest

from cotouch.coupling import (
    END,
    DeviceCoupling,
    EnergyMessage,
    HeldForce,
    book_end,
    conform_coupling,
    device_couplings,
    end_row,
    hear,
    hold_gap,
    message_of,
    register_coupling,
    run_end,
)
from cotouch.device import installed_coupling
from cotouch.errors import DeviceError
from cotouch.installed import installed_names
from cotouch.kernels import kernel as compiled

Float = npt.NDArray[np.float64]
for name in installed_names("cotouch.couplings"):  # the suite is that of whoever brings a coupling, too
    installed_coupling(name)
EVERY = list(device_couplings().values())


def made(rng: np.random.Generator, *, latency: int = 0, initial: float = 5e-3) -> Float:
    return end_row(
        stiffness=float(10.0 ** rng.uniform(1.0, 4.0)),
        damping=float(rng.uniform(0.0, 5.0)),
        cap=0.1,
        reserve=1e-3,
        initial=initial,
        ages=float(rng.uniform(0.0, 0.02)),
        most=float(10.0 ** rng.uniform(0.0, 1.5)),
        latency=latency,
    )


def ask(row: Float, gap: Float, rate: Float, T: float, known: float = 1.0) -> None:
    row[END.T], row[END.known], row[END.gap : END.rate], row[END.rate : END.acting] = T, known, gap, rate


@pytest.mark.parametrize("proxy", [False, True], ids=["device", "proxy"])
@pytest.mark.parametrize("law", EVERY, ids=lambda law: law.name)
def test_a_spring_holds_no_more_than_there_is(law: DeviceCoupling, proxy: bool) -> None:
    rng = np.random.default_rng(0)
    half, shortened = law.half(proxy=proxy), 0
    for _ in range(500):
        row = made(rng, latency=0 if proxy else int(rng.integers(0, 2)))
        row[END.energy] = rng.normal(0.0, 0.02)
        row[END.acting] = 0.0 if proxy else rng.uniform(0.0, 1e-3)
        ask(row, rng.normal(0.0, 0.02, 3), rng.normal(0.0, 0.3, 3), 1e-3)
        half(row)
        out = row[END.spring : END.memory]
        assert np.isfinite(out).all()
        assert row[END.spring] >= 0.0
        assert row[END.brake] >= 0.0
        assert 0.0 <= row[END.fraction] <= 1.0
        stretch = row[END.stretch : END.push]
        assert row[END.held] == pytest.approx(0.5 * row[END.spring] * float(stretch @ stretch), rel=1e-12, abs=1e-15)
        assert row[END.held] <= max(0.0, row[END.energy]) * (1.0 + 1e-12)
        assert (row[END.starved] == 1.0) == (row[END.fraction] < 1.0)
        shortened += row[END.fraction] < 1.0
    assert shortened > 50


@pytest.mark.parametrize("proxy", [False, True], ids=["device", "proxy"])
@pytest.mark.parametrize("law", EVERY, ids=lambda law: law.name)
def test_without_a_place_there_is_no_spring_and_what_is_no_number_is_nothing(law: DeviceCoupling, proxy: bool) -> None:
    rng = np.random.default_rng(1)
    half = law.half(proxy=proxy)
    row = made(rng)
    ask(row, np.full(3, 0.01), np.zeros(3), 1e-3, known=0.0)
    half(row)
    assert row[END.spring] == row[END.held] == row[END.starved] == 0.0
    before = row[END.energy]
    for name in ("given", "received", "put", "taken", "known", "tank"):
        hear(row, EnergyMessage(given=1.0, put=1.0)._replace(**{name: np.nan}))
        half(row)
        assert row[END.energy] <= before + 1.0
        assert np.isfinite(row[END.energy])
    ask(row, np.full(3, np.nan), np.zeros(3), 1e-3)
    hear(row, EnergyMessage())
    half(row)
    assert row[END.held] == 0.0
    assert not row[END.stretch : END.push].any()


@pytest.mark.parametrize("proxy", [False, True], ids=["device", "proxy"])
@pytest.mark.parametrize("law", EVERY, ids=lambda law: law.name)
def test_messages_may_be_lost_repeated_and_overtaken(law: DeviceCoupling, proxy: bool) -> None:
    """Sums only rise: whatever comes in whatever order, each joule is counted once."""
    rng = np.random.default_rng(2)
    sums = np.cumsum(rng.uniform(0.0, 1e-3, 30))
    messages = [EnergyMessage(given=s, put=s, taken=0.25 * s) for s in sums]
    half, row = law.half(proxy=proxy), made(rng)
    row[END.cap] = np.inf
    for k in [*rng.integers(0, 29, 60), 29, 0]:
        hear(row, messages[k])
        ask(row, np.zeros(3), np.zeros(3), 1e-3)
        half(row)
    share = 0.75 if law.pools else 1.0
    assert row[END.energy] == pytest.approx(row[END.initial] + share * sums[-1], rel=1e-12)


@dataclass
class Worst:
    """The most that both ports gave, less what friction paid, as a share of what they may."""

    used: float
    shortened: float


def through(law: DeviceCoupling, seed: int, *, latency: int, books: bool = True) -> Worst:
    """A hand that does its worst at the device, a mass that is shaken at the proxy; mailboxes late, lost, repeated."""
    rng = np.random.default_rng(seed)
    device = made(rng, latency=latency, initial=float(10.0 ** rng.uniform(-4, -2)))[None, :]
    proxy = device.copy()
    proxy[0, END.latency] = 0.0
    k, b = device[0, END.stiffness], device[0, END.damping]
    here, there = law.half(proxy=False), law.half(proxy=True)
    T, mass = 1e-3, float(10.0 ** rng.uniform(-2, 0))
    q, y, w = np.zeros(3), np.zeros(3), np.zeros(3)
    force, coming, before = np.zeros(3), np.zeros(3), np.zeros(3)
    gave = worst = fastest = strongest = 0.0
    short, mail = 0, ([(y, EnergyMessage())], [(q, before, EnergyMessage())])
    every, eager = int(rng.integers(1, 8)), float(rng.choice([0.0, 0.5, 1.0]))
    for n in range(1500):
        size = float(np.linalg.norm(force))
        along = eager * rng.uniform(0.0, 1.0) * T * force / size if size else np.zeros(3)
        moved = along + (1.0 - eager) * rng.normal(0.0, 3e-4, 3)
        q = q + moved
        gave += float(force @ moved)
        if books:
            book_end(device, 0, float(force @ moved), 0.0, 0.0)
        fastest = max(fastest, float(np.linalg.norm(moved)) / T)
        device[0, END.acting] = device[0, END.held] if latency else 0.0
        known, message = mail[0][max(-1 - int(rng.integers(0, 20)), -len(mail[0]))]
        hear(device[0], message)
        ask(device[0], known - q, moved / T, T)
        here(device[0])
        short += device[0, END.fraction] < 1.0
        decided = device[0, END.spring] * device[0, END.stretch : END.push] - device[0, END.brake] * moved / T
        if device[0, END.energy] < -device[0, END.reserve]:
            decided = np.zeros(3)
        force, coming = (coming, decided) if latency else (decided, decided)
        strongest = max(strongest, float(np.linalg.norm(decided)))
        mail[1].append((q, moved / T, message_of(device[0])))
        if n % every == 0:
            S = every * T
            place, rate, message = mail[1][max(-1 - int(rng.integers(0, 20)), -len(mail[1]))]
            hear(proxy[0], message)
            ask(proxy[0], place - y, rate, S)
            there(proxy[0])
            pull, brake, s, c = (
                proxy[0, END.spring],
                proxy[0, END.brake],
                proxy[0, END.stretch : END.push],
                proxy[0, END.push : END.held],
            )
            push = rng.normal(0.0, 3.0, 3)
            mean = (2 * mass / S * w + pull * s + c + push) / (2 * mass / S + brake + pull * S / 2)
            done = S * float((pull * (s - S / 2 * mean) + c - brake * mean) @ mean)
            y, w = y + S * mean, 2 * mean - w
            gave += done
            if books:
                book_end(proxy, 0, done, 0.0, 0.0)
            mail[0].append((y, message_of(proxy[0])))
        worst = max(worst, gave)
    held = HeldForce(k, b, T, fastest, float(device[0, END.reserve]), strongest, 0.0)
    bound = 2.0 * float(device[0, END.initial]) + (1 + latency) * law.bound(held)
    return Worst(worst / bound, short / 1500)


@pytest.mark.parametrize("latency", [0, 1])
@pytest.mark.parametrize("law", EVERY, ids=lambda law: law.name)
def test_both_ports_together_give_no_more_than_the_bound(law: DeviceCoupling, latency: int) -> None:
    runs = [through(law, seed, latency=latency) for seed in range(6)]
    assert max(run.used for run in runs) <= 1.0
    assert max(run.used for run in runs) > 0.1  # it got at what was there
    assert max(run.shortened for run in runs) > 0.1


def _greedy(end: Float) -> None:
    hold_gap(end, 1.0, 1.0, end[END.damping], 0.0)


def test_a_law_that_holds_more_than_there_is_is_found() -> None:
    law = DeviceCoupling(name="greedy", device=_greedy, proxy=_greedy, bound=device_couplings()["pspm"].bound)
    assert max(through(law, seed, latency=0).used for seed in range(6)) > 1.0


def test_an_account_that_books_nothing_is_found() -> None:
    assert max(through(device_couplings()["pspm"], seed, latency=0, books=False).used for seed in range(6)) > 1.0


@pytest.mark.parametrize("law", EVERY, ids=lambda law: law.name)
def test_a_kernel_calls_what_python_calls(law: DeviceCoupling) -> None:
    @compiled
    def called(address: int, rows: Float) -> None:
        run_end(address, rows, 1)

    for proxy in (False, True):
        row = made(np.random.default_rng(3))
        ask(row, np.full(3, 0.01), np.full(3, 0.1), 1e-3)
        rows = np.stack([row, row])
        law.half(proxy=proxy)(row)
        untouched = rows[0].copy()
        called(law.address(proxy=proxy), rows)
        np.testing.assert_array_equal(rows[1], row)
        np.testing.assert_array_equal(rows[0], untouched)
        assert not np.array_equal(rows[1], untouched)


def test_gifts_keep_every_joule() -> None:
    """Tanks, what they gave and what is on its way add up to the initial energies less the ports' work."""
    rng = np.random.default_rng(1)
    law = device_couplings()["pspm"].half(proxy=True)
    rows = np.stack([end_row(stiffness=500.0, damping=1.0, cap=0.05, initial=energy) for energy in (0.02, 0.01)])
    for _ in range(1000):
        for one, other in ((0, 1), (1, 0)):
            if rng.random() < 0.5:
                hear(rows[one], message_of(rows[other]))
                ask(rows[one], rng.normal(0.0, 0.02, 3), np.zeros(3), 5e-3)
                law(rows[one])
                book_end(rows, one, float(rng.normal(0.0, 1e-3)), 0.0, 1e-6)
        a, b = rows
        under_way = (a[END.given] - b[END.received]) + (b[END.given] - a[END.received])
        there = rows[:, END.energy].sum() + rows[:, END.lost].sum() + under_way
        assert there == pytest.approx(0.03 - rows[:, END.work].sum(), abs=1e-12)
        assert a[END.received] <= b[END.given] + 1e-15
        assert b[END.received] <= a[END.given] + 1e-15
    assert rows[:, END.given].min() > 1e-3


@pytest.mark.parametrize("law", EVERY, ids=lambda law: law.name)
def test_every_coupling_conforms(law: DeviceCoupling) -> None:
    assert conform_coupling(law) == []


def _lost(end: Float) -> None:
    hold_gap(end, 0.0, 1.0, np.sqrt(-1.0 - end[END.energy] ** 2), 0.0)


def _pushes(end: Float) -> None:
    hold_gap(end, 0.0, 1.0, -end[END.damping], 0.0)


def _hides(end: Float) -> None:
    hold_gap(end, 1.0, 1.0, 0.0, 0.0)
    end[END.held] = 0.0


def _richer(end: Float) -> None:
    end[END.energy] += 1.0
    hold_gap(end, 0.0, 1.0, 0.0, 0.0)


def _astray(end: Float) -> None:
    for axis in range(3):
        end[END.stretch + axis] = 1e-6
    end[END.spring] = end[END.stiffness]
    end[END.held] = 1.5e-12 * end[END.spring]
    end[END.starved] = end[END.known]


def _content(end: Float) -> None:
    hold_gap(end, 0.0, 1.0, 0.0, 0.0)
    end[END.starved] = 0.0


def _too_far(end: Float) -> None:
    hold_gap(end, 0.0, 1.0, 0.0, 0.0)
    end[END.fraction] = 1.5
    end[END.starved] = 0.0


@pytest.mark.parametrize(
    ("half", "said"),
    [
        (_lost, "what it writes is no number"),
        (_pushes, "its spring or its damper is below 0"),
        (_hides, "held is not the energy of its spring, ½ k ‖stretch‖²"),
        (_greedy, "its spring holds more energy than its end has"),
        (_richer, "it changes the energy of its end otherwise than by share, pool and discard"),
        (_astray, "it has a spring where no place is known"),
        (_content, "starved does not say whether it follows only in part"),
        (_too_far, "its fraction is not from 0 to 1"),
    ],
)
def test_what_breaks_the_interface_is_said_of_either_end(half: Callable[[Float], None], said: str) -> None:
    sound = device_couplings()["pspm"]
    assert f"{said} (device)" in conform_coupling(replace(sound, name="odd", device=half, _made={}))
    assert f"{said} (proxy)" in conform_coupling(replace(sound, name="odd", proxy=half, _made={}))


@pytest.mark.parametrize(
    ("bound", "said"),
    [
        (lambda held: 1.0 / 0.0, "bound cannot be worked out: float division by zero (ZeroDivisionError)"),
        (lambda held: np.nan, "bound is nan J; it must be a finite number of at least 0"),
        (lambda held: -1e-3, "bound is -0.001 J; it must be a finite number of at least 0"),
    ],
)
def test_a_bound_that_is_none_is_said(bound: Callable[[HeldForce], float], said: str) -> None:
    sound = device_couplings()["pspm"]
    assert conform_coupling(replace(sound, name="odd", bound=bound, _made={})) == [said]


def _beyond(end: Float) -> None:
    hold_gap(end, 0.0, 1.0, 0.0, 0.0)
    end[END.memory + 4] = 1.0


def _misspelt(end: Float) -> None:
    end[END.gop] = 1.0  # pyright: ignore[reportAttributeAccessIssue, reportUnknownArgumentType, reportUnknownMemberType]


def _stops(end: Float) -> None:
    assert end[END.stiffness] > 0.0
    hold_gap(end, 0.0, 1.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("half", "said"),
    [
        (_stops, 'coupling "odd" raises an error or asserts (test_law.py, line '),
        (_beyond, 'coupling "odd" leaves its row: index 53 is out of bounds for axis 0 with size 53 (test_law'),
        (_misspelt, "coupling \"odd\" cannot be compiled: Unknown attribute 'gop' of type EndFields"),
    ],
)
def test_what_a_coupling_gets_wrong_is_one_sentence(half: Callable[[Float], None], said: str) -> None:
    law = DeviceCoupling(name="odd", device=half, proxy=half)
    for proxy in (False, True):
        with pytest.raises(DeviceError) as caught:
            law.half(proxy=proxy)
        assert str(caught.value).startswith(said)
        assert "\n" not in str(caught.value)


@pytest.mark.parametrize("name", ["", "é" * 17])
def test_a_name_that_a_servo_could_not_be_told_is_refused(name: str) -> None:
    with pytest.raises(DeviceError, match=f'^the name of the coupling "{name}" must have 1 to 32 bytes$'):
        register_coupling(DeviceCoupling(name=name, device=_beyond, proxy=_beyond))
    assert name not in device_couplings()
