"""Random histories of any pair with starts, stops, reversals, jumps and lifts, checked for relations that always hold.

``python -m tests.campaign.histories --cases 300 --seed 1``
"""
