"""Damaged files: each input file, mutated at random, must be rejected clearly or read without loss.

``python -m tests.campaign.files --count 20000 --seed 1 --jobs 2``
"""
