import warnings
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

from cotouch.drawing import drawn as rendered
from cotouch.errors import OutputError, ScenarioError
from cotouch.scenario import Scenario
from cotouch.simulation import at_times, figures, save_figures, simulate

NAMES = ("positions", "forces", "energies", "ages")


def network(users: int, **more: Any) -> dict[str, Any]:
    others = 1.0 - np.eye(users)
    names = [f"user {i}" for i in range(users)]
    return {"users": names, "spring": (40 * others).tolist(), "delay": (0.03 * others).tolist(), **more}


def scenario(users: int = 2, **tables: Any) -> dict[str, Any]:
    hands = [{"user": i + 1, "path": 0.01 * (i - 1), "begin": 0.2, "release": 1.0 + 0.1 * i} for i in range(users)]
    return {"network": network(users), "steps": {"duration": 2.0, "period": 0.002}, "hands": hands, **tables}


@pytest.fixture(scope="module")
def pair() -> xr.Dataset:
    return simulate(scenario())


@pytest.fixture(scope="module")
def of_pair(pair: xr.Dataset) -> dict[str, Figure]:
    return figures(pair)


@pytest.fixture(scope="module")
def own_rates() -> xr.Dataset:
    """Rows of slower users end in NaN."""
    return simulate(scenario(3, steps={"duration": 2.0, "rate": [500, 100, 240]}, channel={"jitter": {"scale": 0.02}}))


def drawn(axes: Axes) -> list[np.ndarray]:
    """Points of the lines, without those that only mark a place."""
    lines = [np.asarray(line.get_xydata(), dtype=np.float64) for line in axes.get_lines()]
    return [line for line in lines if line.shape[0] > 2]


def test_every_axis_has_a_label_with_a_unit(of_pair: dict[str, Figure]) -> None:
    for name, figure in of_pair.items():
        assert isinstance(figure, Figure)
        assert figure.axes[-1].get_xlabel() == "Time / s", name
        for axes in figure.axes:
            quantity, _, unit = axes.get_ylabel().partition(" / ")
            assert quantity, name
            assert unit in {"m", "mm", "µm", "N", "mN", "J", "mJ", "µJ", "s", "ms"}, name


def test_one_line_for_each_user_and_quantity(of_pair: dict[str, Figure]) -> None:
    made = of_pair
    assert tuple(made) == NAMES
    assert [len(drawn(axes)) for axes in made["positions"].axes] == [2]
    assert [len(drawn(axes)) for axes in made["forces"].axes] == [2, 1]
    assert [len(drawn(axes)) for axes in made["energies"].axes] == [3, 4, 1]
    assert [len(drawn(axes)) for axes in made["ages"].axes] == [2]


def test_lines_are_the_run_in_the_unit_of_the_axis(pair: xr.Dataset, of_pair: dict[str, Figure]) -> None:
    axes = of_pair["positions"].axes[0]
    assert axes.get_ylabel() == "Position / mm"
    for user, line in enumerate(drawn(axes)):
        places = np.interp(line[:, 0], pair["time"].values[user], 1e3 * pair["position"].values[user, :, 0, 0])
        np.testing.assert_allclose(line[:, 1], places, atol=1e-12)


def test_sum_of_forces_is_the_sum(pair: xr.Dataset, of_pair: dict[str, Figure]) -> None:
    (line,) = drawn(of_pair["forces"].axes[1])
    total = pair["force"].values[:, 1:, 0].sum(axis=0)
    assert line[:, 1].max() == pytest.approx(total.max(), rel=1e-12)
    assert line[:, 1].min() == pytest.approx(total.min(), abs=1e-12)


def test_stored_energies_add_up(pair: xr.Dataset, of_pair: dict[str, Figure]) -> None:
    axes = of_pair["energies"].axes[0]
    parts = {line.get_label(): np.asarray(line.get_xydata()) for line in axes.get_lines()}
    assert set(parts) >= {"kinetic", "elastic", "link springs"}
    time = pair["tick_time"].values
    unit = 1e3 if axes.get_ylabel().endswith("mJ") else 1e6 if axes.get_ylabel().endswith("µJ") else 1.0
    total = sum(np.interp(time, *parts[name].T) for name in ("kinetic", "elastic", "link springs"))
    np.testing.assert_allclose(total, unit * pair["stored"].values, rtol=1e-9, atol=1e-12 * unit)


def test_hold_is_shaded_from_the_last_grip_to_the_first_release(of_pair: dict[str, Figure]) -> None:
    for figure in of_pair.values():
        for axes in figure.axes:
            (patch,) = axes.patches
            box = patch.get_path().get_extents(patch.get_patch_transform())
            assert (box.x0, box.x1) == pytest.approx((0.2, 1.0))


def test_padding_of_slower_users_is_not_drawn(own_rates: xr.Dataset) -> None:
    assert np.isnan(own_rates["time"].values).any()
    made = figures(own_rates)
    for figure in made.values():
        for axes in figure.axes:
            for line in drawn(axes):
                assert np.isfinite(line).all()
                assert (np.diff(line[:, 0]) >= 0.0).all()
    for user, line in enumerate(drawn(made["positions"].axes[0])):
        assert line[-1, 0] == pytest.approx(np.nanmax(own_rates["time"].values[user]))


def test_many_users_stay_apart() -> None:
    run = simulate(scenario(12, steps={"duration": 1.5, "period": 0.005}))
    made = figures(run)
    lines = made["positions"].axes[0].get_lines()
    assert len({(line.get_color(), str(line.get_linestyle()), line._unscaled_dash_pattern) for line in lines}) == 12
    legend = made["positions"].axes[0].get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()][1:] == run["user"].values.tolist()
    # 132 directions are too many lines; every receiver has its oldest sample.
    assert len(drawn(made["ages"].axes[0])) == 12
    for figure in made.values():
        FigureCanvasAgg(figure).draw()


def test_title_and_legend_do_not_overlap() -> None:
    for users in (2, 12):
        figure = figures(simulate(scenario(users, steps={"duration": 1.2, "period": 0.01})))["positions"]
        renderer = FigureCanvasAgg(figure).get_renderer()
        figure.draw(renderer)
        axes = figure.axes[0]
        legend = axes.get_legend()
        assert legend is not None
        (title,) = (text for text in axes.findobj(Text) if text.get_text() == axes.get_title(loc="left"))
        assert not title.get_window_extent(renderer).overlaps(legend.get_window_extent(renderer)), users


def test_several_nodes_and_axes_show_the_node_held_most() -> None:
    hands = [
        {"user": 1, "node": 3, "path": [0.02, 0.01, 0.0]},
        {"user": 2, "node": 3, "path": [0.0, 0.01, 0.03]},
        {"user": 2, "node": 1, "path": [0.0, 0.0, 0.0]},
    ]
    run = simulate(scenario(body={"kind": "chain", "nodes": 4, "dimension": 3}, hands=hands))
    made = figures(run)
    panels = made["positions"].axes
    assert [axes.get_ylabel() for axes in panels] == ["Position x / mm", "Position y / mm", "Position z / mm"]
    assert "node 3" in panels[0].get_title(loc="left")
    time = run["time"].values[0]
    for axis, axes in enumerate(panels):
        line = drawn(axes)[1]
        places = np.interp(line[:, 0], time, 1e3 * run["position"].sel(node=3).values[1, :, axis])
        np.testing.assert_allclose(line[:, 1], places, atol=1e-9)
    assert len(made["forces"].axes) == 4
    assert len(drawn(made["forces"].axes[-1])) == 3


def test_a_run_that_nobody_holds() -> None:
    run = simulate(scenario(hands=[], initial={"position": [0.1, -0.1]}))
    for figure in figures(run).values():
        assert not figure.axes[0].patches
        FigureCanvasAgg(figure).draw()


def test_users_without_links() -> None:
    run = simulate(scenario(network=network(2, links=[])))
    axes = figures(run)["ages"].axes[0]
    assert not drawn(axes)
    assert "No links" in axes.get_title(loc="left")


def test_a_run_at_rest() -> None:
    for figure in figures(simulate(scenario(hands=[]))).values():
        FigureCanvasAgg(figure).draw()


@pytest.mark.parametrize("duration", [20.0, 60.0])
def test_a_run_that_diverges(duration: float) -> None:
    """Also beyond floating point, where the rest of the run is missing."""
    synchronisation = {"mode": "constant", "damping": 0.0}
    run = simulate(scenario(steps={"duration": duration, "period": 0.005}, synchronisation=synchronisation))
    made = figures(run)
    positions = made["positions"].axes[0]
    assert positions.get_yscale() == "symlog"
    assert made["energies"].axes[0].get_yscale() == "symlog"
    assert made["ages"].axes[0].get_yscale() == "linear"
    for figure in made.values():
        FigureCanvasAgg(figure).draw()
        for axes in figure.axes:
            assert len(axes.get_yticks()) < 20


def test_a_run_that_settles_keeps_straight_axes(of_pair: dict[str, Figure]) -> None:
    for figure in of_pair.values():
        for axes in figure.axes:
            assert axes.get_yscale() == ("log" if axes.get_ylabel().startswith("|Residual|") else "linear")


def test_five_users_of_the_paper() -> None:
    path = Path(__file__).parents[2] / "examples" / "five-users.toml"
    run = simulate(Scenario.read(path).replace(steps={"duration": 14.0, "period": 0.01}))
    ages = figures(run)["ages"].axes[0]
    labels = {text.get_text() for text in ages.texts}
    assert {name.replace("<-", " ← ") for name in run["direction"].values} <= labels


def test_long_series_are_thinned(pair: xr.Dataset) -> None:
    run = simulate(scenario(steps={"duration": 12.0, "period": 0.001}))
    for line in drawn(figures(run)["positions"].axes[0]):
        assert line.shape[0] < 2500
    assert run.sizes["step"] > 10_000


def test_settings_of_the_caller_come_back(pair: xr.Dataset) -> None:
    before = dict(mpl.rcParams)
    figures(pair)
    assert dict(mpl.rcParams) == before


def test_saved_as_files(pair: xr.Dataset, tmp_path: Path) -> None:
    paths = save_figures(pair, tmp_path / "new" / "folder")
    assert [path.name for path in paths] == [f"{name}.png" for name in NAMES]
    assert all(path.read_bytes().startswith(b"\x89PNG") for path in paths)
    assert all(path.suffix == ".svg" for path in save_figures(pair, tmp_path, format="svg"))


def test_folder_that_cannot_be_made(pair: xr.Dataset, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(OutputError, match="cannot be created"):
        save_figures(pair, tmp_path / "file" / "folder")


def test_format_that_does_not_exist(pair: xr.Dataset, tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match='"nonsense"'):
        save_figures(pair, tmp_path, format="nonsense")


def test_interpolation_of_rates_matches_at_times(own_rates: xr.Dataset) -> None:
    ticks = own_rates["tick_time"].values
    total = at_times(own_rates, "force", ticks).sum(axis=1)[1:, 0]
    (line,) = drawn(figures(own_rates)["forces"].axes[1])
    scale = 1e3 if figures(own_rates)["forces"].axes[1].get_ylabel().endswith("mN") else 1.0
    np.testing.assert_allclose(line[:, 1], scale * np.interp(line[:, 0], ticks[1:], total), atol=1e-12 * scale)


def test_a_name_in_letters_that_the_font_lacks_is_no_warning() -> None:
    figure = Figure()
    figure.suptitle("🐙")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert rendered(figure, dpi=20.0)
