"""Tuning: the same search for every law, on draws that do not count afterwards."""

from collections.abc import Mapping

import numpy as np

from cotouch.arrays import Float
from cotouch.errors import CotouchError
from cotouch.interrupt import check
from cotouch.laboratory._cell_tables import Setting, TuneCell, TunedSettings
from cotouch.laboratory._ideal import Ideal, ideal
from cotouch.laboratory._score import dangerous, measures_of, promises
from cotouch.laboratory._study import HandKind, Study, tunable
from cotouch.laboratory._tasks import Hands
from cotouch.laboratory._trials import made_energy, wild
from cotouch.network import Network
from cotouch.simulation import prepare, with_hands

# First step of the local search, of the width of the space; how a step changes where it helps and where it doesn't.
_STEP, _LONGER, _SHORTER = 0.15, 1.5, 0.9
# So many of the best settings are asked whether they are safe.
_CANDIDATES = 8
# How long a random run is [s].
_TRIED = 3.0


def tune(cell: TuneCell) -> TunedSettings:
    """The best setting of one law on one network, as multiples of what its parameters would be.

    A setting counts only if pushes die away, with the hands and with stiffer ones. What costs more than the best so far
    is given up as soon as that is certain.

    Args:
        cell: a `study` with one law, one network and one number of users.

    Returns:
        `settings`: of "published" (all multiples 1), "tuned" and, where asked for, "safe"; None where there is none.
        `cost` of each on the draws of the tuning, `tried`, how many settings were; `problem`, why there is nothing.
    """
    study = Study.make(**cell["study"])
    law, network, tuning = study.laws[0], study.networks[0], study.tuning
    names, users, hand = tunable(law), study.users[0], study.hands[0]
    stiffer = HandKind(stiffness=study.stiffer * hand.stiffness, damping=hand.damping)
    count = len(study.tasks) * tuning.draws
    wanted: dict[int, list[tuple[Hands, Ideal]]] = {}
    for draw in range(-tuning.draws, 0):
        tasks = [study.task(name, users, hand, draw) for name in study.tasks]
        wanted[draw] = [(hands, ideal(study, hands)) for hands in tasks]

    def cost(setting: Mapping[str, float], most: float) -> float:
        """On the draws of the tuning; infinite where it is more, where pushes grow, or where a promise is given up."""
        total = 0.0
        for draw, tasks in wanted.items():
            seed = study.channel_seed(network, draw)
            prepared = prepare(study.scenario(law, network, users, [], seed=seed, setting=setting))
            if promises(law) and prepared.law is not None and not prepared.law.holds:
                return float("inf")
            for hands, perfect in tasks:
                check()
                total += measures_of(law, with_hands(prepared, hands), perfect)["cost"] / count
                if not total < most:
                    return float("inf")
        kinds = (hand, stiffer)
        return float("inf") if any(dangerous(study, law, network, users, k, setting) for k in kinds) else total

    published = dict.fromkeys(names, 1.0)
    try:
        found = [(cost(published, float("inf")), published)]
    except CotouchError as error:
        return {"settings": {}, "cost": {}, "tried": 0, "problem": str(error)}
    width = np.log(tuning.range)
    rng = np.random.default_rng((study.seed, 18))
    best, here = found[0][0], np.zeros(len(names))
    step = _STEP
    tries = tuning.search + tuning.local if names else 0
    for number in range(tries):
        if number < tuning.search:
            place = width * (2.0 * _filling(number, len(names)) - 1.0)
        else:
            place = np.clip(here + step * width * rng.standard_normal(len(names)), -width, width)
        setting = {name: float(np.exp(x)) for name, x in zip(names, place, strict=True)}
        value = cost(setting, best)
        better = value < best
        if better:
            best, here = value, place
            found.append((value, setting))
        if number >= tuning.search:
            step *= _LONGER if better else _SHORTER
    ranked = sorted((entry for entry in found if np.isfinite(entry[0])), key=lambda entry: entry[0])
    settings: dict[str, Setting | None] = {"published": published, "tuned": ranked[0][1] if ranked else None}
    costs = {"published": found[0][0], "tuned": ranked[0][0] if ranked else float("inf")}
    if tuning.safe:
        safe = next((entry for entry in ranked[:_CANDIDATES] if harmless(study, entry[1], tuning.safe)), None)
        settings["safe"], costs["safe"] = (safe[1], safe[0]) if safe else (None, float("inf"))
    return {"settings": settings, "cost": costs, "tried": 1 + tries, "problem": ""}


def harmless(study: Study, setting: Mapping[str, float], runs: int) -> bool:
    """Whether random runs make no energy beyond what the law declares; replicas declare nothing, so they don't pass.

    Args:
        study: with one law.
        setting: of it.
        runs: how many.
    """
    law, sources = study.laws[0], study.networks[0]
    if law.replica is not None:
        return False
    for number in range(runs):
        check()
        rng = np.random.default_rng((study.seed, 19, number))
        users = int(rng.integers(2, 5))
        scenario = study.scenario(law, sources, users, [], seed=number, setting=setting)
        spring = scenario.network.spring * _symmetric(10.0 ** rng.uniform(-0.5, 0.5, (users, users)))
        anything = wild(rng, users, _TRIED)
        changed = scenario.replace(
            network=Network(users=scenario.network.users, spring=spring, delay=anything.delay),
            steps=anything.steps,
            channel=anything.channel,
            hands=study.placed(anything.hands, users),
        )
        if not made_energy(prepare(changed)).kept:
            return False
    return True


def _symmetric(values: Float) -> Float:
    return np.sqrt(values * values.T)


_SOBOL: dict[int, Float] = {}


def _filling(number: int, dimensions: int) -> Float:
    """A point of a sequence that fills the unit cube evenly [Sobol' 1967]."""
    from scipy.stats import qmc

    if dimensions not in _SOBOL:
        _SOBOL[dimensions] = qmc.Sobol(dimensions, scramble=False).random_base2(13)[1:]
    return _SOBOL[dimensions][number]
