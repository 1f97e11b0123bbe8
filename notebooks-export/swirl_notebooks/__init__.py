"""Notebooks of Swirl's records: made from cells in Python files, executed, and free of everything of Swirl's."""
