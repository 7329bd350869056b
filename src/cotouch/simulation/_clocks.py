"""How long every user's steps last, as clocks are set and as waiting for others makes them."""

import numpy as np

from cotouch.arrays import Float
from cotouch.errors import ScenarioError
from cotouch.scenario import Scenario, per_user

_DEFAULT_PERIOD = 1e-3
_MOST_STEPS = 50_000_000


def step_lengths(scenario: Scenario, users: int, *, common: bool) -> Float:
    """Nominal step lengths, (users, steps) [s].

    Args:
        scenario: that asks for them.
        users: how many.
        common: whether all count their steps alike: then as many as there may be time for.

    Raises:
        ScenarioError: the run is shorter than a step, or has too many.
    """
    steps = scenario.steps
    most = most_steps(scenario)
    if steps.random is not None:
        low, high = steps.random.low, steps.random.high
        seeds = (np.random.SeedSequence((scenario.seed, 1, i)) for i in range(users))
        lengths = np.array([np.random.Generator(np.random.PCG64(seed)).uniform(low, high, most) for seed in seeds])
    else:
        lengths = np.broadcast_to(_periods(scenario)[:, None], (users, most))
    if common:
        apart = steps.random is not None and scenario.synchronisation.mode == "self-paced"
        # Where nobody waits for every slow step of another, as many as the fastest could take by itself.
        clocks = np.cumsum(lengths, axis=1) if apart else _clock(lengths)[None, :]
        limit = steps.duration * (1.0 + 1e-12) + 1e-12
        lengths = lengths[:, : max(int(np.searchsorted(clock, limit, side="right")) for clock in clocks)]
    if lengths.shape[1] < 1 or lengths[:, 0].max() > steps.duration * (1.0 + 1e-12):
        raise ScenarioError(f"the run lasts {steps.duration} s, which is less than one step; make it longer")
    return np.ascontiguousarray(lengths)


def together(nominal: Float) -> tuple[Float, Float]:
    """Ends and lengths of the steps of a common index, which nobody takes before all have taken the one before.

    T_i(k) is all the time that passes for user i from its step k - 1 to its step k: its own share, and before that its
    wait for the slowest. So every copy's time goes on with its user's clock, though T_i(k) differs from user to user.
    """
    clock = _clock(nominal)
    if (nominal == nominal.flat[0]).all():
        return np.tile(clock, (nominal.shape[0], 1)), nominal
    before = np.concatenate([[0.0], clock[:-1]])
    end = before + nominal
    waited = np.zeros_like(nominal)
    waited[:, 1:] = before[1:] - end[:, :-1]
    return end, nominal + waited


def bound_together(scenario: Scenario, nominal: Float, length: Float) -> Float:
    """Bound on T under a common index, which cannot cut a step off, (users,) [s].

    Args:
        scenario: says how long a step may be.
        nominal: lengths as clocks are set, (users, steps) [s].
        length: with waiting for others, likewise.

    Raises:
        ScenarioError: a step lasts longer than the scenario allows.
    """
    longest = scenario.synchronisation.max_step
    found = length.max(axis=1)
    if longest is None:
        return found
    bound = longest * nominal.max(axis=1)
    over = found / bound
    if over.max() > 1.0 + 1e-9:
        i = int(over.argmax())
        raise ScenarioError(
            f"synchronisation.max_step is {longest:g}; a step of user {i + 1} may last {bound[i]:.4g} s, but waiting "
            f'for the others makes one last {found[i]:.4g} s; raise it, or use mode "freshest", in which nobody waits'
        )
    return bound


def bound_apart(scenario: Scenario, nominal: Float, end: Float) -> Float:
    """Bound on T of self-paced users, (users,) [s].

    Args:
        scenario: says how long a step may be.
        nominal: lengths as clocks are set, (users, steps) [s].
        end: of every step, likewise.

    Raises:
        ScenarioError: with it a copy would never make up for its waits.
    """
    longest = scenario.synchronisation.max_step
    pace = end[:, -1] / end.shape[1]
    if longest is None:
        return 2.0 * pace  # leaves room to make up for a long wait
    bound = longest * nominal.max(axis=1)
    short = pace / bound
    if short.max() > 1.0 + 1e-9:
        i = int(short.argmax())
        raise ScenarioError(
            f"synchronisation.max_step is {longest:g}; a step of user {i + 1} simulates {bound[i]:.4g} s at most, "
            f"but it takes one every {pace[i]:.4g} s and its copy would live ever more slowly; make it at least "
            f'{np.ceil(longest * short[i]):g}, or use mode "freshest", in which nobody waits'
        )
    return bound


def _clock(lengths: Float) -> Float:
    """When all have taken each step of a common index: with the slowest user."""
    slowest = lengths.max(axis=0)
    if slowest.size and (slowest == slowest[0]).all():
        return slowest * np.arange(1, int(slowest.size) + 1)
    return np.cumsum(slowest)


def _periods(scenario: Scenario) -> Float:
    """Length of every user's steps where it is constant, (users,) [s]."""
    steps, users = scenario.steps, scenario.network.size
    if steps.rate is not None:
        return 1.0 / per_user(steps.rate, users, "steps.rate")
    return per_user(_DEFAULT_PERIOD if steps.period is None else steps.period, users, "steps.period")


def most_steps(scenario: Scenario) -> int:
    """How many steps there is room for: at least as many as any user takes.

    Raises:
        ScenarioError: they are too many.
    """
    steps = scenario.steps
    if steps.random is not None:
        shortest = steps.random.low
    else:
        # Under a common index the slowest says when all step.
        period = _periods(scenario)
        shortest = float(period.min() if scenario.synchronisation.mode == "freshest" else period.max())
    count = steps.duration / shortest
    if count > _MOST_STEPS:
        raise ScenarioError(
            f"the run lasts {steps.duration:g} s, which is {count:.3g} steps; at most {_MOST_STEPS:.0e} are possible, "
            "so make steps.duration shorter or its steps longer"
        )
    return int(np.ceil(count * (1.0 + 1e-12) - 1e-9)) + 1
