"""Tables and figures of the paper, computed, plotted and compared (requires the extras `viscoroll[plot,studies]`)."""

from .convergence import compute_table2
from .friction import compute_figure9
from .inertia import compute_figure13
from .item import Item, Outcome, Runner, Verdict, write_files, write_verdicts
from .load import compute_figure10, compute_table3
from .radial import compute_figure4
from .sigmoid import compute_table4
from .speed import compute_figure7, compute_figure12
from .start import compute_figure6, compute_figure8
from .thickness import compute_figure11

__all__ = ["ITEMS", "Item", "Outcome", "Runner", "Verdict", "write_files", "write_verdicts"]

#: All tables and figures by name, in the order of the paper.
ITEMS = {
    item.name: item
    for item in (
        Item(name="table2", title="convergence with mesh and truncation", compute=compute_table2),
        Item(name="figure4", title="radial sub-intervals", compute=compute_figure4),
        Item(name="figure6", title="sudden starts", compute=compute_figure6),
        Item(name="figure7", title="torque against speed", compute=compute_figure7),
        Item(name="figure8", title="sudden starts with friction", compute=compute_figure8),
        Item(name="figure9", title="surface friction", compute=compute_figure9),
        Item(name="table3", title="power laws of the load", compute=compute_table3),
        Item(name="figure10", title="torque against load", compute=compute_figure10),
        Item(name="table4", title="laws of the thickness", compute=compute_table4),
        Item(name="figure11", title="torque against thickness", compute=compute_figure11),
        Item(name="figure12", title="torque against speed, many loads", compute=compute_figure12),
        Item(name="figure13", title="inertia", compute=compute_figure13),
    )
}
