"""Cases, studies and motions in TOML files, and what is done with a case (the extra `viscoroll[cli]`)."""

from .case import Case, build_case, example_text, load_case

__all__ = ["Case", "build_case", "example_text", "load_case"]
