"""Self-heating: steady states in which moduli and temperature depend on each other.

The moduli of layer j are those at its temperature T_j, μ*(a_T(T_j) ω). The unknown is the mean temperature T̄, weighted
by the loss. A given T̄ determines the moduli, and with them torque, loss and the rise ΔT. A steady state is a root of
excess(T̄) = ambient + ΔT - T̄. The excess is a single-valued function of T̄, also near folds, so a sweep of T̄ finds
every state. At a given T̄ the heat increases with speed and with load; there is thus one speed for a given load, and
one load for a given speed. The cold state ends at the first maximum of this speed or load as a function of T̄.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .._support.arguments import as_count, as_float, as_int, as_kelvin, require_type
from .._support.errors import InvalidInput, InvalidType
from .._support.extras import extra
from .._support.progress import ProgressLike, counted, reporting
from .._support.result_warnings import silenced, warn
from .._support.tables import handy, html_table, number_text
from ..bodies import RollingBody
from ..materials.shift import Shift
from ..rolling.steady import solved_speed
from ..thermal.temperature import QUANTITIES, Core, temperature_warnings
from .softening_result import NetworkLoss, as_network_loss
from .steady_states import Fold, StateSearch, SteadyState

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure
    from numpy.typing import NDArray


__all__ = ["SelfHeating", "self_heating"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class SelfHeating:
    """All steady states of a load case, with methods for the speeds and loads of other steady states.

    Attributes
    ----------
    states : tuple of SteadyState
        States from cold to hot. If there are several, the initial state determines which one is reached; a cold start
        leads to the coldest.
    angular_speed : float
        Angular speed Ω [rad/s].
    limit : float
        Highest mean temperature of the search [K].
    """

    states: tuple[SteadyState, ...]
    angular_speed: float
    limit: float
    _search: StateSearch

    def __repr__(self) -> str:
        """Return the states, one per line."""
        return "\n".join([f"SelfHeating at Ω = {self.angular_speed:g} rad/s:", *(f"  {s}" for s in self.states)])

    def _repr_html_(self) -> str:
        """Return the states with units, one per column, as a table for notebooks."""
        torque_unit, coldest = self.states[0].result.unit("resisting_torque"), self.states[0].temperature
        rows = [
            ("steady state", *("stable" if state.stable else "unstable" for state in self.states), ""),
            ("mean temperature of the layers", *(number_text(state.mean_temperature) for state in self.states), "K"),
            self._row("resisting torque T_r", [state.result.resisting_torque for state in self.states], torque_unit),
            *(
                self._row(text, [getattr(state.temperature, name) for state in self.states], coldest.unit(name))
                for name, (_, text) in QUANTITIES.items()
            ),
        ]
        return html_table(f"Self-heating at Ω = {self.angular_speed:g} rad/s", rows)

    @staticmethod
    def _row(label: str, values: list[float], unit: str) -> tuple[str, ...]:
        texts, readable = handy(values, unit)
        return (label, *texts, readable)

    def speeds(self, temperatures: Sequence[float], *, progress: ProgressLike = None) -> NDArray[np.float64]:
        """Return the speeds at which given mean temperatures are steady states.

        Parameters
        ----------
        temperatures : sequence of float
            Mean temperatures [K], above that of the surroundings.
        progress : bool or callable, optional
            True shows a progress bar; a callable is called as progress(stage, fraction) after every temperature.

        Returns
        -------
        ndarray
            Angular speeds Ω [rad/s]. Above the largest of them there is no steady state with one of these temperatures.

        Raises
        ------
        ValueError
            If a temperature is not above that of the surroundings.
        ConvergenceError
            If the search finds no speed with a steady state at a temperature.
        """
        return self._values_at(temperatures, self._search.speed_at, progress)

    def loads(self, temperatures: Sequence[float], *, progress: ProgressLike = None) -> NDArray[np.float64]:
        """Return the loads at which given mean temperatures are steady states, at this speed.

        Parameters
        ----------
        temperatures, progress
            Same as in `speeds`.

        Returns
        -------
        ndarray
            Loads [N], for rollers [N/m].

        Raises
        ------
        ValueError
            If a temperature is not above that of the surroundings, or requires a load that the layers cannot support.
        ConvergenceError
            If the search finds no load with a steady state at a temperature.
        """
        return self._values_at(temperatures, self._search.load_at, progress)

    def largest_load(self) -> Fold | None:
        """Return the load at which the cold state ends, at this speed; above it the temperature runs away.

        Returns
        -------
        Fold or None
            None if the cold state does not end below the `limit`, or before the load exceeds what the layers support.
        """
        return self._search.fold("load")

    def largest_speed(self) -> Fold | None:
        """Return the speed at which the cold state ends, at this load; None in the same cases as `largest_load`."""
        return self._search.fold("speed")

    def plot(self, *, points: int = 10) -> Figure:
        """Draw the mean temperatures of the steady states over load and over speed, with the states of the given case.

        The cold state ends at the first maximum of load or speed.

        Parameters
        ----------
        points : int, default 10
            Number of points of each curve; each point takes several contact solutions.

        Returns
        -------
        matplotlib.figure.Figure
            New figure without a window.

        Raises
        ------
        ImportError
            If the extra `viscoroll[plot]` is missing.
        """
        from .folds_picture import plot_folds

        return plot_folds(
            self.states, self.limit, as_int("points", points), self._search.load_at, self._search.speed_at
        )

    @staticmethod
    def _values_at(
        temperatures: Sequence[float], value_at: Callable[[float], float], progress: ProgressLike
    ) -> NDArray[np.float64]:
        found = []
        with counted(progress, total=len(temperatures), unit="temperature") as advance:
            for value in temperatures:
                found.append(value_at(as_float("temperatures", value)))
                advance()
        return np.array(found)


def self_heating(
    body: RollingBody,
    *,
    load: float,
    angular_speed: float | None = None,
    speed: float | None = None,
    convection: float | Callable[[NDArray[np.float64]], NDArray[np.float64]],
    ambient: float,
    shift: Shift | Sequence[Shift],
    vertical_shift: Shift | None = None,
    conductivity: float | Sequence[float] | None = None,
    core: Core | str | float = Core.INSULATED,
    core_temperature: float | None = None,
    width: float | None = None,
    side_convection: float | None = None,
    hub_conductance: float | None = None,
    limit: float | None = None,
    softening: NetworkLoss = "network",
    sublayers: int = 1,
    points: int = 24,
    progress: ProgressLike = None,
    **options: Any,
) -> SelfHeating:
    """Find all steady states of temperature and torque.

    Parameters
    ----------
    body : CoatedSphere or CoatedCylinder or CoatedWheel
        Rolling body, with moduli at the reference temperature of `shift`.
    load : float
        Load, same as in `solve`.
    angular_speed, speed : float, optional
        Angular speed, or speed of the ground instead of it, same as in `solve`.
    convection, ambient, conductivity, core, core_temperature, width, side_convection, hub_conductance
        Same as in `Result.temperature`.
    shift : callable or sequence of callable
        Shift factor a_T as a function of temperature [K], for all layers or for each layer: `WilliamsLandelFerry`,
        `Arrhenius` or any other.
    vertical_shift : callable, optional
        Factor b_T on all moduli as a function of temperature [K]; by default 1.
    limit : float, optional
        Highest mean temperature of the search [K], such as the highest that the material withstands; by default 150 K
        above the surroundings.
    softening : {"network", "harmonic"}, default "network"
        Loss of the filler network in layers with a `SofteningModulus`, same as `loss` in `strain_softening`. `shift`
        applies only to the matrix of such a modulus.
    sublayers : int, default 1
        Number of parts into which every layer is divided, in [1, 20]. Each part has its own temperature and strain
        amplitude.
    points : int, default 24
        Number of mean temperatures in the sweep from the surroundings to the limit, in [4, 1000]. The search finds a
        single state between neighboring temperatures to 1e-3 of the rise, but may miss a pair of states there.
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction) after every temperature.
    **options
        Options of `solve`: friction, drive, accuracy, mesh, compliance, and so on.

    Returns
    -------
    SelfHeating
        All steady states, stable and unstable.

    Raises
    ------
    ValueError
        If an argument is invalid, or there is no steady state below the limit; the message contains the largest speed
        that has one.
    TypeError
        If an argument has the wrong type.
    ImportError
        If the extra `viscoroll[studies]` is missing.

    Warns
    -----
    ResultWarning
        If there are several states.

    Notes
    -----
    A state is stable if R dP/dT < 1, with the dissipated power P and the thermal resistance R between layers and
    surroundings: the power then increases more slowly with temperature than the heat flow to the surroundings.

    Examples
    --------
    >>> import viscoroll as vr
    >>> from viscoroll import paper
    >>> hot = vr.self_heating(
    ...     paper.ball(), load=100.0, angular_speed=25.0, conductivity=0.2, convection=10.0, ambient=293.15,
    ...     shift=vr.materials.Arrhenius(activation_energy=60e3, reference_temperature=293.15),
    ...     mesh=vr.Mesh(nodes_per_revolution=400), points=6,
    ... )
    >>> [state.stable for state in hot.states]
    [True]
    """
    with extra("studies"):  # imported here to report a missing extra before the first contact is solved
        from scipy.optimize import brentq

    require_type("body", body, RollingBody)
    shifts = _shifts(body, shift)
    parts = as_count("sublayers", sublayers, 1, 20)
    count = as_count("points", points, 4, 1000)
    surroundings = as_kelvin("ambient", ambient)
    highest = surroundings + 150.0 if limit is None else as_float("limit", limit)
    if not highest > surroundings:
        raise InvalidInput("limit", f"must be > ambient = {surroundings:g} K", f"{highest:g} K")
    search = StateSearch(
        body=_with_sublayers(body, parts),
        shifts=[each for each in shifts for _ in range(parts)],
        vertical=vertical_shift,
        load=as_float("load", load),
        angular_speed=solved_speed(body, angular_speed, speed),
        ground_speed=speed,
        softening=as_network_loss("softening", softening),
        thermal={
            "conductivity": _repeated(conductivity, parts),
            "convection": convection,
            "ambient": surroundings,
            "core": core,
            "core_temperature": core_temperature,
            "width": width,
            "side_convection": side_convection,
            "hub_conductance": hub_conductance,
        },
        options=options,
        ambient=surroundings,
        limit=highest,
        find_root=brentq,
        points={},
    )
    with silenced(), reporting(progress) as report:
        brackets, exact = search.sweep(count, report)
        states = tuple(search.state(*bracket) for bracket in brackets) + tuple(search.state(t, t) for t in exact)
        if not states:
            raise ValueError(search.no_state_message())
    found = SelfHeating(states=states, angular_speed=search.angular_speed, limit=highest, _search=search)
    if len(states) > 1:
        temperatures = ", ".join(f"{s.mean_temperature:.1f} K ({'' if s.stable else 'un'}stable)" for s in states)
        warn([f"{len(states)} steady states: {temperatures}; a cold start reaches the coldest"])
    warn(temperature_warnings(states[0].temperature))
    return found


def _shifts(body: RollingBody, shift: Shift | Sequence[Shift]) -> list[Shift]:
    if callable(shift):
        return [shift] * len(body.layers)
    try:
        several = list(shift)
    except TypeError:
        raise InvalidType("shift", "must be a function of temperature [K], or one for each layer") from None
    if len(several) != len(body.layers):
        raise InvalidInput("shift", f"must have one function for each of {len(body.layers)} layers", len(several))
    for each in several:
        if not callable(each):
            raise InvalidType("shift", "must be a function of temperature [K], or one for each layer")
    return several


def _with_sublayers(body: RollingBody, parts: int) -> RollingBody:
    if parts == 1:
        return body
    layers = [replace(layer, thickness=layer.thickness / parts) for layer in body.layers for _ in range(parts)]
    return replace(body, layers=layers)


def _repeated(conductivity: float | Sequence[float] | None, parts: int) -> float | list[float] | None:
    if conductivity is None or np.ndim(conductivity) == 0:
        return conductivity  # type: ignore[return-value]
    return [value for value in conductivity for _ in range(parts)]  # type: ignore[union-attr]
