"""Tables and figures of the paper, computed, drawn and judged (the extras `viscoroll[plot,studies]`)."""

from .convergence import compute_table2
from .item import Item, Outcome, Runner, Verdict, write_files
from .radial import compute_figure4

__all__ = ["ITEMS", "Item", "Outcome", "Runner", "Verdict", "write_files"]

#: All items, by name, in the order of the paper.
ITEMS = {
    item.name: item
    for item in (
        Item(name="table2", title="convergence with mesh and truncation", compute=compute_table2),
        Item(name="figure4", title="radial sub-intervals", compute=compute_figure4),
    )
}
