# Made by python/bindings/make_stub.py from the compiled module: `make stubs` renews it.
# ruff: noqa
"""
C++ core of viscoroll; use the package viscoroll instead.
"""

from __future__ import annotations
import collections.abc
import enum
import numpy
import numpy.typing
import typing

class ConvergenceError(RuntimeError):
    """
    An iteration ended without a usable answer; the message says how far it came.
    """

class Extrapolation(enum.Enum):
    """What a master curve does outside its table."""

    ERROR = ...
    HOLD = ...

class Elastic:
    def __init__(self, *, modulus: typing.SupportsFloat | typing.SupportsIndex) -> None: ...

class Prony:
    def __init__(
        self,
        *,
        instantaneous_modulus: typing.SupportsFloat | typing.SupportsIndex,
        weights: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        relaxation_times: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
    ) -> None: ...

class KelvinVoigt:
    def __init__(
        self,
        *,
        modulus: typing.SupportsFloat | typing.SupportsIndex,
        viscosity: typing.SupportsFloat | typing.SupportsIndex,
    ) -> None: ...

class FractionalZener:
    def __init__(
        self,
        *,
        instantaneous_modulus: typing.SupportsFloat | typing.SupportsIndex,
        relaxed_modulus: typing.SupportsFloat | typing.SupportsIndex,
        relaxation_time: typing.SupportsFloat | typing.SupportsIndex,
        order: typing.SupportsFloat | typing.SupportsIndex,
    ) -> None: ...

class MasterCurve:
    def __init__(
        self,
        *,
        frequency: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        storage: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        loss: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        extrapolation: Extrapolation,
    ) -> None: ...

class CustomModulus:
    def __init__(
        self, function: collections.abc.Callable[[numpy.typing.NDArray[numpy.float64]], typing.Any]
    ) -> None: ...

class Layer:
    def __init__(
        self,
        *,
        thickness: typing.SupportsFloat | typing.SupportsIndex,
        shear_modulus: Elastic | Prony | KelvinVoigt | FractionalZener | MasterCurve | CustomModulus,
        poisson_ratio: typing.SupportsFloat | typing.SupportsIndex | None,
        bulk_modulus: typing.SupportsFloat | typing.SupportsIndex | None,
        density: typing.SupportsFloat | typing.SupportsIndex,
    ) -> None: ...

class InnerBoundary(enum.Enum):
    """What lies within the innermost layer."""

    RIGID = ...
    HOLLOW = ...
    SOLID = ...

class Curvature(enum.Enum):
    """How much of the sphere's curvature the equations keep."""

    SPHERE = ...
    PAPER = ...
    EXACT = ...

class CoatedSphere:
    def __init__(
        self,
        *,
        core_radius: typing.SupportsFloat | typing.SupportsIndex,
        layers: collections.abc.Sequence[Layer],
        inner_boundary: InnerBoundary,
    ) -> None: ...

class CoatedCylinder:
    def __init__(
        self, *, core_radius: typing.SupportsFloat | typing.SupportsIndex, layers: collections.abc.Sequence[Layer]
    ) -> None: ...

class Hub(enum.Enum):
    """What the hub of a crowned wheel looks like under the tread."""

    STRAIGHT = ...
    CROWNED = ...

class Sides(enum.Enum):
    """What a tread ends in."""

    FREE = ...
    ENDLESS = ...

class CoatedWheel:
    def __init__(
        self,
        *,
        core_radius: typing.SupportsFloat | typing.SupportsIndex,
        layers: collections.abc.Sequence[Layer],
        width: typing.SupportsFloat | typing.SupportsIndex,
        crown_radius: typing.SupportsFloat | typing.SupportsIndex,
        hub: Hub,
        sides: Sides,
    ) -> None: ...

class HalfSpace:
    def __init__(
        self,
        *,
        shear_modulus: Elastic | Prony | KelvinVoigt | FractionalZener | MasterCurve | CustomModulus,
        poisson_ratio: typing.SupportsFloat | typing.SupportsIndex | None,
        bulk_modulus: typing.SupportsFloat | typing.SupportsIndex | None,
        density: typing.SupportsFloat | typing.SupportsIndex,
    ) -> None: ...

class CoatedPlane:
    def __init__(self, *, layers: collections.abc.Sequence[Layer], base: HalfSpace | None) -> None: ...

class Groove:
    def __init__(
        self,
        *,
        radius: typing.SupportsFloat | typing.SupportsIndex | None,
        path_radius: typing.SupportsFloat | typing.SupportsIndex | None,
        surface: CoatedPlane,
    ) -> None: ...

class Mesh:
    def __init__(
        self,
        *,
        nodes_per_revolution: typing.SupportsInt | typing.SupportsIndex,
        max_order: typing.SupportsInt | typing.SupportsIndex | None,
        theta_nodes_per_revolution: typing.SupportsInt | typing.SupportsIndex | None,
    ) -> None: ...
    @property
    def max_order(self) -> int | None: ...
    @property
    def nodes_per_revolution(self) -> int: ...
    @property
    def theta_nodes_per_revolution(self) -> int | None: ...

class Status(enum.Enum):
    """How a solve ended."""

    CONVERGED = ...
    MAX_ITERATIONS = ...
    ACCURACY_NOT_REACHED = ...

class WarningKind(enum.Enum):
    """What a user should know before relying on a result."""

    MAX_ITERATIONS = ...
    ACCURACY_NOT_REACHED = ...
    COARSE_MESH = ...
    POWER_BALANCE = ...
    PRESSURE_PEAK = ...
    LARGE_STRAIN = ...
    CONTACT_AT_SIDE = ...
    EDGE_PRESSURE = ...
    TIGHT_CROWN = ...

class Refinement:
    @property
    def contact_nodes(self) -> int: ...
    @property
    def error_estimate(self) -> float: ...
    @property
    def mesh(self) -> Mesh: ...
    @property
    def penetration(self) -> float | None: ...
    @property
    def power_balance_error(self) -> float: ...
    @property
    def resisting_torque(self) -> float: ...

class ScalarDescription:
    @property
    def details(self) -> str: ...
    @property
    def label(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def type(self) -> str: ...
    @property
    def unit(self) -> str: ...

class ResultScalars:
    @property
    def bulk_power(self) -> float:
        """
        power lost in the coating [W]. From the spectrum alone: not from the torque.
        """
    @property
    def center_height(self) -> float | None:
        """
        height of the center H [m]. Above what it rolls on. As determined as the penetration.
        """
    @property
    def centrifugal_displacement(self) -> float:
        """
        centrifugal displacement [m]. d_R^(c) in the contact condition.
        """
    @property
    def contact_area(self) -> float:
        """
        contact area [m^2].
        """
    @property
    def contact_width(self) -> float | None:
        """
        width of the contact, across the path [m]. From one of the outermost nodes that touch to the other, with their patches; None in line contact.
        """
    @property
    def counterpart_bulk_power(self) -> float:
        """
        power lost in what it rolls on [W]. The other share.
        """
    @property
    def creepage(self) -> float | None:
        """
        creepage V_s / (Ω r_o) - 1 [1]. As determined as the speed.
        """
    @property
    def dissipated_power(self) -> float:
        """
        power lost in all [W]. bulk_power + slip_power.
        """
    @property
    def driving_force(self) -> float:
        """
        driving force Q [N]. Force on the center: on a rigid straight plane Q = -Σ t_x; a counterpart that deforms or curves adds what its slope makes of the pressure.
        """
    @property
    def driving_torque(self) -> float:
        """
        driving torque T [N m]. Moment of the contact forces about the center: what turns the ball, and does the work of the model. On a rigid straight plane, with the radial compliance, Σ x p + Σ (y + u_y) t_x = T_r - Q H; with the vertical one, whose pressure does work along the plane too, Σ (x + u_x) p + Σ (y + u_y) t_x, which differs from it by a share of the order of the strain.
        """
    @property
    def error_estimate(self) -> float:
        """
        relative error estimate [1]. The power-balance error on a given mesh, else the largest of it and the changes, from the mesh before, of all that was not given: penetration, torques, forces, speed, powers.
        """
    @property
    def face_distance(self) -> float | None:
        """
        distance of the contact from the faces [m]. Of a wheel, from the nearer one: 0 where it reaches it; None for what has no faces.
        """
    @property
    def iterations(self) -> int:
        """
        linear systems solved on the last mesh [1].
        """
    @property
    def lateral_force(self) -> float:
        """
        lateral force on the ball [N]. Σ t_z, of the plane on the ball.
        """
    @property
    def linear_speed(self) -> float | None:
        """
        speed of the center V_s [m/s]. Undetermined without friction, unless given.
        """
    @property
    def max_pressure(self) -> float:
        """
        largest contact pressure [Pa]. Of the nodes.
        """
    @property
    def max_pressure_error(self) -> float:
        """
        relative error estimate of the largest pressure [1]. By how much a pressure one spacing ahead of a node, drawn through the node and the one behind it, lies above those of all nodes; without a given mesh also the change from the mesh before, and a quarter of that mesh's own, where these are more. Where material enters the contact faster than it relaxes, the pressure may have a peak that no mesh within reach resolves: torque and penetration do not hang on it.
        """
    @property
    def model_error(self) -> float | None:
        """
        what the model leaves open, by that strain [1]. Relative: 0.75 times the strain; on wheels with what crown and sides leave out. With the radial compliance it covers the torque and penetration of finite-strain computations for h/r_o from 1/84 to 1/5, ν = 0.3 and ½ and the viscosities of Newton and Jaumann, up to a strain of 0.24; a Lagrangian viscosity at ν = 0.3 leaves twice that.
        """
    @property
    def operator_applications(self) -> int:
        """
        displacements of trial forces that solved them [1]. Applications of the surface operator: products with the influence tables.
        """
    @property
    def penetration(self) -> float | None:
        """
        penetration r_o - H [m]. None in line contact where anything rests on a half-space: it has no limit there.
        """
    @property
    def power_balance_error(self) -> float:
        """
        relative power-balance error [1]. |T Ω + Q V_s - dissipated_power| relative to the larger, with the lateral force's work where there is some.
        """
    @property
    def residual(self) -> float:
        """
        largest violation of the contact conditions [1]. Without friction a gap relative to the penetration, with it the norm of all violations, as forces, relative to the load.
        """
    @property
    def resisting_torque(self) -> float:
        """
        resisting torque T_r, offset of the pressure times P [N m]. T_r = Σ x p. It is what turns the ball where nothing pulls it, and no friction or no force on the center acts.
        """
    @property
    def rolling_bulk_power(self) -> float:
        """
        power lost in what rolls [W]. Its share of bulk_power.
        """
    @property
    def rolling_resistance_coefficient(self) -> float:
        """
        rolling resistance coefficient, power lost / (P V) [1]. dissipated_power / (P |V|), whatever drives the ball. V is the speed of the center, or Ω r_o where that is undetermined; infinite where the center stands still.
        """
    @property
    def semi_axis_x(self) -> float:
        """
        contact semi-axis along x [m]. Of the ellipse with the contact's second moments; half of the width in line contact.
        """
    @property
    def semi_axis_z(self) -> float | None:
        """
        contact semi-axis along z [m]. Of the ellipse with the contact's second moments: longer than half of contact_width where the faces of a wheel cut the contact; None in line contact.
        """
    @property
    def slip_power(self) -> float:
        """
        power lost by slip [W]. Of both surfaces on one another.
        """
    @property
    def spin_moment(self) -> float:
        """
        spin moment on the ball [N m]. Σ (z t_x - x t_z), about the downward axis through the contact, of what it rolls on.
        """
    @property
    def strain(self) -> float | None:
        """
        strain, penetration per thickness of the coating [1]. The model's error grows with it. As determined as the penetration. Of both bodies together; a half-space counts as thick as the contact is wide, times its softness beside the layers'.
        """

class Result(ResultScalars):
    @property
    def contact(self) -> numpy.typing.NDArray[numpy.uint8]: ...
    @property
    def displacement(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def gap(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def mesh(self) -> Mesh: ...
    @property
    def pressure(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def refinements(self) -> list[Refinement]: ...
    @property
    def shear_traction(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def slip(self) -> numpy.typing.NDArray[numpy.uint8]: ...
    @property
    def slip_velocity(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def status(self) -> Status: ...
    @property
    def stick(self) -> numpy.typing.NDArray[numpy.uint8]: ...
    @property
    def warnings(self) -> dict[WarningKind, str]: ...
    @property
    def x(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def z(self) -> numpy.typing.NDArray[numpy.float64]: ...

class Compliance(enum.Enum):
    """The compliance in the contact condition."""

    RADIAL = ...
    VERTICAL = ...

class PatchLoad(enum.Enum):
    """Traction on the patch of a node."""

    FLAT = ...
    SPHERICAL = ...

class SlipKinematics(enum.Enum):
    """How far material travels between nodes of an undeformed sphere."""

    EXACT = ...
    FLAT = ...

class DriveForce:
    def __init__(self, force: typing.SupportsFloat | typing.SupportsIndex) -> None: ...

class DriveTorque:
    def __init__(self, torque: typing.SupportsFloat | typing.SupportsIndex) -> None: ...

class DriveCreepage:
    def __init__(
        self,
        *,
        creepage: typing.SupportsFloat | typing.SupportsIndex,
        lateral_creepage: typing.SupportsFloat | typing.SupportsIndex,
        spin: typing.SupportsFloat | typing.SupportsIndex,
    ) -> None: ...

class Options:
    def __init__(self) -> None: ...
    @property
    def accuracy(self) -> float: ...
    @property
    def compliance(self) -> Compliance: ...
    @property
    def curvature(self) -> Curvature: ...
    @property
    def max_iterations(self) -> int: ...
    @property
    def patch_load(self) -> PatchLoad: ...
    @property
    def slip_kinematics(self) -> SlipKinematics: ...
    @property
    def threads(self) -> int: ...

class RollingModel:
    def __init__(
        self,
        body: CoatedSphere | CoatedCylinder | CoatedWheel,
        on: CoatedPlane | CoatedCylinder | Groove | CoatedSphere | CoatedWheel,
        *,
        angular_speed: typing.SupportsFloat | typing.SupportsIndex,
        mesh: Mesh,
        curvature: Curvature,
        threads: typing.SupportsInt | typing.SupportsIndex,
        progress: typing.Any,
    ) -> None: ...
    def solve(
        self,
        *,
        load: typing.SupportsFloat | typing.SupportsIndex,
        angular_speed: typing.SupportsFloat | typing.SupportsIndex,
        friction: typing.SupportsFloat | typing.SupportsIndex,
        drive: DriveForce | DriveTorque | DriveCreepage,
        compliance: Compliance,
        patch_load: PatchLoad,
        slip_kinematics: SlipKinematics,
        max_iterations: typing.SupportsInt | typing.SupportsIndex,
        threads: typing.SupportsInt | typing.SupportsIndex,
        progress: typing.Any,
    ) -> Result: ...

class Tractions:
    def __init__(
        self,
        *,
        mesh: Mesh,
        radius: typing.SupportsFloat | typing.SupportsIndex,
        theta_spacing: typing.SupportsFloat | typing.SupportsIndex | None,
        crown_radius: typing.SupportsFloat | typing.SupportsIndex | None,
        line: bool,
        pressure: numpy.typing.NDArray[numpy.float64],
        shear_traction: numpy.typing.NDArray[numpy.float64],
        friction: bool,
        compliance: Compliance,
        curvature: Curvature,
        patch_load: PatchLoad,
        counterpart: bool,
        counterpart_curvature: typing.Annotated[
            collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex], "FixedSize(2)"
        ],
    ) -> None: ...

class LossDensity:
    @property
    def density(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def order_power(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def orders(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def places(self) -> tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.int32]]: ...
    @property
    def surface_power(self) -> float: ...
    @property
    def theta(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def volume_power(self) -> float: ...
    @property
    def weights(self) -> numpy.typing.NDArray[numpy.float64]: ...

class Start(enum.Enum):
    """What the coating has gone through before the first instant."""

    RELAXED = ...
    FRESH = ...

class HistoryOptions:
    compliance: Compliance
    curvature: Curvature
    mesh: Mesh | None
    def __init__(self) -> None: ...
    @property
    def center_speed(self) -> float: ...
    @center_speed.setter
    def center_speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def driving_force(self) -> float: ...
    @driving_force.setter
    def driving_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def driving_torque(self) -> float | None: ...
    @driving_torque.setter
    def driving_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex | None) -> None: ...
    @property
    def friction(self) -> float: ...
    @friction.setter
    def friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def lattices(self) -> int: ...
    @lattices.setter
    def lattices(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None: ...
    @property
    def longest_time(self) -> float: ...
    @longest_time.setter
    def longest_time(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def mass(self) -> float: ...
    @mass.setter
    def mass(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def shortest_time(self) -> float: ...
    @shortest_time.setter
    def shortest_time(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def spectrum_tolerance(self) -> float: ...
    @spectrum_tolerance.setter
    def spectrum_tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def steps_per_spacing(self) -> int | None: ...
    @steps_per_spacing.setter
    def steps_per_spacing(self, arg0: typing.SupportsInt | typing.SupportsIndex | None) -> None: ...
    @property
    def threads(self) -> int: ...
    @threads.setter
    def threads(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None: ...

class RollingInstant:
    @property
    def angle(self) -> float:
        """
        angle turned ψ, forward [rad]. The contact moves r_o ψ along the track if nothing slips.
        """
    @property
    def center_speed(self) -> float:
        """
        speed of the center [m/s]. Without mass it is the mean over the previous step.
        """
    @property
    def center_way(self) -> float:
        """
        distance traveled by the center since the start [m]. 0 without friction, where it is undetermined.
        """
    @property
    def contact_area(self) -> float:
        """
        contact area [m^2].
        """
    @property
    def counterpart_dissipated_energy(self) -> float:
        """
        energy dissipated in the counterbody since the start [J]. Part of `dissipated_energy`; includes the energy still stored where the track is no longer followed.
        """
    @property
    def counterpart_stored_energy(self) -> float:
        """
        energy stored in the counterbody [J]. Part of `stored_energy`.
        """
    @property
    def dissipated_energy(self) -> float:
        """
        energy dissipated in both bodies and by slip since the start [J]. Computed from the material's memory and from slip, independently of the torque.
        """
    @property
    def driving_force(self) -> float:
        """
        driving force Q [N]. Forward force on the center, minus mass times acceleration. On a rigid plane it is -Σ t_x; a deformable counterbody adds the pressure along its deformed surface, which gives M / r_o for a rigid body on a plane.
        """
    @property
    def driving_torque(self) -> float:
        """
        driving torque T [N m]. Moment of the contact forces about the center of the rolling body. On a rigid plane it does the work, and it equals T_r with the radial compliance. It is 0 for a rigid body on a deformable counterbody; if both deform, it is the share of the rolling body.
        """
    @property
    def energy_imbalance(self) -> float:
        """
        work minus stored and dissipated energy [J].
        """
    @property
    def error_estimate(self) -> float:
        """
        error estimate of the torque [N m]. Standard error of `resisting_torque`, from its spread over the lattices; not a number with one lattice.
        """
    @property
    def load(self) -> float:
        """
        load P [N].
        """
    @property
    def max_pressure(self) -> float:
        """
        largest contact pressure [Pa].
        """
    @property
    def penetration(self) -> float:
        """
        approach of the bodies, r_o - H [m]. Not a number on a half-plane, where the approach is undetermined.
        """
    @property
    def resisting_torque(self) -> float:
        """
        resisting torque T_r, offset of the pressure times P [N m]. T_r = Σ x p, whichever body deforms. T_r / R is the resisting force, where 1/R is the sum of the curvatures along the path. A negative value drives the body. After a stop it keeps the body from rolling back.
        """
    @property
    def semi_axis_x(self) -> float:
        """
        contact semi-axis along x [m]. Semi-axis of the ellipse with the same second moments as the contact; half of the width in line contact.
        """
    @property
    def semi_axis_z(self) -> float:
        """
        contact semi-axis along z [m]. Semi-axis of the ellipse with the same second moments as the contact; not a number in line contact.
        """
    @property
    def slip_energy(self) -> float:
        """
        energy dissipated by slip since the start [J]. Part of `dissipated_energy`.
        """
    @property
    def stick_share(self) -> float:
        """
        share of the contact nodes that stick [1]. 0 without friction.
        """
    @property
    def stored_energy(self) -> float:
        """
        energy stored in both bodies [J]. On a half-plane energies and work are known up to a constant while the load is constant.
        """
    @property
    def time(self) -> float:
        """
        time [s]. Two equal values mark a jump.
        """
    @property
    def work(self) -> float:
        """
        work of rolling and load since the start [J]. Integrated by the trapezoidal rule; a jump does the work that it stores.
        """

class InstantSeries:
    @property
    def angle(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        angle turned ψ, forward [rad]. The contact moves r_o ψ along the track if nothing slips.
        """
    @property
    def center_speed(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        speed of the center [m/s]. Without mass it is the mean over the previous step.
        """
    @property
    def center_way(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        distance traveled by the center since the start [m]. 0 without friction, where it is undetermined.
        """
    @property
    def contact_area(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        contact area [m^2].
        """
    @property
    def counterpart_dissipated_energy(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        energy dissipated in the counterbody since the start [J]. Part of `dissipated_energy`; includes the energy still stored where the track is no longer followed.
        """
    @property
    def counterpart_stored_energy(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        energy stored in the counterbody [J]. Part of `stored_energy`.
        """
    @property
    def dissipated_energy(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        energy dissipated in both bodies and by slip since the start [J]. Computed from the material's memory and from slip, independently of the torque.
        """
    @property
    def driving_force(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        driving force Q [N]. Forward force on the center, minus mass times acceleration. On a rigid plane it is -Σ t_x; a deformable counterbody adds the pressure along its deformed surface, which gives M / r_o for a rigid body on a plane.
        """
    @property
    def driving_torque(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        driving torque T [N m]. Moment of the contact forces about the center of the rolling body. On a rigid plane it does the work, and it equals T_r with the radial compliance. It is 0 for a rigid body on a deformable counterbody; if both deform, it is the share of the rolling body.
        """
    @property
    def energy_imbalance(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        work minus stored and dissipated energy [J].
        """
    @property
    def error_estimate(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        error estimate of the torque [N m]. Standard error of `resisting_torque`, from its spread over the lattices; not a number with one lattice.
        """
    @property
    def load(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        load P [N].
        """
    @property
    def max_pressure(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        largest contact pressure [Pa].
        """
    @property
    def penetration(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        approach of the bodies, r_o - H [m]. Not a number on a half-plane, where the approach is undetermined.
        """
    @property
    def resisting_torque(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        resisting torque T_r, offset of the pressure times P [N m]. T_r = Σ x p, whichever body deforms. T_r / R is the resisting force, where 1/R is the sum of the curvatures along the path. A negative value drives the body. After a stop it keeps the body from rolling back.
        """
    @property
    def semi_axis_x(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        contact semi-axis along x [m]. Semi-axis of the ellipse with the same second moments as the contact; half of the width in line contact.
        """
    @property
    def semi_axis_z(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        contact semi-axis along z [m]. Semi-axis of the ellipse with the same second moments as the contact; not a number in line contact.
        """
    @property
    def slip_energy(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        energy dissipated by slip since the start [J]. Part of `dissipated_energy`.
        """
    @property
    def stick_share(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        share of the contact nodes that stick [1]. 0 without friction.
        """
    @property
    def stored_energy(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        energy stored in both bodies [J]. On a half-plane energies and work are known up to a constant while the load is constant.
        """
    @property
    def time(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        time [s]. Two equal values mark a jump.
        """
    @property
    def work(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        work of rolling and load since the start [J]. Integrated by the trapezoidal rule; a jump does the work that it stores.
        """

class ContactField:
    @property
    def pressure(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def time(self) -> float: ...
    @property
    def x(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def z(self) -> numpy.typing.NDArray[numpy.float64]: ...

class RollingHistory:
    @typing.overload
    def __init__(
        self,
        body: CoatedSphere | CoatedCylinder | CoatedWheel,
        on: CoatedPlane | CoatedCylinder | Groove | CoatedSphere | CoatedWheel,
        *,
        load: typing.SupportsFloat | typing.SupportsIndex,
        start: Start,
        options: HistoryOptions,
        time: typing.SupportsFloat | typing.SupportsIndex,
        angle: typing.SupportsFloat | typing.SupportsIndex,
        progress: typing.Any,
    ) -> None: ...
    @typing.overload
    def __init__(
        self,
        body: CoatedSphere | CoatedCylinder | CoatedWheel,
        on: CoatedPlane | CoatedCylinder | Groove | CoatedSphere | CoatedWheel,
        *,
        load: typing.SupportsFloat | typing.SupportsIndex,
        state: numpy.typing.NDArray[numpy.float64],
        options: HistoryOptions,
        progress: typing.Any,
    ) -> None: ...
    def advance(
        self,
        *,
        time: typing.SupportsFloat | typing.SupportsIndex,
        angle: typing.SupportsFloat | typing.SupportsIndex,
        load: typing.SupportsFloat | typing.SupportsIndex,
        center_way: typing.SupportsFloat | typing.SupportsIndex | None,
    ) -> None: ...
    def contact(self) -> ContactField: ...
    def copy(self) -> RollingHistory: ...
    def now(self) -> RollingInstant: ...
    def roll(
        self,
        *,
        time: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        angle: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        load: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        center_way: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        progress: typing.Any,
    ) -> InstantSeries: ...
    def state(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def mesh(self) -> Mesh: ...
    @property
    def spectrum_error(self) -> float: ...
    @property
    def steps(self) -> int: ...

class RollingResistance:
    def __init__(
        self,
        *,
        load: typing.Annotated[collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex], "FixedSize(2)"],
        angular_speed: typing.Annotated[
            collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex], "FixedSize(2)"
        ],
        radius: typing.SupportsFloat | typing.SupportsIndex,
        coefficients: collections.abc.Sequence[collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex]],
        error: typing.SupportsFloat | typing.SupportsIndex,
        largest_error: typing.SupportsFloat | typing.SupportsIndex,
    ) -> None: ...
    def torques(
        self,
        load: numpy.typing.NDArray[numpy.float64],
        angular_speed: numpy.typing.NDArray[numpy.float64],
        outside: Extrapolation,
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def angular_speed(self) -> typing.Annotated[list[float], "FixedSize(2)"]: ...
    @property
    def coefficients(self) -> list[list[float]]: ...
    @property
    def error(self) -> float: ...
    @property
    def largest_error(self) -> float: ...
    @property
    def load(self) -> typing.Annotated[list[float], "FixedSize(2)"]: ...
    @property
    def radius(self) -> float: ...

def centrifugal_displacement(
    sphere: CoatedSphere, *, angular_speed: typing.SupportsFloat | typing.SupportsIndex
) -> float: ...
def check_motion(
    *,
    time: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
    angle: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
    load: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
    center_way: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
) -> None: ...
def complex_modulus(
    modulus: Elastic | Prony | KelvinVoigt | FractionalZener | MasterCurve | CustomModulus,
    omega: numpy.typing.NDArray[numpy.float64],
) -> numpy.typing.NDArray[numpy.complex128]: ...
def core_count() -> int:
    """
    Cores that this process may use.
    """

@typing.overload
def critical_speed(
    sphere: CoatedSphere, *, highest_frequency: typing.SupportsFloat | typing.SupportsIndex, curvature: Curvature
) -> float: ...
@typing.overload
def critical_speed(
    cylinder: CoatedCylinder, *, highest_frequency: typing.SupportsFloat | typing.SupportsIndex
) -> float: ...
@typing.overload
def critical_speed(wheel: CoatedWheel, *, highest_frequency: typing.SupportsFloat | typing.SupportsIndex) -> float: ...
def degree_compliance(
    sphere: CoatedSphere,
    degree: numpy.typing.NDArray[numpy.int32],
    order: numpy.typing.NDArray[numpy.int32],
    *,
    angular_speed: typing.SupportsFloat | typing.SupportsIndex,
) -> numpy.typing.NDArray[numpy.complex128]: ...
def history_scalars() -> list[ScalarDescription]:
    """
    Descriptions of the scalars of a history, in SI units.
    """

def influence_tables(
    sphere: CoatedSphere,
    mesh: Mesh,
    *,
    angular_speed: typing.SupportsFloat | typing.SupportsIndex,
    phi_reach: typing.SupportsInt | typing.SupportsIndex,
    theta_reach: typing.SupportsInt | typing.SupportsIndex,
    threads: typing.SupportsInt | typing.SupportsIndex,
    curvature: Curvature,
    progress: typing.Any,
) -> numpy.typing.NDArray[numpy.float64]: ...
def interior_fields(
    shape: CoatedSphere | CoatedCylinder | CoatedPlane | CoatedWheel,
    tractions: Tractions,
    *,
    position: numpy.typing.NDArray[numpy.float64],
    layer: numpy.typing.NDArray[numpy.int32],
    phi: numpy.typing.NDArray[numpy.float64],
    theta: numpy.typing.NDArray[numpy.float64],
    angular_speed: typing.SupportsFloat | typing.SupportsIndex,
    max_order: typing.SupportsFloat | typing.SupportsIndex | None,
    threads: typing.SupportsInt | typing.SupportsIndex,
    progress: typing.Any,
) -> numpy.typing.NDArray[numpy.float64]: ...
def loss_density(
    shape: CoatedSphere | CoatedCylinder | CoatedPlane | CoatedWheel,
    tractions: Tractions,
    *,
    position: numpy.typing.NDArray[numpy.float64],
    layer: numpy.typing.NDArray[numpy.int32],
    angular_speed: typing.SupportsFloat | typing.SupportsIndex,
    max_order: typing.SupportsInt | typing.SupportsIndex,
    threads: typing.SupportsInt | typing.SupportsIndex,
    progress: typing.Any,
) -> LossDensity: ...
def order_fields(
    shape: CoatedSphere | CoatedCylinder | CoatedPlane | CoatedWheel,
    m: numpy.typing.NDArray[numpy.int32],
    n: numpy.typing.NDArray[numpy.int32],
    *,
    position: numpy.typing.NDArray[numpy.float64],
    layer: numpy.typing.NDArray[numpy.int32],
    angular_speed: typing.SupportsFloat | typing.SupportsIndex,
    radius: typing.SupportsFloat | typing.SupportsIndex,
    curvature: Curvature,
) -> numpy.typing.NDArray[numpy.complex128]: ...
def places_at(
    shape: CoatedSphere | CoatedCylinder | CoatedPlane | CoatedWheel, position: numpy.typing.NDArray[numpy.float64]
) -> tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.int32]]: ...
def result_scalars() -> list[ScalarDescription]:
    """
    What the scalar results are, in SI units.
    """

def solve(
    body: CoatedSphere | CoatedCylinder | CoatedWheel,
    on: CoatedPlane | CoatedCylinder | Groove | CoatedSphere | CoatedWheel,
    *,
    load: typing.SupportsFloat | typing.SupportsIndex,
    angular_speed: typing.SupportsFloat | typing.SupportsIndex,
    mesh: Mesh | None,
    accuracy: typing.SupportsFloat | typing.SupportsIndex,
    friction: typing.SupportsFloat | typing.SupportsIndex,
    drive: DriveForce | DriveTorque | DriveCreepage,
    compliance: Compliance,
    curvature: Curvature,
    patch_load: PatchLoad,
    slip_kinematics: SlipKinematics,
    max_iterations: typing.SupportsInt | typing.SupportsIndex,
    threads: typing.SupportsInt | typing.SupportsIndex,
    progress: typing.Any,
) -> Result: ...
def solve_kept(
    body: CoatedSphere | CoatedCylinder | CoatedWheel,
    on: CoatedPlane | CoatedCylinder | Groove | CoatedSphere | CoatedWheel,
    *,
    load: typing.SupportsFloat | typing.SupportsIndex,
    angular_speed: typing.SupportsFloat | typing.SupportsIndex,
    mesh: Mesh,
    friction: typing.SupportsFloat | typing.SupportsIndex,
    drive: DriveForce | DriveTorque | DriveCreepage,
    compliance: Compliance,
    curvature: Curvature,
    patch_load: PatchLoad,
    contact: numpy.typing.NDArray[numpy.uint8],
    stick: numpy.typing.NDArray[numpy.uint8],
    pressure: numpy.typing.NDArray[numpy.float64],
    shear_traction: numpy.typing.NDArray[numpy.float64],
    penetration: typing.SupportsFloat | typing.SupportsIndex,
    creepage: typing.SupportsFloat | typing.SupportsIndex,
    threads: typing.SupportsInt | typing.SupportsIndex,
    progress: typing.Any,
) -> Result: ...
def standard_linear_solid(
    *,
    instantaneous_modulus: typing.SupportsFloat | typing.SupportsIndex,
    relaxed_modulus: typing.SupportsFloat | typing.SupportsIndex,
    relaxation_time: typing.SupportsFloat | typing.SupportsIndex,
) -> Prony: ...
def state_matrix(
    layer: Layer,
    *,
    angular_speed: typing.SupportsFloat | typing.SupportsIndex,
    radius: typing.SupportsFloat | typing.SupportsIndex,
    m: typing.SupportsInt | typing.SupportsIndex,
    n: typing.SupportsInt | typing.SupportsIndex,
    curvature: Curvature,
) -> numpy.typing.NDArray[numpy.complex128]: ...
@typing.overload
def surface_compliance(
    sphere: CoatedSphere,
    m: numpy.typing.NDArray[numpy.int32],
    n: numpy.typing.NDArray[numpy.int32],
    *,
    angular_speed: typing.SupportsFloat | typing.SupportsIndex,
    curvature: Curvature,
) -> numpy.typing.NDArray[numpy.complex128]: ...
@typing.overload
def surface_compliance(
    wheel: CoatedWheel,
    m: numpy.typing.NDArray[numpy.int32],
    k: numpy.typing.NDArray[numpy.float64],
    *,
    angular_speed: typing.SupportsFloat | typing.SupportsIndex,
) -> numpy.typing.NDArray[numpy.complex128]: ...
def validate_modulus(
    modulus: Elastic | Prony | KelvinVoigt | FractionalZener | MasterCurve | CustomModulus,
) -> None: ...

__commit__: str
__fft__: str
__version__: str
