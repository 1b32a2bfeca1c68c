"""What all of the package shares: arguments, texts, tables, pictures, files; it knows no ball and no layer."""
