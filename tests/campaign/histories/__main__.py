"""Command that runs many short random histories."""

import sys

from ..command import main
from .cases import draw
from .running import run_case

if __name__ == "__main__":
    sys.exit(main("python -m tests.campaign.histories", __doc__, "build/campaign-histories.jsonl", draw, run_case))
