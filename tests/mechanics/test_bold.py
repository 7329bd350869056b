"""Steps far too long for what pulls: they go as far as their energy allows, which is somewhere; no body freezes."""

import numpy as np
import pytest
from tests.mechanics.inside import SWEEPS
from tests.mechanics.materials import EVERY, FLOATS, Alone, bent, energy_at, made, rotation

from cotouch.body import Placed, together
from cotouch.mechanics import ELASTIC, KINETIC, SHORTENED

# Of forty steps, so many may be shortened; which ones, rounding decides.
FEW = 8
SOFT = [name for name in EVERY if name != "rigid"]


@pytest.mark.parametrize("name", SOFT)
def test_a_body_that_a_great_force_pulls_within_long_steps_goes_on(name: str) -> None:
    """A hundred times its weight, in steps of five times its slowest period: halves of a step would all do too much."""
    copy = Alone(made(name, ground="x-", hold=50.0, gravity=(0.0, 0.0, -1000.0)))
    whole, shorter, most, far = copy.energy, [], 0.0, 0.0
    for _ in range(40):
        ledger = copy.step(0.03)
        shorter.append(float(ledger[SHORTENED]))
        most, far = max(most, float(np.abs(ledger[[KINETIC, ELASTIC]]).max())), max(far, np.abs(copy.position).max())
        assert copy.energy == pytest.approx(whole, abs=1e-12 * max(most, 1e-3))
    assert sum(part > 0.0 for part in shorter) <= FEW
    assert max(shorter) < 1.0
    assert far > 0.1


def test_bodies_that_do_not_touch_are_shortened_each_by_itself() -> None:
    """The one that hangs swings, and the other falls."""
    hangs = made("cells", ground="x-", hold=50.0, gravity=(0.0, 0.0, -1000.0))
    body = together([Placed(body=hangs, name="one"), Placed(body=made("cells"), name="other", at=(0.0, 1.0, 0.0))])
    pair = Alone(body.with_gravity((0.0, 0.0, -1000.0)))
    whole, still = pair.energy, 0
    for _ in range(40):
        ledger = pair.step(0.03)
        still += ledger[SHORTENED] == 1.0
        most = max(whole, float(np.abs(ledger[[KINETIC, ELASTIC]]).max()))
        assert pair.energy == pytest.approx(whole, abs=1e-12 * max(most, 1.0))
    assert still <= FEW
    assert pair.position[hangs.nodes :, 2].max() < -0.2 * 1000.0 * (40 * 0.03) ** 2
    assert np.abs(pair.position[: hangs.nodes]).max() > 0.05


def test_who_is_beside_a_body_that_is_searched_for_goes_as_if_alone() -> None:
    """Its own looks close its step; the one that hangs needs a search, from rest."""
    gravity, T = (0.0, 0.0, -1000.0), 0.03
    hangs, other = made("cells", ground="x-", hold=50.0), made("cells")
    spin = np.cross([0.0, 0.0, 5.0], other.rest - other.rest.mean(axis=0))
    both = together([Placed(body=hangs, name="one"), Placed(body=other, name="other", at=(0.0, 1.0, 0.0))])
    pair = Alone(both.with_gravity(gravity), velocity=np.concatenate([0.0 * hangs.rest, spin]))
    alone = Alone(other.with_gravity(gravity), velocity=spin)
    for copy in (pair, alone):
        copy.step(T)
    assert pair.position[hangs.nodes :] == pytest.approx(alone.position, abs=1e-5)


@pytest.mark.parametrize("name", sorted({"cells", "corotated"} - FLOATS))
def test_rotations_are_those_of_the_place_however_far_a_step_turns(name: str) -> None:
    """So that whoever works the energy out anew, from the place alone, finds the same."""
    body = made(name)
    copy = Alone(body)
    place = (body.rest + bent(body, 0.6)) @ rotation([1.0, 2.0, 2.0], 0.7).T - body.rest
    x, ahead, still = (copy.rows(field) for field in (np.zeros_like(place), place, np.zeros_like(place)))
    memory = copy.state.memory
    once, _ = energy_at(copy.force, memory, x, ahead, still, SWEEPS, copy.model.lanes)
    again, _ = energy_at(copy.force, memory, ahead, ahead, still, 60, copy.model.lanes)
    assert once == pytest.approx(again, rel=1e-9)


@pytest.mark.parametrize("name", ["cells", "corotated", "floating", "elastic floating"])
def test_energy_of_what_is_inside_out_is_that_of_its_place(name: str) -> None:
    """Whatever it went through to get there; sweeps alone end at saddles, and another history at other ones."""
    body = made(name)
    copy, rng = Alone(body), np.random.default_rng(6)
    size = float(np.ptp(body.rest, axis=0).max())
    places = [copy.rows(rng.normal(scale=size, size=body.rest.shape)) for _ in range(12)]
    still, lanes = copy.rows(np.zeros_like(body.rest)), copy.model.lanes
    fresh, used = copy.model.unturned(), copy.state.memory
    for before, place in zip(places[-1:] + places[:-1], places, strict=True):
        followed, _ = energy_at(copy.force, used, before, place, still, SWEEPS, lanes)
        at_once, _ = energy_at(copy.force, fresh.copy(), place, place, still, 60, lanes)
        assert followed == pytest.approx(at_once, rel=1e-12)
