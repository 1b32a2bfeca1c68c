"""Steady rolling contact of a coated ball, roller or wheel."""

from __future__ import annotations

from functools import partial
from typing import Any

from .. import _core
from .._core import Compliance, Curvature, PatchLoad, SlipKinematics
from .._support.arguments import as_float, as_int, as_member, require_type
from .._support.cautions import warn
from .._support.keywords import explained
from .._support.progress import ProgressLike, reporting
from .._support.text import shown
from ..bodies import Counterpart, Drive, Mesh, RollingBody, core_counterpart
from ..bodies.si_hints import si_hints
from ..solution.text import cautions
from .result import Result

__all__ = ["RollingModel", "solve"]


def solve(
    ball: RollingBody,
    *,
    on: Counterpart | None = None,
    load: float,
    angular_speed: float,
    mesh: Mesh | None = None,
    accuracy: float | None = None,
    friction: float = 0.0,
    drive: Drive = Drive(force=0.0),  # noqa: B008  (immutable)
    compliance: Compliance | str = Compliance.RADIAL,
    curvature: Curvature | str = Curvature.SPHERE,
    patch_load: PatchLoad | str = PatchLoad.FLAT,
    slip_kinematics: SlipKinematics | str = SlipKinematics.EXACT,
    max_iterations: int = 2000,
    threads: int = 0,
    progress: ProgressLike = None,
) -> Result:
    """Solve steady rolling on a plane, in a groove or on another body, with Coulomb friction or without.

    The call releases the GIL, may run on several threads at once, and stops on Ctrl-C.

    Parameters
    ----------
    ball : CoatedSphere, CoatedCylinder or CoatedWheel
        What rolls: rigid core and layers.
    on : CoatedPlane, Groove, CoatedSphere, CoatedCylinder or CoatedWheel, optional
        What it rolls on; without it the rigid plane. A ball rolls on a plane, in a groove or on another ball; a
        cylinder on a plane, in a groove that is curved along its path, or on another cylinder; a wheel on a plane, in a
        groove, on a cylinder or another wheel, whose axis is parallel. One of the two may be rigid, without layers. The
        memory of both is that of material that passes the contact at Ω r_o.
    load : float
        P, force that presses the body on what it rolls on [N], of a roller per length [N/m], > 0.
    angular_speed : float
        Ω [rad/s], > 0 and below `critical_speed(ball)`; of two bodies on axes of their own relative to the line of
        their centers.
    mesh : Mesh, optional
        Surface mesh. Without it, meshes are refined until the error estimate is below `accuracy`.
    accuracy : float, default 0.01
        Wanted relative error [-], in [1e-4, 0.5]; only without `mesh`. The estimate is the largest of the power-balance
        error and the changes, from the mesh before, of all that is not given: penetration, torques, forces, speed and
        powers. The largest pressure has an estimate of its own, `Result.max_pressure_error`; for it meshes are refined
        on as far as some seconds go, and where that does not do a warning says so.
    friction : float, default 0
        Coulomb's coefficient μ between coating and plane [-], in [0, 4]. With ``math.inf`` all of the contact sticks; a
        `ConvergenceError` says where that asks for tension.
    drive : Drive, default Drive(force=0.0)
        What closes the problem for the speed of the center. Without friction, where that speed is undetermined, a force
        of 0 or a creepage; torque and force then follow from who loses what.
    compliance : Compliance or str, default Compliance.RADIAL
        In the contact condition: C_RR, pressure along the radius, which is nearer to finite strain, or C_WW, pressure
        on the normals of the undeformed ball. Their difference is of the order of the strain: a measure of what linear
        theory does not know.
    curvature : Curvature or str, default Curvature.SPHERE
        What the equations of the layers keep of it: the membrane stiffness of a sphere, PAPER's as printed, or all of
        it, EXACT, for thick coatings, hollow and solid balls.
    patch_load : PatchLoad or str, default PatchLoad.FLAT
        Traction on the patch of a node: equation (53) or (38) of the paper.
    slip_kinematics : SlipKinematics or str, default SlipKinematics.EXACT
        With friction: how far material travels between the nodes of an undeformed ball. FLAT is the last form of the
        paper's (55a), which knows no Heathcote slip; for comparison only.
    max_iterations : int, default 2000
        Linear systems solved on a mesh, ≥ 1.
    threads : int, default 0
        Number of threads; 0 for all cores. The result does not depend on it.
    progress : bool or callable, optional
        True shows a bar; or called as progress(stage, fraction) about every 20 ms.

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

    Warns
    -----
    ResultWarning
        Where the accuracy was not reached, by the estimate or by that of the largest pressure, a given mesh is coarse
        (fewer than ten nodes across the contact), or the strain is above 0.2; also in `Result.warnings`. Where lengths
        or moduli are none of any product in SI units.

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
    require_type("ball", ball, RollingBody)
    require_type("mesh", mesh, Mesh, optional=True)
    curvature = as_member("curvature", curvature, Curvature)
    if mesh is not None and accuracy is not None:
        raise ValueError(f"accuracy must be left out where a mesh is given, got {shown(accuracy)}")
    speed = as_float("angular_speed", angular_speed)
    case = _core_case(load, friction, drive, compliance, patch_load, slip_kinematics, max_iterations, threads)
    with reporting(progress) as report, si_hints(ball, on, angular_speed=speed):
        solution = _core.solve(
            ball._to_core(),
            core_counterpart(on),
            angular_speed=speed,
            mesh=None if mesh is None else mesh._to_core(),
            curvature=curvature,
            accuracy=0.01 if accuracy is None else as_float("accuracy", accuracy),
            progress=report,
            **case,
        )
    return _result(solution, ball, on, speed, drive, curvature, case)


class RollingModel:
    """A ball at one speed on one mesh, for many load cases: its influence tables are computed once.

    Threads may solve on it at the same time. Tables reach as far as the largest load so far has asked for: results may
    differ in their last digits, with `Curvature.EXACT` by up to 1e-5, with the loads that were solved before.

    Parameters
    ----------
    ball : CoatedSphere, CoatedCylinder or CoatedWheel
        What rolls: rigid core and layers.
    on : CoatedPlane, Groove, CoatedSphere, CoatedCylinder or CoatedWheel, optional
        As of `solve`.
    angular_speed : float
        Ω [rad/s], > 0 and below `critical_speed(ball)`.
    mesh : Mesh
        Surface mesh.
    curvature : Curvature or str, default Curvature.SPHERE
        As of `solve`.
    threads : int, default 0
        Number of threads; 0 for all cores.
    progress : bool or callable, optional
        True shows a bar; or called as progress(stage, fraction) about every 20 ms.

    Raises
    ------
    ValueError, TypeError
        For bad input, as of `solve`.

    Examples
    --------
    >>> from viscoroll import paper
    >>> model = RollingModel(paper.ball(), angular_speed=2.5, mesh=Mesh(nodes_per_revolution=1000))
    >>> [f"{model.solve(load=load).resisting_torque * 1e3:.0f} mN m" for load in (50.0, 100.0)]
    ['4 mN m', '11 mN m']
    """

    def __init__(
        self,
        ball: RollingBody,
        *,
        on: Counterpart | None = None,
        angular_speed: float,
        mesh: Mesh,
        curvature: Curvature | str = Curvature.SPHERE,
        threads: int = 0,
        progress: ProgressLike = None,
    ) -> None:
        require_type("ball", ball, RollingBody)
        require_type("mesh", mesh, Mesh)
        curvature = as_member("curvature", curvature, Curvature)
        self.ball = ball
        self.on = on
        self.angular_speed = as_float("angular_speed", angular_speed)
        self.mesh = mesh
        self.curvature = curvature
        with reporting(progress) as report, si_hints(ball, on, angular_speed=self.angular_speed):
            self._core = _core.RollingModel(
                ball._to_core(),
                core_counterpart(on),
                angular_speed=self.angular_speed,
                mesh=mesh._to_core(),
                curvature=curvature,
                threads=as_int("threads", threads),
                progress=report,
            )

    def __repr__(self) -> str:
        """Return what it was made of."""
        return (
            f"RollingModel({self.ball!r}, on={self.on!r}, angular_speed={self.angular_speed!r}, mesh={self.mesh!r}, "
            f"curvature=Curvature.{self.curvature.name})"
        )

    def __reduce__(self) -> tuple[partial[RollingModel], tuple[RollingBody]]:
        """Pickle the input; the tables are computed again."""
        given = {name: getattr(self, name) for name in ("on", "angular_speed", "mesh", "curvature")}
        return partial(type(self), **given), (self.ball,)

    @explained
    def solve(
        self,
        *,
        load: float,
        friction: float = 0.0,
        drive: Drive = Drive(force=0.0),  # noqa: B008  (immutable)
        compliance: Compliance | str = Compliance.RADIAL,
        patch_load: PatchLoad | str = PatchLoad.FLAT,
        slip_kinematics: SlipKinematics | str = SlipKinematics.EXACT,
        max_iterations: int = 2000,
        threads: int = 0,
        progress: ProgressLike = None,
    ) -> Result:
        """Solve one load case; parameters, result and errors as of `viscoroll.solve`."""
        case = _core_case(load, friction, drive, compliance, patch_load, slip_kinematics, max_iterations, threads)
        with reporting(progress) as report, si_hints(self.ball, self.on, angular_speed=self.angular_speed):
            solution = self._core.solve(angular_speed=self.angular_speed, progress=report, **case)
        return _result(solution, self.ball, self.on, self.angular_speed, drive, self.curvature, case)


def _core_case(
    load: float,
    friction: float,
    drive: Drive,
    compliance: Compliance | str,
    patch_load: PatchLoad | str,
    slip_kinematics: SlipKinematics | str,
    max_iterations: int,
    threads: int,
) -> dict[str, Any]:
    """Settle the types of a load case and its options, as the core wants them."""
    compliance = as_member("compliance", compliance, Compliance)
    patch_load = as_member("patch_load", patch_load, PatchLoad)
    slip_kinematics = as_member("slip_kinematics", slip_kinematics, SlipKinematics)
    require_type("drive", drive, Drive)
    return {
        "load": as_float("load", load),
        "friction": as_float("friction", friction),
        "drive": drive._to_core(),
        "compliance": compliance,
        "patch_load": patch_load,
        "slip_kinematics": slip_kinematics,
        "max_iterations": as_int("max_iterations", max_iterations),
        "threads": as_int("threads", threads),
    }


def _result(
    solution: _core.Result,
    ball: RollingBody,
    on: Counterpart | None,
    angular_speed: float,
    drive: Drive,
    curvature: Curvature | str,
    case: dict[str, Any],
) -> Result:
    """Make the result, and warn of what to know before relying on it."""
    given = {name: case[name] for name in ("load", "friction", "compliance", "patch_load")}
    result = Result._from_core(
        solution, ball=ball, on=on, angular_speed=angular_speed, drive=drive, curvature=curvature, **given
    )
    warn(cautions(result))
    return result
