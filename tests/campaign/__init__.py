"""Randomized tests: many small solves over wide ranges of all inputs, checked for relations that hold for any of them.

``python -m tests.campaign --cases 2000 --seed 1 --jobs 2``
"""
