"""What a tool and the skin do to each other: pressure by the law's energy, friction and damping where it presses.

Friction is a spring between tool and skin, spread over the skin as the pressure is. Its stretch is a state of the
tool; what is beyond the cone slips, and what slips is lost [return mapping, Simo & Hughes 1998]. A film on the skin
drags what slides on it by the area that is covered.
"""
# pyright: reportArgumentType=false, reportReturnType=false

import math
from math import pi
from typing import Any

from cotouch.kernels import FOUR, at, four, inner, load, part, put, splat, store, total
from cotouch.mechanics._contact._beads import beads, reached
from cotouch.mechanics._contact._patch import MEETS, press_triangle
from cotouch.mechanics._contact._skin import forget_hits, meet_four, note_hit, place_bead, place_face
from cotouch.mechanics._contact._snap import draw_tool
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._contact_laws._law import press
from cotouch.mechanics._model._relief import press_relief
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import TOUCHING, Tools

# A stretch of friction that lies this much across the skin, of its length, has no direction along it.
_ACROSS = 1e-3
_NOTHING = 1e-290


@part
def press_tool(
    law: Any, surface: Surface, work: ContactWork, tools: Tools, t: int, time: float, share: float, energies: bool
) -> float:
    """Energy between a tool and the skin after both moved for some time [J].

    Args:
        law: of the contact.
        surface: the skin.
        work: `near`, `rate` and `mean` say what moves; with a share, forces are added to what it gathers.
        tools: the proxies.
        t: which of them.
        time: how long they moved [s].
        share: of the forces there that acts in the step; 0: none, and nothing is written.
        energies: with a share, whether the energy is that of the state, rather than what suffices for forces.
    """
    if surface.soft.shape[0] == 0:
        return _sum(law, surface, work, tools, t, time, share, energies)[0]
    energy, soft = _sum(law, surface, work, tools, t, time, 0.0, True)
    if energy <= 0.0:
        return 0.0
    _, _, slope = press(law, tools.stiffness[t], tools.radius[t], 0.0)
    energy, left = _in_series(energy, soft / energy, pi * slope * tools.radius[t] * tools.share[t])
    if share != 0.0:
        _sum(law, surface, work, tools, t, time, share * left, False)
    return energy


@part
def _in_series(energy: float, soft: float, slope: float) -> tuple[float, float]:
    """What a contact in series with a spring holds, and what that leaves of its force.

    Args:
        energy: that it would hold without the spring [J].
        soft: compliance of the spring [m/N].
        slope: of its force over the square of its depth, as of a shallow ball on a flat [N/m²].

    Returns:
        Energy of both [J]; the share of the force.
    """
    deep = (3.0 * energy / slope) ** (1.0 / 3.0)
    bend = soft * slope
    own = 2.0 * deep / (1.0 + math.sqrt(1.0 + 4.0 * bend * deep))
    return slope * own**3 * (1.0 / 3.0 + 0.5 * bend * own), (own / deep) ** 2


@part
def _sum(
    law: Any, surface: Surface, work: ContactWork, tools: Tools, t: int, time: float, share: float, energies: bool
) -> tuple[float, float]:
    """`press_tool` on a skin that lacks nothing; and the sum of what triangles lack times their energy [Jm/N]."""
    corner, soft = surface.corner, surface.soft
    near, spot, out = work.near, work.spot, work.out
    faces, energy, stiffness, radius = near.shape[1], 0.0, tools.stiffness[t], tools.radius[t]
    lacking, reach, rough = 0.0, radius + surface.relief.top, surface.relief.top > 0.0
    forces = share != 0.0 or soft.shape[0] > 0
    fours, span = reached(corner, work, tools, t, reach, time, time), work.span
    patch, firm, whole, pull, axes = 0.0, 0.0, 0.0, splat(0.0, FOUR), four(share, share, share, 0.0)
    for bead in range(beads(tools, t)):
        place_bead(work, tools, t, bead, time)
        for n in range(fours):
            first = span[n, 0]
            if bead < span[n, 1] or bead > span[n, 2]:
                continue
            met = meet_four(work, corner, t, first, time, radius)
            for c in range(first, min(first + 4, work.number[t]) if met or rough else first):
                meets = met and at(work.met, (MEETS, c % 4)) > 0.0
                f = at(near, (t, c))
                if rough and place_face(work, f, corner, time) >= reach * reach:
                    continue
                if not (meets or rough):
                    continue
                area, covered = tools.share[t] * surface.area[f], 0.0
                for q in range(4 if not meets else 0):
                    store(out, q, splat(0.0, FOUR), FOUR)
                if meets:
                    covered = press_triangle(law, stiffness, radius, area, forces, energies, work.met, c % 4, out)
                if rough:
                    covered += press_relief(law, stiffness, radius, area, forces, surface.relief, f, spot, out)
                if not covered > 0.0:
                    continue
                energy += out[3, 3]
                if (
                    soft.shape[0] > 0
                ):  # what the shapes of a truncated body leave out, by how the corners share the load
                    every = max(out[0, 3] + out[1, 3] + out[2, 3], _NOTHING)
                    square = 0.0
                    for q in range(3):
                        square += (out[q, 3] / every) ** 2
                    lacking += (soft[f, 1] + (soft[f, 0] - soft[f, 1]) * min(square, 1.0)) * out[3, 3]
                if share == 0.0:
                    continue
                patch += share * covered
                note_hit(work, t, c)
                for q in range(3):
                    v = at(corner, (f, q))
                    push = axes * load(out, q, FOUR)
                    store(work.force, v, load(work.force, v, FOUR) + push, FOUR)
                    pull = pull - push
                    put(work.firm, v, at(work.firm, v) + share * time * at(out, (3, q)))
                firm += share * time * (out[3, 0] + out[3, 1] + out[3, 2])
                borne = share * four(out[0, 3], out[1, 3], out[2, 3], 0.0)
                place = t * faces + c
                store(work.load, place, load(work.load, place, FOUR) + borne, FOUR)
                whole += total(borne)
    if share != 0.0:
        store(work.pull, t, load(work.pull, t, FOUR) + pull, FOUR)
        work.patch[t] += patch
        work.grip[t, 0] += firm
        work.total[t] += whole
    return energy, lacking


@inner
def pressing(work: ContactWork, t: int) -> float:
    """Power that the pressure on a tool has on it and the skin, in the middle of the step [W].

    Args:
        work: what is near, and scratch.
        t: which tool.
    """
    power = 0.0
    for a in range(3):
        power += work.way[t, 3] * work.way[t, a] * (work.mean[t, a] - work.skin[t, a])
    return power


@inner
def unsure(work: ContactWork, tools: Tools, T: float) -> float:
    """How far the power of pressure at the end of a step, times T, is from that in its middle, at most about [J].

    By how forces changed since the last step, and by what that power does not say of the energy at the end.

    Args:
        work: what the last look found.
        tools: the proxies.
        T: length of the step [s].
    """
    result = 0.0
    for t in range(tools.mode.shape[0]):
        if tools.mode[t] != TOUCHING or tools.inside[t] != 0:
            continue
        change, rate, skin = 0.0, 0.0, 0.0
        for a in range(3):
            change += (work.pull[t, a] - tools.touch_force[t, a]) ** 2
            rate += work.mean[t, a] ** 2
            skin += work.skin[t, a] ** 2
        result += T * math.sqrt(change) * (math.sqrt(rate) + math.sqrt(skin))
        result += 4.0 * abs(work.pressed[t, 1] - work.pressed[t, 0] + T * pressing(work, t))
    return result


@part
def read_skin(surface: Surface, work: ContactWork, t: int) -> None:
    """Works out how fast the skin moves where a tool presses.

    Args:
        surface: the skin.
        work: `rate` and `load` say what moves; `skin` is written.
        t: which tool.
    """
    corner, near, borne, rate, faces = surface.corner, work.near, work.load, work.rate, work.near.shape[1]
    skin = splat(0.0, FOUR)
    for a in range(3):
        work.skin[t, a] = 0.0
    if work.total[t] <= 0.0:
        return
    for n in range(work.hits[t]):
        c = work.hit[t, n]
        for q in range(3):
            skin = skin + borne[t * faces + c, q] * load(rate, corner[near[t, c], q], FOUR)
    store(work.skin, t, (1.0 / work.total[t]) * skin, FOUR)


@part
def rub(work: ContactWork, tools: Tools, t: int, time: float, T: float) -> tuple[float, float, float]:
    """Friction, the skin's film and damping of a tool that moved for some time, of a step's length T, against the skin.

    `rubbed` gets the stretch at the end and `slips` whether it slips.

    Args:
        work: `way`, `mean` and `skin` say what moves.
        tools: the proxies.
        t: which of them.
        time: for how long, 0 to T [s].
        T: length of the step [s].

    Returns:
        The energy in the spring; what was lost [J]; how much of the spring's stiffness resists more of it.
    """
    way, mean, skin = work.way, work.mean, work.skin
    k, normal, stretch, rubbed = tools.stiffness[t], work.way[t, 3], tools.stretch, work.rubbed
    size, across, approach, slip = 0.0, 0.0, 0.0, 0.0
    for a in range(3):
        size += stretch[t, a] * stretch[t, a]
        across += stretch[t, a] * way[t, a]
        approach -= way[t, a] * (mean[t, a] - skin[t, a])
        rubbed[t, a] = 0.0
    for a in range(3):
        slip += (mean[t, a] - skin[t, a] + approach * way[t, a]) ** 2
    film = tools.viscosity[t] * work.patch[t] * slip * time * time / T if normal > 0.0 else 0.0
    work.slips[t] = 0
    if normal <= 0.0 or tools.friction[t] <= 0.0:
        lost = 0.5 * k * size + film
        share = approach * time / T
        if normal > 0.0:
            lost += normal * max(tools.loss[t] * share, -1.0) * share * T
        return 0.0, lost, 0.0
    length, flat = math.sqrt(size), math.sqrt(max(size - across * across, 0.0))
    turned = length / flat if flat > _ACROSS * length else 0.0
    lost = film if turned != 0.0 else film + 0.5 * k * size
    trial, begun, done = 0.0, 0.0, 0.0
    for a in range(3):
        start = turned * (stretch[t, a] - across * way[t, a])
        rubbed[t, a] = start + time * (mean[t, a] - skin[t, a] + approach * way[t, a])
        trial += rubbed[t, a] * rubbed[t, a]
    trial = math.sqrt(trial)
    cone = (tools.kinetic[t] if tools.slipping[t] != 0 else tools.friction[t]) * normal / k
    share = 1.0
    if trial > cone:
        share = tools.kinetic[t] * normal / (k * trial)
        work.slips[t] = 1
    for a in range(3):
        start = turned * (stretch[t, a] - across * way[t, a])
        end = share * rubbed[t, a]
        done += end * (rubbed[t, a] - end) + 0.5 * (end - start) * (end - start)
        begun += end * end
        rubbed[t, a] = end
    speed = approach * time / T
    lost += k * done + normal * max(tools.loss[t] * speed, -1.0) * speed * T
    return 0.5 * k * begun, lost, share


@part
def feel_tool(law: Any, surface: Surface, work: ContactWork, tools: Tools, t: int, T: float) -> float:
    """Gathers the mean force of a step's contact, on tool and skin, as it would be by the present guess of the motion.

    Energy along a straight way changes by the mean of its slope, which two points of Gauss's rule give to fourth order.
    Where that way is short, the middle alone is as good.

    Args:
        law: of the contact.
        surface: the skin.
        work: `rate` and `mean` say what moves.
        tools: the proxies.
        t: which of them.
        T: length of the step [s].

    Returns:
        Of one whose way is short, the energy of its pressure in the middle, as well as forces need it [J].
    """
    forget_hits(work, t)
    work.total[t], work.patch[t], work.grip[t, 0], work.grip[t, 1] = 0.0, 0.0, 0.0, 0.0
    for a in range(4):
        work.pull[t, a] = 0.0
        work.way[t, a] = 0.0
    half, energy = 0.5 / math.sqrt(3.0), 0.0
    if work.slow[t] != 0:
        energy = press_tool(law, surface, work, tools, t, 0.5 * T, 1.0, False)
    else:
        press_tool(law, surface, work, tools, t, (0.5 - half) * T, 0.5, False)
        press_tool(law, surface, work, tools, t, (0.5 + half) * T, 0.5, False)
    _resist(surface, work, tools, t, T)
    work.well[t] = 0.0
    if tools.snaps[t] == 0:
        return energy
    if work.slow[t] != 0:
        work.well[t], _ = draw_tool(surface, work, tools, t, 0.5 * T, 1.0)
    else:
        early, _ = draw_tool(surface, work, tools, t, (0.5 - half) * T, 0.5)
        late, _ = draw_tool(surface, work, tools, t, (0.5 + half) * T, 0.5)
        work.well[t] = 0.5 * (early + late)
    return energy


@part
def _resist(surface: Surface, work: ContactWork, tools: Tools, t: int, T: float) -> None:
    """Adds friction, film and damping to the pressure that was gathered, and notes along what it acts."""
    faces = work.near.shape[1]
    read_skin(surface, work, t)
    size = 0.0
    for a in range(3):
        size += work.pull[t, a] * work.pull[t, a]
    size = math.sqrt(size)
    if size <= 0.0 or work.total[t] <= 0.0:
        return
    work.way[t, 3] = size
    approach = 0.0
    for a in range(3):
        work.way[t, a] = work.pull[t, a] / size
        approach -= work.way[t, a] * (work.mean[t, a] - work.skin[t, a])
    corner, near = surface.corner, work.near
    for n in range(work.hits[t]):
        f = at(near, (t, at(work.hit, (t, n))))
        for q in range(3):
            v = at(corner, (f, q))
            store(work.ward, v, load(work.force, v, FOUR), FOUR)
    if tools.friction[t] <= 0.0 and tools.loss[t] <= 0.0 and tools.viscosity[t] <= 0.0:
        return
    _, _, share = rub(work, tools, t, T, T)
    k, damper = tools.stiffness[t], size * tools.loss[t]
    damping = size * max(tools.loss[t] * approach, -1.0)
    grip = k * T * share if tools.friction[t] > 0.0 else 0.0
    film = tools.viscosity[t] * work.patch[t]
    for a in range(3):
        slip = work.mean[t, a] - work.skin[t, a] + approach * work.way[t, a]
        work.across[t, a] = damping * work.way[t, a] - k * work.rubbed[t, a] - film * slip
    work.grip[t, 0] += damper
    work.grip[t, 1] += grip + film
    extra = damper + grip + film
    for n in range(work.hits[t]):
        c = at(work.hit, (t, n))
        f, place = at(near, (t, c)), t * faces + c
        for q in range(3):
            part_of, v = at(work.load, (place, q)) / work.total[t], at(corner, (f, q))
            put(work.apart, v, at(work.apart, v) + part_of * extra)
            store(work.force, v, load(work.force, v, FOUR) - part_of * load(work.across, t, FOUR), FOUR)
    for a in range(3):
        work.pull[t, a] += work.across[t, a]
