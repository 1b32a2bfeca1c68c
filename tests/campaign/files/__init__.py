"""Damaged files: each file that the program reads, mutated at random, must be refused clearly or read without loss.

``python -m tests.campaign.files --count 20000 --seed 1 --jobs 2``
"""
