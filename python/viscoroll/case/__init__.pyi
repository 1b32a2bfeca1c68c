from .case import Case, build_case, example_text, load_case

__all__ = ["Case", "build_case", "example_text", "load_case"]
