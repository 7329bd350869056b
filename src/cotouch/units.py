"""Units: SI everywhere inside (m, kg, s, N, J), so a number without a unit in its name is SI.

Frame: x forward, y left, z up, right-handed (REP-103). Users are numbered from 1 on screen and in files, from 0 in
arrays; the two helpers here are the only places where one becomes the other.
"""


def user_number(index: int) -> int:
    """Number of a user on screen and in files, from its index in arrays."""
    return index + 1


def user_index(number: int) -> int:
    """Index of a user in arrays, from its number on screen and in files."""
    return number - 1
