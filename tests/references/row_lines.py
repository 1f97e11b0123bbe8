"""JSON with a row a line: an object in which no list of objects lies is written on one line."""

import json


def is_table(value):
    return isinstance(value, list) and any(isinstance(item, dict) for item in value)


def holds_table(value):
    return is_table(value) or isinstance(value, dict) and any(map(holds_table, value.values()))


def row_lines(value):
    """The text of a JSON value; json.loads gives the value back."""
    if is_table(value):
        return "[\n" + ",\n".join(map(row_lines, value)) + "\n]"
    if holds_table(value):
        return "{\n" + ",\n".join(f"{json.dumps(name)}: {row_lines(item)}" for name, item in value.items()) + "\n}"
    return json.dumps(value)
