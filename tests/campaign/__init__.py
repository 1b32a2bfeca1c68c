"""Random campaign: many small solves over wide ranges of everything, held against what must be true of any of them.

``python -m tests.campaign --cases 2000 --seed 1 --jobs 2``
"""
