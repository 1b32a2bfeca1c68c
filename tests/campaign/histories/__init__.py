"""Random histories: starts, stops, reversals, jumps and lifts of any pair, held against what must be true of any.

``python -m tests.campaign.histories --cases 300 --seed 1``
"""
