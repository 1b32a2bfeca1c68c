"""Cases, studies and motions in TOML files, and computations with a case (the extra `viscoroll[cli]`)."""

from .case import Case, build_case, example_text, load_case

__all__ = ["Case", "build_case", "example_text", "load_case"]
