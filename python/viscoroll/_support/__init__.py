"""Code shared by the whole package: arguments, texts, tables, pictures, files. It does not depend on bodies."""
