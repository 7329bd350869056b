"""Compiled parts of a schedule: which sample is used when, and when self-paced users step."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.kernels import at, kernel, put

# Far below any step, and far above the round-off of summed steps and of delays as long as some steps: what comes at the
# instant of a step always counts, not now and then.
AT_ONCE = 1e-9


@kernel
def newest(sent: Float, arrival: Float, end: Float, used: Int) -> None:
    """For each step, the newest message that has arrived when it is taken.

    A message counts at a step if it arrived by the step's end and was sent before it: of two users who step at the same
    instant neither sees what the other sends at that instant, so their order does not matter.

    Args:
        sent: (messages,), increasing [s].
        arrival: (messages,), infinite where lost [s].
        end: when the receiver takes its steps, (steps,), increasing [s].
        used: result (steps,): index of the message, or -1.
    """
    steps = end.shape[0]
    used[:] = -1
    guess = 0
    for m in range(sent.shape[0]):
        if arrival[m] < np.inf:
            while guess > 0 and (arrival[m] <= end[guess - 1] + AT_ONCE and end[guess - 1] > sent[m]):
                guess -= 1
            while guess < steps and not (arrival[m] <= end[guess] + AT_ONCE and end[guess] > sent[m]):
                guess += 1
            if guess < steps:
                used[guess] = max(used[guess], m)
            guess = min(guess, steps - 1)
    for k in range(1, steps):
        used[k] = max(used[k], used[k - 1])


@kernel
def indexed(latency: Float, sent: Float, end: Float, delay: int, used: Int) -> int:
    """For each step k, sample k - delay, or the newest one before it that has arrived; returns how often it had not.

    Args:
        latency: of every sample, from the step that sends it, (samples,) [s].
        sent: when the sender takes its steps, (steps,) [s].
        end: when the receiver takes its own, (steps,) [s].
        delay: indexing delay N_ij, >= 1.
        used: result (steps,): index of the sample, or -1 for the initial one.
    """
    short = 0
    oldest = -1
    for k in range(end.shape[0]):
        wanted = k - delay
        index = max(wanted, -1)
        while index > oldest and at(sent, index) + at(latency, index) > at(end, k) + AT_ONCE:
            index -= 1
        if index < wanted:
            short += 1
        put(used, k, index)
        oldest = index
    return short


@kernel
def self_paced(period: Float, first: Int, peer: Int, delay: Int, latency: Float, end: Float) -> None:
    """When users step who take step k once the samples k - N_ij are there, and not before their own period is over.

    Args:
        period: nominal step of each user and step, (users, steps) [s].
        first: first slot of each user, (users + 1,).
        peer: sender of each slot, (slots,).
        delay: N_ij of each slot, (slots,), >= 1.
        latency: of every sample, (slots, steps) [s].
        end: result: when each step is taken, (users, steps) [s].
    """
    users, steps = end.shape
    for k in range(steps):
        for i in range(users):
            ready = period[i, k] + (end[i, k - 1] if k > 0 else 0.0)
            for s in range(first[i], first[i + 1]):
                index = k - delay[s]
                if index >= 0:
                    ready = max(ready, end[peer[s], index] + latency[s, index])
            end[i, k] = ready


@kernel
def elapsed(end: Float, longest: Float, length: Float) -> None:
    """T of self-paced steps: the real time that integration has not covered yet, at most `longest` at once.

    What is cut off is made up by later steps, so integrated time does not drift from real time.

    Args:
        end: when each step is taken, (users, steps) [s].
        longest: bound on T, (users,) [s].
        length: result: T of each step, (users, steps) [s].
    """
    users, steps = end.shape
    for i in range(users):
        integrated = 0.0
        for k in range(steps):
            T = min(end[i, k] - integrated, longest[i])
            integrated += T
            length[i, k] = T


@kernel
def ages(end: Float, sent: Float, sent_length: Float, used: Int, age: Float) -> None:
    """Age of the sample that each step uses, at the end of the step.

    A sample is x̂, the sender's place at the middle of its step, so that is where its age starts.

    Args:
        end: of the receiver's steps, (steps,) [s].
        sent: end of the sender's steps, (samples,) [s].
        sent_length: length of the sender's steps, (samples,) [s].
        used: index of the sample at each step, (steps,); -1: the initial state, known at time 0.
        age: result (steps,) [s].
    """
    for k in range(end.shape[0]):
        stamp = 0.0
        index = at(used, k)
        if index >= 0:
            stamp = at(sent, index) - 0.5 * at(sent_length, index)
        age[k] = end[k] - stamp


@kernel
def ring_size(order: Int, first: Int, peer: Int, used: Int, counter: Int) -> int:
    """How many samples of a user must be kept so that none is overwritten before its last use; `counter` is zeros.

    Args:
        order: events in the order of time.
        first: first event of each user.
        peer: neighbour of each slot.
        used: sample that each step uses.
        counter: zeros; room to work in.
    """
    size = 1
    for event in range(order.shape[0]):
        i = at(order, event)
        k = at(counter, i)
        for s in range(at(first, i), at(first, i + 1)):
            index = at(used, (s, k))
            if index >= 0:
                size = max(size, at(counter, at(peer, s)) - index)
        put(counter, i, k + 1)
    return size
