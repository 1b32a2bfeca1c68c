"""Steady rolling contact of a coated sphere on a rigid plane."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _core
from ._arrays import as_float, as_int
from ._core import Compliance, PatchLoad, SlipKinematics
from .drive import Drive
from .geometry import CoatedSphere
from .mesh import Mesh
from .result import Result

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["solve"]


def solve(
    ball: CoatedSphere,
    *,
    load: float,
    angular_speed: float,
    mesh: Mesh | None = None,
    accuracy: float | None = None,
    friction: float = 0.0,
    drive: Drive = Drive(force=0.0),  # noqa: B008  (immutable)
    compliance: Compliance = Compliance.VERTICAL,
    patch_load: PatchLoad = PatchLoad.FLAT,
    slip_kinematics: SlipKinematics = SlipKinematics.EXACT,
    max_iterations: int = 500,
    threads: int = 0,
    progress: Callable[[str, float], object] | None = None,
) -> Result:
    """Solve steady rolling on a rigid plane, with Coulomb friction or without.

    The call releases the GIL, may run on several threads at once, and stops on Ctrl-C.

    Parameters
    ----------
    ball : CoatedSphere
        Rigid core and layers.
    load : float
        P, force that presses the ball on the plane [N], > 0.
    angular_speed : float
        Ω [rad/s], > 0 and below `critical_speed(ball)`.
    mesh : Mesh, optional
        Surface mesh. Without it, meshes are refined until the error estimate is below `accuracy`.
    accuracy : float, default 0.01
        Wanted relative error [-], in [1e-4, 0.5]; only without `mesh`. The estimate is the larger of the power-balance
        error and the changes of torque and penetration from the mesh before.
    friction : float, default 0
        Coulomb's coefficient μ between coating and plane [-], ≥ 0.
    drive : Drive, default Drive(force=0.0)
        What closes the problem for the speed of the center. Without friction, where that speed is undetermined, a force
        of 0 or a creepage.
    compliance : Compliance, default Compliance.VERTICAL
        In the contact condition: C_WW, the model itself, or C_RR, the paper's shortcut.
    patch_load : PatchLoad, default PatchLoad.FLAT
        Traction on the patch of a node: equation (53) or (38) of the paper.
    slip_kinematics : SlipKinematics, default SlipKinematics.EXACT
        With friction: how far material travels between the nodes of an undeformed ball. FLAT is the last form of the
        paper's (55a), which knows no Heathcote slip; for comparison only.
    max_iterations : int, default 500
        Linear systems solved on a mesh, ≥ 1.
    threads : int, default 0
        Number of threads; 0 for all cores. The result does not depend on it.
    progress : callable, optional
        Called as progress(stage, fraction) about every 20 ms.

    Returns
    -------
    Result
        Torque, penetration, fields and powers; look at `status`.

    Raises
    ------
    ValueError
        For bad input, a load too large for the coating (penetration ≥ thickness), speeds at or above the critical one,
        and drives with which the ball slides without end. The message names parameter, value, unit and range.
    TypeError
        For arguments of another type.
    ConvergenceError
        Where no usable state was found; the message gives the residual.
    KeyboardInterrupt
        On Ctrl-C, within 0.3 s.

    References
    ----------
    Sections 11 to 13 of G.-P. Zéhil and H. P. Gavin, "Rolling resistance of a rigid sphere with viscoelastic
    coatings".

    Examples
    --------
    >>> from viscoroll import CoatedSphere, Layer, StandardLinearSolid
    >>> rubber = StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> layer = Layer(thickness=1e-3, shear_modulus=rubber, poisson_ratio=0.5, density=1000.0)
    >>> ball = CoatedSphere(core_radius=20e-3, layers=[layer])
    >>> r = solve(ball, load=100.0, angular_speed=2.5, accuracy=0.05)
    >>> r.status.name
    'CONVERGED'
    """
    if not isinstance(ball, CoatedSphere):
        raise TypeError(f"ball must be a viscoroll.CoatedSphere, got {ball!r}")
    if mesh is not None and not isinstance(mesh, Mesh):
        raise TypeError(f"mesh must be a viscoroll.Mesh or None, got {mesh!r}")
    if mesh is not None and accuracy is not None:
        raise ValueError(f"accuracy must be left out where a mesh is given, got {accuracy!r}")
    if not isinstance(compliance, Compliance):
        raise TypeError(f"compliance must be a viscoroll.Compliance, got {compliance!r}")
    if not isinstance(patch_load, PatchLoad):
        raise TypeError(f"patch_load must be a viscoroll.PatchLoad, got {patch_load!r}")
    if not isinstance(slip_kinematics, SlipKinematics):
        raise TypeError(f"slip_kinematics must be a viscoroll.SlipKinematics, got {slip_kinematics!r}")
    if not isinstance(drive, Drive):
        raise TypeError(f"drive must be a viscoroll.Drive, got {drive!r}")
    if progress is not None and not callable(progress):
        raise TypeError(f"progress must be callable or None, got {progress!r}")
    solution = _core.solve(
        ball._to_core(),
        load=as_float("load", load),
        angular_speed=as_float("angular_speed", angular_speed),
        mesh=None if mesh is None else mesh._to_core(),
        accuracy=0.01 if accuracy is None else as_float("accuracy", accuracy),
        friction=as_float("friction", friction),
        drive=drive._to_core(),
        compliance=compliance,
        patch_load=patch_load,
        slip_kinematics=slip_kinematics,
        max_iterations=as_int("max_iterations", max_iterations),
        threads=as_int("threads", threads),
        progress=progress,
    )
    return Result._from_core(
        solution,
        ball=ball,
        load=float(load),
        angular_speed=float(angular_speed),
        friction=float(friction),
        drive=drive,
        compliance=compliance,
        patch_load=patch_load,
    )
