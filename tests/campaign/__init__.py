"""Randomized tests: many small solves over wide ranges of all inputs, checked for relations that always hold.

``python -m tests.campaign --cases 2000 --seed 1 --jobs 2``
"""
