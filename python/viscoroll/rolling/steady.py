"""Steady rolling contact of a coated ball, roller or wheel."""

from __future__ import annotations

from functools import partial
from typing import Any

from .. import _core
from .._core import Compliance, Curvature, PatchLoad, SlipKinematics
from .._support.arguments import as_float, as_int, as_member, as_positive, require_type
from .._support.errors import InvalidInput
from .._support.progress import ProgressLike, reporting
from .._support.result_warnings import warn
from .._support.text import shown
from ..bodies import Adhesion, Counterbody, Drive, Mesh, RollingBody, core_counterbody
from ..bodies.si_hints import si_hints
from ..solution.text import result_warnings
from .result import Result

__all__ = ["RollingModel", "pull_off", "solve", "solved_speed"]


def solve(
    body: RollingBody,
    *,
    on: Counterbody | None = None,
    load: float | None = None,
    penetration: float | None = None,
    angular_speed: float | None = None,
    speed: float | None = None,
    mesh: Mesh | None = None,
    accuracy: float | None = None,
    friction: float = 0.0,
    drive: Drive = Drive(force=0.0),  # noqa: B008  (immutable)
    adhesion: Adhesion | None = None,
    compliance: Compliance | str = Compliance.RADIAL,
    curvature: Curvature | str = Curvature.SPHERE,
    patch_load: PatchLoad | str = PatchLoad.FLAT,
    slip_kinematics: SlipKinematics | str = SlipKinematics.EXACT,
    finite_strain: bool = True,
    max_iterations: int = 2000,
    threads: int = 0,
    progress: ProgressLike = None,
) -> Result:
    """Solve steady rolling on a plane, in a groove or on another body, with or without Coulomb friction.

    The call releases the GIL, may run on several threads at once, and stops on Ctrl-C.

    Parameters
    ----------
    body : CoatedSphere, CoatedCylinder or CoatedWheel
        Rolling body: rigid core and layers.
    on : CoatedPlane, Groove, CoatedSphere, CoatedCylinder or CoatedWheel, optional
        Counterbody; by default the rigid plane. A ball rolls on a plane, in a groove or on another ball; a cylinder on
        a plane, in a groove that is curved along its path, or on another cylinder; a wheel on a plane, in a groove, on
        a cylinder or another wheel with a parallel axis. One of the two bodies may be rigid, without layers. In both
        bodies, the material passes the contact at the speed Ω r_o.
    load : float, optional
        Normal load P [N], > 0; with adhesion it may also be zero or negative. For rollers, load per length [N/m].
        Exactly one of `load` and `penetration` must be given.
    penetration : float, optional
        Penetration r_o - H [m], as for rollers with a fixed gap; the load is then the result `Result.load`. It is the
        same quantity as `Result.penetration`: radius of the rolling body at rest minus height of its center above the
        undeformed counterbody. It must be larger than minus `Result.centrifugal_displacement`, which is 0 without
        density, and smaller than the thickness of the layers of both bodies. In line contact on a half-space it is
        undetermined and cannot be given. It does not contain thermal expansion: use the radius of the warm body.
    angular_speed : float
        Angular speed Ω [rad/s], > 0 and below `critical_speed(body)`. On another ball, roller or wheel, the speed
        relative to the line of centers. Exactly one of `angular_speed` and `speed` must be given.
    speed : float, optional
        Speed V of the ground or belt [m/s], > 0; only without friction. The contact is solved at the angular speed
        V / r_o, which is `Result.angular_speed`; because the surface is stretched in the contact, the body turns more
        slowly, at `Result.finite_strain_angular_speed`.
    mesh : Mesh, optional
        Surface mesh. By default the solver refines the mesh until the error estimate is below `accuracy`.
    accuracy : float, default 0.01
        Requested relative error [-], in [1e-4, 0.5]; only without `mesh`. The error estimate is the larger of the
        energy-balance error, with adhesion a tenth of it, and the largest change from the previous mesh of all results
        that are not given: load, penetration, torques, forces, speed and powers. The largest pressure has an estimate
        of its own, `Result.max_pressure_error`. The solver refines the mesh further for it, within some seconds; if
        that does not suffice, it issues a warning.
    friction : float, default 0
        Coulomb's coefficient of friction μ [-], in [0, 4]. With ``math.inf`` the whole contact sticks; if that would
        require tension, a `ConvergenceError` is raised.
    drive : Drive, default Drive(force=0.0)
        Condition that determines the speed of the center. Without friction, where that speed is undetermined, only a
        force of 0 or a creepage is allowed; torque and force then follow from the power dissipated in each body.
    adhesion : Adhesion, optional
        Adhesion of the surfaces of balls and rollers, without friction; by default none. With adhesion there are no
        results at finite strain and no sensitivities.
    compliance : Compliance or str, default Compliance.RADIAL
        Compliance in the contact condition: C_RR (RADIAL), pressure along the radius, which is closer to finite strain,
        or C_WW (VERTICAL), pressure along the normals of the undeformed ball. The difference is of the order of the
        strain and measures the error of linear theory.
    curvature : Curvature or str, default Curvature.SPHERE
        Curvature terms in the equations of the layers: the membrane stiffness of a sphere (SPHERE), that of the paper
        as printed (PAPER), or all terms (EXACT), for thick coatings and for hollow and solid balls.
    patch_load : PatchLoad or str, default PatchLoad.FLAT
        Traction on the patch of a node: equation (53) (FLAT) or (38) (SPHERICAL) of the paper.
    slip_kinematics : SlipKinematics or str, default SlipKinematics.EXACT
        Distance that material travels between nodes, with friction: that on the undeformed body (EXACT), or the last
        form of the paper's (55a) (FLAT), which has no Heathcote slip and serves only for comparison.
    finite_strain : bool, default True
        Whether to compute `Result.finite_strain_torque` and the other results at finite strain. Unless `speed` is
        given, they need a second solution, at a speed that is higher by `Result.overspeed`.
    max_iterations : int, default 2000
        Largest number of linear systems solved on a mesh, ≥ 1.
    threads : int, default 0
        Number of threads; 0 for all cores. The result does not depend on it.
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction) about every 20 ms.

    Returns
    -------
    Result
        Torque, load, penetration, fields and powers. Check `status`.

    Raises
    ------
    ValueError
        If an argument is out of range, both or neither of load and penetration are given, the load is too large for
        the coating (penetration ≥ thickness), the speed is at or above the critical one, the body would slide
        without end under the drive, or it lifts off because adhesion does not support the tension. The message
        contains parameter, value, unit and allowed range.
    TypeError
        If an argument has the wrong type.
    ConvergenceError
        If the solver finds no usable state. The message contains the residual.
    KeyboardInterrupt
        On Ctrl-C, within 0.3 s.

    Warns
    -----
    ResultWarning
        If the result or the largest pressure does not reach the accuracy, a given mesh is coarse (fewer than ten nodes
        across the contact), the cohesive zones of adhesion are long compared with the contact or a layer, or the strain
        is above 0.2; also in `Result.warnings`. If lengths or moduli look as if they were not given in SI units.

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
    require_type("body", body, RollingBody)
    require_type("mesh", mesh, Mesh, optional=True)
    curvature = as_member("curvature", curvature, Curvature)
    if mesh is not None and accuracy is not None:
        raise InvalidInput("accuracy", "must be left out if a mesh is given", shown(accuracy))
    solved_at = solved_speed(body, angular_speed, speed)
    load_case = _core_load_case(load, penetration, angular_speed, speed, friction, drive, adhesion)
    options = _core_options(
        compliance,
        patch_load,
        slip_kinematics,
        finite_strain,
        max_iterations,
        threads,
        mesh=None if mesh is None else mesh._to_core(),
        curvature=curvature,
        **({} if accuracy is None else {"accuracy": as_float("accuracy", accuracy)}),
    )
    with reporting(progress) as report, si_hints(body, on, angular_speed=solved_at):
        solution = _core.solve(body._to_core(), core_counterbody(on), load_case, options, progress=report)
    return _result(solution, body, on, load_case, solved_at, drive, adhesion, curvature, options)


def pull_off(
    body: RollingBody,
    *,
    on: Counterbody | None = None,
    angular_speed: float,
    adhesion: Adhesion,
    mesh: Mesh | None = None,
    accuracy: float | None = None,
    threads: int = 0,
    progress: ProgressLike = None,
) -> Result:
    """Find the largest tension that adhesion supports while a body rolls.

    Parameters
    ----------
    body, on, angular_speed, adhesion, mesh, accuracy, threads, progress
        Same as in `solve`.

    Returns
    -------
    Result
        State of the largest tension; `Result.load` is the smallest load [N], negative, for rollers [N/m]. At a given
        penetration, states beyond it exist as well.

    Raises
    ------
    ValueError, TypeError, ConvergenceError
        Same as in `solve`.

    Examples
    --------
    The tension of a ball on a half-space is about 1.5 π w R (K. L. Johnson, K. Kendall and A. D. Roberts 1971):

    >>> import viscoroll as vr
    >>> rubber = vr.HalfSpace(shear_modulus=vr.Elastic(modulus=1e6), poisson_ratio=0.5)
    >>> rigid, plane = vr.CoatedSphere(core_radius=10e-3), vr.CoatedPlane(base=rubber)
    >>> adhesion = vr.Adhesion(work=0.1)
    >>> state = pull_off(rigid, on=plane, angular_speed=1.0, adhesion=adhesion, accuracy=0.05)
    >>> f"{-state.load * 1e3:.1f} mN"
    '4.8 mN'
    """
    require_type("body", body, RollingBody)
    require_type("mesh", mesh, Mesh, optional=True)
    require_type("adhesion", adhesion, Adhesion)
    if mesh is not None and accuracy is not None:
        raise InvalidInput("accuracy", "must be left out if a mesh is given", shown(accuracy))
    drive = Drive(force=0.0)
    solved_at = as_float("angular_speed", angular_speed)
    load_case = _core.LoadCase(angular_speed=solved_at, adhesion=adhesion._to_core(), pulls_off=True)
    options = _core_options(
        Compliance.RADIAL,
        PatchLoad.FLAT,
        SlipKinematics.EXACT,
        finite_strain=False,
        max_iterations=2000,
        threads=threads,
        mesh=None if mesh is None else mesh._to_core(),
        **({} if accuracy is None else {"accuracy": as_float("accuracy", accuracy)}),
    )
    with reporting(progress) as report, si_hints(body, on, angular_speed=solved_at):
        solution = _core.solve(body._to_core(), core_counterbody(on), load_case, options, progress=report)
    return _result(solution, body, on, load_case, solved_at, drive, adhesion, Curvature.SPHERE, options)


class RollingModel:
    """Rolling contact at one speed on one mesh, for many load cases: it computes the influence tables once.

    Several threads may solve on the same model. The tables grow with the largest load so far. Results may therefore
    depend in their last digits on the loads that were solved before; with `Curvature.EXACT` by up to 1e-5.

    Parameters
    ----------
    body : CoatedSphere, CoatedCylinder or CoatedWheel
        Rolling body: rigid core and layers.
    on : CoatedPlane, Groove, CoatedSphere, CoatedCylinder or CoatedWheel, optional
        Counterbody, same as in `solve`.
    angular_speed : float, optional
        Angular speed Ω [rad/s], > 0 and below `critical_speed(body)`. Exactly one of `angular_speed` and `speed` must
        be given.
    speed : float, optional
        Speed V of the ground or belt [m/s], same as in `solve`.
    mesh : Mesh
        Surface mesh.
    curvature : Curvature or str, default Curvature.SPHERE
        Curvature terms in the equations of the layers, same as in `solve`.
    threads : int, default 0
        Number of threads; 0 for all cores.
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction) about every 20 ms.

    Raises
    ------
    ValueError, TypeError
        If an argument is invalid, same as in `solve`.

    Examples
    --------
    >>> from viscoroll import paper
    >>> model = RollingModel(paper.ball(), angular_speed=2.5, mesh=Mesh(nodes_per_revolution=1000))
    >>> [f"{model.solve(load=load).resisting_torque * 1e3:.0f} mN m" for load in (50.0, 100.0)]
    ['4 mN m', '11 mN m']
    """

    def __init__(
        self,
        body: RollingBody,
        *,
        on: Counterbody | None = None,
        angular_speed: float | None = None,
        speed: float | None = None,
        mesh: Mesh,
        curvature: Curvature | str = Curvature.SPHERE,
        threads: int = 0,
        progress: ProgressLike = None,
    ) -> None:
        require_type("body", body, RollingBody)
        require_type("mesh", mesh, Mesh)
        curvature = as_member("curvature", curvature, Curvature)
        self.body = body
        self.on = on
        self.angular_speed = solved_speed(body, angular_speed, speed)
        self.speed = speed
        self.mesh = mesh
        self.curvature = curvature
        with reporting(progress) as report, si_hints(body, on, angular_speed=self.angular_speed):
            self._core = _core.RollingModel(
                body._to_core(),
                core_counterbody(on),
                angular_speed=self.angular_speed,
                speed=None if speed is None else as_float("speed", speed),
                mesh=mesh._to_core(),
                curvature=curvature,
                threads=as_int("threads", threads),
                progress=report,
            )

    def __repr__(self) -> str:
        """Return the arguments of the constructor."""
        name = self._given_speed()
        return (
            f"RollingModel({self.body!r}, on={self.on!r}, {name}={getattr(self, name)!r}, mesh={self.mesh!r}, "
            f"curvature=Curvature.{self.curvature.name})"
        )

    def _given_speed(self) -> str:
        return "angular_speed" if self.speed is None else "speed"

    def __reduce__(self) -> tuple[partial[RollingModel], tuple[RollingBody]]:
        """Pickle the arguments; the copy computes the tables again."""
        given = {name: getattr(self, name) for name in ("on", self._given_speed(), "mesh", "curvature")}
        return partial(type(self), **given), (self.body,)

    def solve(
        self,
        *,
        load: float | None = None,
        penetration: float | None = None,
        friction: float = 0.0,
        drive: Drive = Drive(force=0.0),  # noqa: B008  (immutable)
        adhesion: Adhesion | None = None,
        compliance: Compliance | str = Compliance.RADIAL,
        patch_load: PatchLoad | str = PatchLoad.FLAT,
        slip_kinematics: SlipKinematics | str = SlipKinematics.EXACT,
        finite_strain: bool = True,
        max_iterations: int = 2000,
        threads: int = 0,
        progress: ProgressLike = None,
    ) -> Result:
        """Solve one load case; parameters, result and errors are the same as in `viscoroll.solve`."""
        load_case = _core_load_case(
            load, penetration, self.angular_speed if self.speed is None else None, self.speed, friction, drive, adhesion
        )
        options = _core_options(compliance, patch_load, slip_kinematics, finite_strain, max_iterations, threads)
        with reporting(progress) as report, si_hints(self.body, self.on, angular_speed=self.angular_speed):
            solution = self._core.solve(load_case, options, progress=report)
        return _result(
            solution, self.body, self.on, load_case, self.angular_speed, drive, adhesion, self.curvature, options
        )


def solved_speed(body: RollingBody, angular_speed: float | None, speed: float | None) -> float:
    """Return the angular speed at which linear theory is solved."""
    if angular_speed is None and speed is None:
        raise InvalidInput("angular_speed", "must be given, or speed instead of it", "neither")
    if speed is None:
        return as_float("angular_speed", angular_speed)
    if angular_speed is not None:
        raise InvalidInput(
            "speed",
            "must be left out if the angular speed is given",
            f"{speed:g} m/s" if isinstance(speed, int | float) else shown(speed),
        )
    return as_positive("speed", speed, "m/s") / body.outer_radius


def _core_load_case(
    load: float | None,
    penetration: float | None,
    angular_speed: float | None,
    speed: float | None,
    friction: float,
    drive: Drive,
    adhesion: Adhesion | None,
) -> _core.LoadCase:
    """Convert a load case to the type of the core."""
    require_type("drive", drive, Drive)
    require_type("adhesion", adhesion, Adhesion, optional=True)
    return _core.LoadCase(
        load=None if load is None else as_float("load", load),
        penetration=None if penetration is None else as_float("penetration", penetration),
        angular_speed=0.0 if angular_speed is None else as_float("angular_speed", angular_speed),
        speed=None if speed is None else as_float("speed", speed),
        friction=as_float("friction", friction),
        drive=drive._to_core(),
        adhesion=None if adhesion is None else adhesion._to_core(),
    )


def _core_options(
    compliance: Compliance | str,
    patch_load: PatchLoad | str,
    slip_kinematics: SlipKinematics | str,
    finite_strain: bool,
    max_iterations: int,
    threads: int,
    **of_the_model: Any,
) -> _core.Options:
    """Convert options to the type of the core: those of all load cases, and those that a model has, if given."""
    require_type("finite_strain", finite_strain, bool)
    return _core.Options(
        compliance=as_member("compliance", compliance, Compliance),
        patch_load=as_member("patch_load", patch_load, PatchLoad),
        slip_kinematics=as_member("slip_kinematics", slip_kinematics, SlipKinematics),
        finite_strain=finite_strain,
        max_iterations=as_int("max_iterations", max_iterations),
        threads=as_int("threads", threads),
        **of_the_model,
    )


def _result(
    solution: _core.Result,
    body: RollingBody,
    on: Counterbody | None,
    load_case: _core.LoadCase,
    angular_speed: float,
    drive: Drive,
    adhesion: Adhesion | None,
    curvature: Curvature | str,
    options: _core.Options,
) -> Result:
    """Return the result, and issue its warnings."""
    result = Result._from_core(
        solution,
        body=body,
        on=on,
        prescribed="penetration" if load_case.load is None else "load",
        angular_speed=angular_speed,
        friction=load_case.friction,
        drive=drive,
        adhesion=adhesion,
        curvature=curvature,
        compliance=options.compliance,
        patch_load=options.patch_load,
    )
    warn(result_warnings(result))
    return result
