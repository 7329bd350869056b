"""Metrics of haptic codecs, on signals whose answers are known."""

import numpy as np
import pytest

from cotouch.arrays import Float
from cotouch.laboratory import Study, etvo, hpw_psnr, ideal, measures_of, psnr
from cotouch.simulation import prepare

TIME = np.arange(0.0, 4.0, 1e-3)[:, None]


def test_psnr_is_of_the_peak_to_the_error() -> None:
    wanted = 2.0 * np.sin(2.0 * np.pi * TIME)
    assert psnr(wanted, wanted + 0.02) == pytest.approx(40.0, abs=1e-3)
    assert psnr(wanted, wanted) == float("inf")
    assert psnr(0.0 * wanted, wanted) == float("-inf")


def test_errors_that_nobody_notices_do_not_count() -> None:
    wanted = np.ones((1000, 2))
    assert hpw_psnr(wanted, 1.06 * wanted) == float("inf")
    assert hpw_psnr(wanted, 1.08 * wanted) == psnr(wanted, 1.08 * wanted) == pytest.approx(-20.0 * np.log10(0.08))
    half = np.where(np.arange(1000)[:, None] < 500, 1.06, 1.1) * wanted
    assert hpw_psnr(wanted, half) == pytest.approx(20.0 - 10.0 * np.log10(0.5))


@pytest.mark.parametrize("delay", [-0.02, 0.0, 0.025, 0.1, 0.2])
def test_a_late_signal_is_late_and_not_off(delay: float) -> None:
    def motion(time: Float) -> Float:
        passed = np.clip(time - 0.3, 0.0, 3.0)
        return np.hstack([0.1 * np.sin(np.pi * passed) ** 2, 0.05 * np.sin(2.0 * np.pi * passed / 3.0)])

    wanted, found = motion(TIME), motion(TIME - delay)
    late, off = etvo(wanted, found, 1e-3)
    assert late == pytest.approx(delay, abs=0.01)
    assert off < 0.002


def test_a_value_that_is_off_is_not_late() -> None:
    wanted = np.hstack([0.1 * np.sin(np.pi * TIME), 0.0 * TIME])
    assert etvo(wanted, wanted + np.array([0.0, 0.003]), 1e-3) == (0.0, pytest.approx(0.003))


def test_at_rest_nothing_is_late() -> None:
    assert etvo(np.zeros((500, 1)), np.full((500, 1), 0.003), 1e-3) == (0.0, pytest.approx(0.003))


def test_a_comparison_says_what_a_codec_saves_and_costs() -> None:
    found: list[dict[str, float]] = []
    for channel in ({}, {"codec": {"deadband": 0.1, "quantum": 1e-5}}):
        study = Study.make(
            laws=["wave"], networks=[{"name": "n", "delay": 0.02, "channel": channel}], duration=4.0, period=0.004
        )
        hands = study.task("carry", 2, study.hands[0], 0)
        prepared = prepare(study.scenario(study.laws[0], study.networks[0], 2, hands))
        found.append(measures_of(study.laws[0], prepared, ideal(study, hands)))
    full, less = found
    assert full["packets"] == 250.0
    assert full["bandwidth"] == 250.0 * 8 * 3  # x̂, U and E
    assert less["packets"] < 0.85 * full["packets"]
    assert less["bandwidth"] < 0.8 * full["bandwidth"]
    assert less["cost"] == pytest.approx(full["cost"], rel=0.2)
    assert less["psnr"] == pytest.approx(full["psnr"], abs=2.0)
    assert full["hpw_psnr"] >= full["psnr"]
    assert 0.0 < full["late"] < 0.1
    assert less["made"] == full["made"] == 0.0
