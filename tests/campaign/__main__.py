"""Command that runs many small steady solves."""

import sys

from .cases import draw
from .command import main
from .runner import run_case

if __name__ == "__main__":
    sys.exit(main("python -m tests.campaign", __doc__, "build/campaign.jsonl", draw, run_case))
