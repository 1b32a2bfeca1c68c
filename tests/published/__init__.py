"""Published benchmarks, posed to the library: the contents of docs/published-results.md and their tests.

Each source has a module; `rows` is the table of both sides' numbers, and `pictures` draws the figure of the page:
`python -m tests.published.pictures`.
"""
