"""Networks straight from tables of round trips."""

import numpy as np
import pytest

from cotouch.errors import NetworkError
from cotouch.network import Network

TABLE = ",Ann,Ben,Cleo\nAnn,0,100,\nBen,120,0,60\nCleo,,,0\n"


def write(tmp_path, text, name="trips.csv"):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return path


def test_half_of_the_round_trip_is_the_delay(tmp_path):
    path = write(tmp_path, TABLE)
    network = Network.from_delays(path, spring=30.0)
    assert network.users == ("Ann", "Ben", "Cleo")
    np.testing.assert_allclose(network.delay, [[0, 0.06, 0], [0.06, 0, 0.03], [0, 0.03, 0]])
    np.testing.assert_array_equal(network.spring, [[0, 30, 0], [30, 0, 30], [0, 30, 0]])
    # The longer of the two that were measured between Ann and Ben; here the shorter.
    assert Network.from_delays(path, quantile=0.0).delay[0, 1] == pytest.approx(0.05)


def test_what_spreadsheets_write_is_read(tmp_path):
    text = "\ufeff" + TABLE.replace(",", ", ").replace("Ann", '"Ann"').replace("\n", "\r\n")
    found, plain = (Network.from_delays(write(tmp_path, *one)) for one in ((text,), (TABLE, "plain.csv")))
    assert found.users == plain.users == ("Ann", "Ben", "Cleo")
    np.testing.assert_array_equal(found.delay, plain.delay)
    np.testing.assert_array_equal(found.spring, plain.spring)


def test_picked_in_the_order_said_and_by_a_quantile(tmp_path):
    paths = [write(tmp_path, TABLE), write(tmp_path, TABLE.replace("100", "200"), "later.csv")]
    network = Network.from_delays(paths, pick=["Ben", "Ann"], quantile=0.5)
    assert network.users == ("Ben", "Ann")
    assert network.delay[0, 1] == pytest.approx(0.5 * np.median([0.1, 0.12, 0.2, 0.12]))
    assert Network.from_delays(paths).delay[0, 1] == pytest.approx(0.1)


def test_what_is_not_between_picked_users_may_be_anything(tmp_path):
    """As a big measured table has it, of which a few users are picked; nobody asks for the way to oneself either."""
    path = write(tmp_path, TABLE.replace("Cleo,,,0", "Cleo,nan,-1,x").replace("Ann,0", "Ann,nan").replace("60", "inf"))
    assert Network.from_delays(path, pick=["Ann", "Ben"]).delay[0, 1] == pytest.approx(0.06)
    with pytest.raises(NetworkError, match='from "Ben" to "Cleo" is "inf"'):
        Network.from_delays(path, pick=["Ben", "Cleo"])


@pytest.mark.parametrize(
    ("text", "options", "message"),
    [
        ("", {}, "has no round trips"),
        (",a,b\na,0,1\nc,1,0\n", {}, "must hold the same names"),
        (",a,a\na,0,1\na,1,0\n", {}, 'the name "a" is empty or occurs twice'),
        (",a,b\na,0\nb,1,0\n", {}, 'the row of "a" has 1 fields'),
        (",a,b\na,0,x\nb,1,0\n", {}, 'from "a" to "b" is "x"'),
        (",a,b\na,0,-1\nb,1,0\n", {}, 'from "a" to "b" is "-1"'),
        (",a,b\na,0,1e999\nb,1,0\n", {}, 'from "a" to "b" is "1e999"'),
        (TABLE, {"pick": ["Dora"]}, 'pick holds "Dora"'),
        (TABLE, {"pick": ["Ann", "Ann"]}, 'pick holds "Ann" twice'),
        (TABLE, {"quantile": 2.0}, "quantile is 2"),
        (TABLE, {"spring": -1.0}, "spring is -1 N/m"),
    ],
)
def test_what_is_wrong_is_one_sentence(tmp_path, text, options, message):
    with pytest.raises(NetworkError, match=message) as caught:
        Network.from_delays([write(tmp_path, text)], **options)
    assert "\n" not in str(caught.value)


def test_tables_must_name_the_same(tmp_path):
    other = write(tmp_path, TABLE.replace("Cleo", "Carl"), "other.csv")
    with pytest.raises(NetworkError, match="names other users than"):
        Network.from_delays([write(tmp_path, TABLE), other])
