"""Uneven ground, treads, and the axle of a body that rolls over them.

    >>> import viscoroll as vr
    >>> bump = vr.ground.Profile.half_sine(0.2e-3, length=10e-3, at=20e-3)
    >>> mesh = vr.Mesh(nodes_per_revolution=200)
    >>> motion = {"time": [0.0, 0.4], "distance": [0.0, 40e-3], "load": 100.0}
    >>> h = vr.roll(vr.paper.ball(), **motion, ground=bump, mesh=mesh, averaged_meshes=1)
    >>> f"largest torque on the bump {h.resisting_torque[h.distance > 10e-3].max() * 1e3:.0f} mN m"
    'largest torque on the bump 102 mN m'

`Profile` describes the height of the ground along the track, and that of a tread around the body. `Axle` is the mass,
spring and damper between the body and a frame. Both are options of `viscoroll.roll` and `viscoroll.RollingHistory`.
"""

from .axle import Axle
from .profile import Profile

__all__ = ["Axle", "Profile"]
