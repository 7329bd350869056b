"""The four blocks of Fig. 2 around a small solid: what their ports say, and that it would show if one made energy."""

import json
from dataclasses import replace

import matplotlib as mpl
import numpy as np
import pytest
from tests.network.support import five_users, pairs
from tests.study.inside import (
    BOOK,
    DEVICE,
    RELEASE,
    SHAPE,
    SMALL,
    Blocks,
    SolidFindings,
    blocks,
    chapter,
    claims,
    collaboration,
    copies,
    energies,
    scene,
    solid,
    warm_up,
)

from cotouch import drawing
from cotouch.simulation import prepare, run_batch

BEST = five_users().with_links(pairs("12 14 23 24 34 45"))


@pytest.fixture(scope="module")
def found() -> SolidFindings:
    return solid(BEST, quick=True)


@pytest.fixture(scope="module")
def run():
    prepared = prepare(scene(BEST, "freshest", shape=SMALL))
    return prepared, run_batch(prepared)


class TestBlocks:
    def test_ports_in_a_row_carry_what_the_hands_put_in(self, found: SolidFindings):
        for one in found.runs.values():
            seen = one.blocks
            taken = seen.device + seen.coupling + seen.contact + seen.object
            assert np.abs(taken - seen.human).max() < 1e-12
            assert seen.human[-1] > 0.1

    def test_the_object_stores_and_burns_what_it_takes(self, run):
        """From the other side of the port: energies and losses of the copies and links."""
        prepared, outcome = run
        seen = blocks(prepared, outcome)
        users = np.arange(5)
        last = outcome.record.users[:, users, outcome.taken]
        losses = sum(last[BOOK[name]].sum() for name in ("body_loss", "local_loss", "extra_loss"))
        energy = last[BOOK["kinetic"]].sum() + last[BOOK["elastic"]].sum()
        receiver = prepared.schedule.slots.receiver
        aged = outcome.record.slots[1][np.arange(receiver.size), outcome.taken[receiver]].sum()
        springs = prepared.scenario.network.spring
        links = sum(
            0.5 * springs[a, b] * np.sum((outcome.position[a] - outcome.position[b]) ** 2)
            for a, b in prepared.scenario.network.links
        )
        assert energy + links + losses - aged == pytest.approx(seen.object[-1], abs=2.0 * 5 * seen.split)
        assert seen.split < 1e-5 * seen.in_play

    def test_time_and_order(self, run):
        prepared, outcome = run
        seen = blocks(prepared, outcome)
        assert seen.time.size == outcome.events
        for line in (seen.human, seen.device, seen.coupling, seen.contact, seen.object):
            assert line.size == outcome.events
        assert np.all(np.diff(seen.time) >= 0.0)

    def test_a_contact_without_an_account_shows(self, run):
        """Five millijoules more to the body than the proxy gave."""
        prepared, outcome = run
        users = np.array(outcome.record.users)
        users[BOOK["touch_work"], 1, 500:] += 5e-3
        broken = replace(outcome, record=outcome.record._replace(users=users))
        assert blocks(prepared, outcome).given <= 1e-12
        assert blocks(prepared, broken).given > 1e-3

    @pytest.mark.parametrize("tool", [0, 3])
    def test_a_coupling_that_gives_energy_away_shows(self, run, tool):
        prepared, outcome = run
        assert outcome.tools is not None
        pulled = np.array(outcome.tools.coupling)
        pulled[0, tool] += 0.5
        broken = blocks(prepared, replace(outcome, tools=outcome.tools._replace(coupling=pulled)))
        kept = blocks(prepared, outcome).couplings[tool]
        assert kept.excess <= kept.bound
        assert broken.couplings[tool].excess > broken.couplings[tool].bound + 1e-3

    def test_a_virtual_coupling_is_paid_for_by_its_device(self, run):
        prepared, outcome = run
        port = blocks(prepared, outcome).couplings[3]
        # The bound is what the encoders' error can do on the proxy's way.
        assert (port.law, port.saturated) == ("host_force", 0)
        assert port.excess <= port.bound < 1e-3
        assert outcome.tools is not None
        # Without that it would have given something: the account of this run is not all negative anyway.
        ledger = np.array(outcome.tools.device_ledger)
        ledger[DEVICE["viscous_loss"]] -= 1.0
        unpaid = blocks(prepared, replace(outcome, tools=outcome.tools._replace(device_ledger=ledger)))
        assert unpaid.couplings[3].excess > 0.5

    def test_hands_that_get_energy_back_show(self, run):
        prepared, outcome = run
        assert outcome.tools is not None
        ledger = np.array(outcome.tools.device_ledger)
        ledger[DEVICE["human"]] *= -1.0
        assert (
            blocks(prepared, replace(outcome, tools=outcome.tools._replace(device_ledger=ledger))).human_margin < -0.1
        )
        assert blocks(prepared, outcome).human_margin == 0.0

    def test_books_that_do_not_close_show(self, run):
        prepared, outcome = run
        assert outcome.tools is not None
        ledger = np.array(outcome.tools.device_ledger)
        ledger[DEVICE["residual"], 2, 7] = -1e-3
        broken = blocks(prepared, replace(outcome, tools=outcome.tools._replace(device_ledger=ledger)))
        assert broken.device_residual > 1e-4


class TestSolid:
    def test_every_claim_holds(self, found: SolidFindings):
        for row in found.claims:
            assert len(row) == 2
            for claim in row:
                assert claim.holds, claim
        assert found.holds
        assert found.residual <= 1e-10

    def test_all_sorts_of_devices_are_there(self, found: SolidFindings):
        tables = scene(BEST, "freshest", shape=SMALL).tools
        devices = [tool.device for tool in tables]
        assert [tool.kind for tool in tables].count("grasp") == 2
        assert {device.kind or "cartesian" for device in devices if device} == {"cartesian", "phantom"}
        assert {device.coupling for device in devices if device} == {"pspm", "host_force"}
        assert {500.0, 2000.0} <= {device.rate for device in devices if device}
        for one in found.runs.values():
            assert [port.user for port in one.blocks.couplings] == list(range(5))

    def test_everyone_holds_at_rest(self, found: SolidFindings):
        for one in found.runs.values():
            assert np.linalg.norm(one.rest.force, axis=1).min() > 0.1

    def test_forces_at_rest_are_those_of_the_average(self, found: SolidFindings):
        """Eq. (6) from the matrices, all of it: also its resultant."""
        body = scene(BEST, "freshest", shape=SMALL).build_body()
        for one in found.runs.values():
            pulled = body.apply(body.stiffness, one.rest.copies.mean(axis=0))
            size = np.linalg.norm(one.rest.force, axis=1).sum()
            assert np.linalg.norm(pulled.sum(axis=0) - one.rest.force.sum(axis=0)) < 0.01 * size
            assert one.rest.balance < 0.02

    def test_a_force_that_is_not_the_averages_shows(self, run, monkeypatch: pytest.MonkeyPatch):
        prepared, outcome = run
        assert outcome.tools is not None
        force = np.array(outcome.tools.force)
        force[4] *= 1.5
        broken = collaboration(prepared, replace(outcome, tools=outcome.tools._replace(force=force)))
        assert broken.rest.balance > 0.05

    def test_copies_that_stay_apart_show(self, run):
        prepared, outcome = run
        position = np.array(outcome.position)
        position[0] += 0.01
        broken = collaboration(prepared, replace(outcome, position=position))
        assert not claims([broken])[-1][0].holds

    def test_far_below_the_rule_the_object_makes_energy(self, found: SolidFindings):
        below: Blocks = found.below
        assert below.port_margin < -0.05
        assert below.object[below.time < 1.0].max() > 0.05
        assert below.energy_residual <= 1e-10
        assert below.given <= 1e-12
        assert below.aged > 0.05
        assert below.object[below.time <= RELEASE][-1] == pytest.approx(below.port_margin, rel=0.1)

    def test_too_little_damping_must_show(self, found: SolidFindings):
        assert not replace(found, below=found.runs["constant"].blocks).holds

    def test_json(self, found: SolidFindings):
        numbers = json.loads(json.dumps(found.numbers(), allow_nan=False))
        assert numbers["nodes"] == np.prod(SMALL)
        assert {claim["mode"] for claim in numbers["claims"]} == {"constant", "freshest"}
        assert numbers["below"]["object_least_work_j"] < 0.0

    def test_the_full_block_has_a_thousand_nodes(self):
        assert np.prod(SHAPE) >= 1000

    def test_warming_up_compiles_what_the_chapter_runs(self):
        """It runs in a process whose errors nobody sees."""
        warm_up()


class TestChapter:
    def test_says_what_was_found(self, found: SolidFindings):
        text = chapter(found, "12 14 23 24 34 45").body
        assert text.count('class="verdict yes"') == len(found.claims)
        assert f"{np.prod(SMALL):,} nodes" in text
        assert "nan" not in text.lower().split()

    def test_a_claim_that_fails_is_marked(self, found: SolidFindings):
        row = tuple(replace(claim, measured=2.0 * abs(claim.limit) + 1.0) for claim in found.claims[1])
        text = chapter(replace(found, claims=(row, *found.claims[1:])), "12").body
        assert text.count('class="verdict no"') == 1

    def test_lines_of_the_energies_are_the_blocks(self, found: SolidFindings):
        with drawing.style():
            drawn = energies(found)
        lines = {line.get_label(): line for line in drawn.axes[0].get_lines()}
        assert lines["shared object"].get_ydata()[-1] == pytest.approx(found.runs["constant"].blocks.object[-1])
        assert lines["work of the hands"].get_ydata()[-1] == pytest.approx(found.runs["constant"].blocks.human[-1])

    def test_pictures_show_every_copy_in_one_scale(self, found: SolidFindings):
        with drawing.style():
            drawn = copies(found)
        assert len(drawn.axes) == 6
        spans = [np.ptp(panel.get_xlim()) for panel in drawn.axes]
        assert spans == pytest.approx([spans[0]] * 6)
        for panel in drawn.axes:
            assert sum(isinstance(patch, mpl.patches.PathPatch) for patch in panel.patches) >= 3
