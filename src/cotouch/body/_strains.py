"""How four equal masses are strained, and what follows them."""

from typing import Final

import numpy as np

from cotouch.arrays import Float

# Alternate corners s_k of a cube: Σ s_k = 0 and Σ s_k s_kᵀ = 4 I.
SIGNS: Final = np.array([[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]])
# Strains in the order of `strain_law`.
_PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))


def frame_of(places: Float) -> Float:
    """`G = ¼ Σ x_k s_kᵀ`, (3, 3): the map from the cube to where the masses are.

    Args:
        places: x_k, (4, 3) [m].
    """
    return 0.25 * places.T @ SIGNS


def strain_law(frame: Float) -> Float:
    """C of the energy `½ m ω² Σ C_pq e_p e_q` by which all strains swing alike, (6, 6) [1/m²].

    The e are xx, yy, zz, xy, xz, yz of `½ (GᵀG - G₀ᵀG₀)`, each of the mixed ones once. Along the principal axes, of
    radii a_i, strain ij counts `2 / (a_i² + a_j²)`, in proportion to the mass that it moves.

    Args:
        frame: G₀ [m].
    """
    _, radii, axes = np.linalg.svd(frame)
    squares = radii * radii
    weight = 2.0 / (squares[:, None] + squares[None, :])
    pairs = np.einsum("ip,jq->ijpq", axes, axes)
    law = np.einsum("ij,ijpq,ijrs->pqrs", weight, pairs, pairs)
    result = np.zeros((6, 6))
    for p, (a, b) in enumerate(_PAIRS):
        for q, (c, d) in enumerate(_PAIRS):
            # A mixed strain is there twice.
            result[p, q] = 0.25 * (law[a, b, c, d] + law[b, a, c, d] + law[a, b, d, c] + law[b, a, d, c])
            result[p, q] *= (1.0 if a == b else 2.0) * (1.0 if c == d else 2.0)
    return 0.5 * (result + result.T)


def strains_of(frame: Float) -> Float:
    """Derivative of the strains by the four places where nothing is strained, (6, 12) [m].

    Args:
        frame: G₀ [m].
    """
    result = np.zeros((6, 12))
    for k in range(4):
        for axis in range(3):
            half = 0.25 * np.outer(frame[axis], SIGNS[k])
            result[:, 3 * k + axis] = [0.5 * (half[a, b] + half[b, a]) for a, b in _PAIRS]
    return result


def shares_of(rest: Float, places: Float) -> Float:
    """How much of each of four nodes a place follows that moves with all of them, (P, 4); rows sum to one.

    Args:
        rest: of the nodes, (4, 3) [m].
        places: (P, 3) [m].
    """
    edges: Float = rest[1:] - rest[0]
    inverse = np.asarray(np.linalg.inv(edges), dtype=np.float64)
    shares: Float = (places - rest.mean(axis=0)) @ inverse + 0.25
    return np.concatenate([1.0 - shares.sum(axis=1, keepdims=True), shares], axis=1)


def turn_vectors(turn: Float) -> Float:
    """Rotation vectors of the rotations that are nearest to matrices; NaN of what was not reached [Horn 1987].

    Args:
        turn: (records, 3, 3).
    """
    result = np.full((turn.shape[0], 3), np.nan)
    sound = np.isfinite(turn).all(axis=(1, 2))
    a = turn[sound]
    both = a + np.swapaxes(a, 1, 2)
    form = np.empty((a.shape[0], 4, 4))
    form[:, 0, 0] = trace = np.trace(a, axis1=1, axis2=2)
    form[:, 0, 1:] = form[:, 1:, 0] = axial(a)
    form[:, 1:, 1:] = both - trace[:, None, None] * np.eye(3)
    quaternion = np.linalg.eigh(form)[1][:, :, -1]
    quaternion *= np.where(quaternion[:, :1] < 0.0, -1.0, 1.0)
    sine = np.linalg.norm(quaternion[:, 1:], axis=1)
    angle = 2.0 * np.arctan2(sine, quaternion[:, 0])
    scale = np.divide(angle, sine, out=np.full_like(sine, 2.0), where=sine > 0.0)
    result[sound] = scale[:, None] * quaternion[:, 1:]
    return result


def axial(matrix: Float) -> Float:
    """Twice the axial vector of matrices' skew parts, (records, 3).

    Args:
        matrix: (records, 3, 3).
    """
    return np.stack([matrix[:, c, b] - matrix[:, b, c] for b, c in ((1, 2), (2, 0), (0, 1))], axis=1)
