"""Published benchmarks solved by the library, for docs/published-results.md and its tests.

Each source has a module; `rows` reads the table of published and computed numbers, and `pictures` draws the figure:
`python -m tests.published.pictures`.
"""
