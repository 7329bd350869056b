"""Where vertical lines cross a closed surface, and how often it winds around what lies between."""

from typing import Final

import numpy as np

from cotouch.arrays import Float, Long

# The lines stand a little off every symmetric place, where surfaces like to have edges.
_OFF: Final = (1.6180e-4, 1.4142e-4)
_BATCH: Final = 2_000_000
# Less than this share of a volume is no overlap: rounding where shells share a face.
_SLIGHT: Final = 1e-6
# Lines along each side of a surface by which what it holds twice is measured.
_FINE: Final = 400


def crossings(points: Float, triangles: Long, wide: int, deep: int) -> tuple[Long, Float, Long, Long]:
    """All crossings of vertical lines with a surface, line by line and upwards.

    Args:
        points: (V, 3); line (i, j) stands at about (i + 1/2, j + 1/2).
        triangles: (F, 3), turned outwards.
        wide: lines along x.
        deep: lines along y.

    Returns:
        For each crossing: its line, `i deep + j`; its height; the winding number below it; the change of it, 1 or -1.
    """
    u = points[:, 0] - 0.5 - _OFF[0]
    v = points[:, 1] - 0.5 - _OFF[1]
    z = points[:, 2]
    corners_u, corners_v = u[triangles], v[triangles]
    first_u = np.clip(np.ceil(corners_u.min(axis=1)), 0, wide).astype(np.int64)
    last_u = np.clip(np.floor(corners_u.max(axis=1)), -1, wide - 1).astype(np.int64)
    first_v = np.clip(np.ceil(corners_v.min(axis=1)), 0, deep).astype(np.int64)
    last_v = np.clip(np.floor(corners_v.max(axis=1)), -1, deep - 1).astype(np.int64)
    across = np.maximum(last_u - first_u + 1, 0)
    count = across * np.maximum(last_v - first_v + 1, 0)
    useful = np.flatnonzero(count)
    ends = np.cumsum(count[useful])
    lines, heights, enters = [np.zeros(0, np.int64)], [np.zeros(0)], [np.zeros(0, np.int64)]
    start = 0
    while start < useful.size:
        done = int(ends[start - 1]) if start else 0
        stop = max(int(np.searchsorted(ends, done + _BATCH, side="right")), start + 1)
        batch = useful[start:stop]
        which = np.repeat(batch, count[batch])
        number = np.arange(which.size) - np.repeat(np.cumsum(count[batch]) - count[batch], count[batch])
        i = first_u[which] + number % across[which]
        j = first_v[which] + number // across[which]
        a, b, c = (triangles[which, k] for k in range(3))
        wa = (u[b] - i) * (v[c] - j) - (u[c] - i) * (v[b] - j)
        wb = (u[c] - i) * (v[a] - j) - (u[a] - i) * (v[c] - j)
        wc = (u[a] - i) * (v[b] - j) - (u[b] - i) * (v[a] - j)
        total = wa + wb + wc
        hit = (((wa >= 0) & (wb >= 0) & (wc >= 0)) | ((wa <= 0) & (wb <= 0) & (wc <= 0))) & (total != 0.0)
        a, b, c = a[hit], b[hit], c[hit]
        heights.append((wa[hit] * z[a] + wb[hit] * z[b] + wc[hit] * z[c]) / total[hit])
        enters.append(np.where(total[hit] > 0.0, -1, 1))  # a face that looks up is where a line leaves
        lines.append(i[hit] * deep + j[hit])
        start = stop
    line, height, turn = np.concatenate(lines), np.concatenate(heights), np.concatenate(enters)
    order = np.lexsort((height, line))
    line, height, turn = line[order], height[order], turn[order]
    before = np.cumsum(turn) - turn
    starts = np.flatnonzero(np.diff(line, prepend=-1))
    winding = before - np.repeat(before[starts], np.diff(starts, append=line.size))
    return line, height, winding, turn


def turns(line: Long, turn: Long, lines: int) -> Long:
    """The winding number above everything on each line, (lines,); other than 0 where a line grazed an edge.

    Args:
        line: of each crossing.
        turn: the change at it.
        lines: how many there are.
    """
    return np.rint(np.bincount(line, weights=turn, minlength=lines)).astype(np.int64)


def doubled(vertices: Float, triangles: Long) -> float:
    """What the divergence theorem counts more than once, less holes in what is not there [m³].

    The volume where the winding number is above 0 is the signed volume less this; 0 where nothing overlaps.

    Args:
        vertices: (V, 3) [m].
        triangles: (F, 3), turned outwards.
    """
    low, extent = vertices.min(axis=0), np.ptp(vertices, axis=0)
    scale = np.array([_FINE / extent[0], _FINE / extent[1], 1.0])
    line, height, winding, turn = crossings((vertices - low) * scale, triangles, _FINE, _FINE)
    sound = turns(line, turn, _FINE * _FINE) == 0
    above = winding + turn
    extra = above - (above > 0)
    long = np.diff(height, append=0.0)  # a line's last crossing has nothing extra above it
    some, all_ = (float((factor * long)[sound[line]].sum()) for factor in (extra, above > 0))
    if abs(some) <= _SLIGHT * all_:
        return 0.0
    return some / int(sound.sum()) * float(extent[0] * extent[1])
