"""Tables of ground, tread and axle in motion files (the extra `viscoroll[cli]`)."""

from __future__ import annotations

from functools import reduce
from operator import or_
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, TypeAlias

import numpy as np

from .._support.extras import extra
from ..ground import Axle, Profile
from .tables import FileName, Table

with extra("cli"):
    from pydantic import Field

__all__ = ["AxleTable", "ProfileTable"]


def _points(*, distance: list[float], height: list[float], periodic: bool = False) -> Profile:
    """Return a profile of points.

    Parameters
    ----------
    distance : array_like
        Distances [m], not decreasing, at least two. Two equal distances are a step.
    height : array_like
        Height at each distance [m].
    periodic : bool, optional
        Whether the profile repeats.
    """
    return Profile(np.array(distance), np.array(height), periodic)


def _measured(*, file: Path, lateral: float = 0.0, periodic: bool = False) -> Profile:
    """Return a profile from a file, see `viscoroll.ground.Profile.read`.

    Parameters
    ----------
    file : str
        Name of the file.
    lateral : float, optional
        Lateral position of the section of an OpenCRG surface [m].
    periodic : bool, optional
        Whether the profile repeats.
    """
    try:
        return Profile.read(file, lateral=lateral, periodic=periodic)
    except OSError as error:
        raise ValueError(f"profile {file}: {error.strerror}") from None


_TABLES = (
    Annotated[Profile, Table("points", _points, distance=list[float], height=list[float], periodic=bool)],
    Annotated[Profile, Table("file", _measured, file=FileName, periodic=bool)],
    Annotated[Profile, Table("step", Profile.step, documented_by=Profile.step)],
    Annotated[Profile, Table("half_sine", Profile.half_sine, documented_by=Profile.half_sine)],
    Annotated[Profile, Table("joint", Profile.joint, documented_by=Profile.joint)],
    Annotated[Profile, Table("corrugation", Profile.corrugation, documented_by=Profile.corrugation)],
)

if TYPE_CHECKING:
    ProfileTable: TypeAlias = Profile
    AxleTable: TypeAlias = Axle
else:
    ProfileTable = Annotated[reduce(or_, _TABLES), Field(discriminator="type")]
    AxleTable = Annotated[Axle, Table()]
