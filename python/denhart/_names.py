"""Classes that the compiled part raises and returns."""

import enum


class ArmError(ValueError):
    """A mistake in an arm file, with its place, or a request that an arm has no answer to.

    The text is that of the command line: place, excerpt with a caret, help.
    """

    __module__ = "denhart"


class Status(enum.IntEnum):
    """Outcome of an inverse."""

    __module__ = "denhart"

    __str__ = enum.Enum.__str__

    #: At least one solution is exact.
    REACHABLE = 0
    #: No solution is exact; those within the arm's tolerance are listed.
    UNREACHABLE = 1
    #: A number is not finite, or the matrix is no rotation.
    BAD_TARGET = 2


class Flags(enum.IntFlag):
    """Facts about a solution."""

    __module__ = "denhart"

    __str__ = enum.Flag.__str__

    #: Reaches the target up to rounding.
    EXACT = 1
    #: Two branches meet here: the target is on the edge of what the branch reaches.
    BOUNDARY = 2
    #: A singular pose: the joints of `free` could take other values.
    FREE = 4
    #: Misses the target by `residual`, which is within the arm's tolerance.
    APPROXIMATE = 8
    #: A joint value is outside the arm's limits.
    OUT_OF_LIMITS = 16
