"""Prints the folders of map/, analysis/ and apps/ as layers, and checks them: check_layers.py ROOT

A folder stands one layer above the highest folder that it includes, so that nothing includes upwards. Folders that
include each other in a circle have no layer: each circle is printed, and the exit code is 1; 2 if ROOT holds no sources.
A file beside folders (map/collision_map.hpp) is a room of its own. Every folder of map/ and analysis/, and each of apps/
that commands share, has its place in docs/architecture.svg, if ROOT has that picture.
"""

import sys
from pathlib import Path

from check_includes import FOLDERS, includes_of, source_files


def room_of(name):
    """The folder of a file, or, for a file that lies beside folders of its library, the file without its ending."""
    path = Path(name)
    return path.with_suffix("").as_posix() if path.parent.as_posix() in FOLDERS else path.parent.as_posix()


def room_graph(root):
    """{room: the rooms that its files include}, itself left out."""
    graph = {}
    for _, file in source_files(root):
        room = room_of(file.relative_to(root).as_posix())
        included = graph.setdefault(room, set())
        for _, bracket, name in includes_of(file):
            if bracket == '"' and name.split("/")[0] in FOLDERS and room_of(name) != room:
                included.add(room_of(name))
    return graph


def folders_of(root, graph):
    """The graph without files that are rooms of their own."""
    return {room: included for room, included in graph.items() if (root / room).is_dir()}


def layers_of(graph):
    """Lists of rooms from the lowest layer up, and the rooms that are left because they lie on or above a circle."""
    layers, placed, left = [], set(), set(graph)
    while left:
        layer = sorted(room for room in left if graph[room] <= placed)
        if not layer:
            break
        layers.append(layer)
        placed.update(layer)
        left.difference_update(layer)
    return layers, sorted(left)


def circle_in(graph, rooms):
    """One circle among rooms each of which includes another of them."""
    path = [rooms[0]]
    while path.count(path[-1]) == 1:
        path.append(min(graph[path[-1]] & set(rooms)))
    return path[path.index(path[-1]):]


def missing_in_picture(graph, picture):
    """The folders that a picture of the architecture should name and does not; a command's own folder is one of many."""
    shared = {room for room in graph if any(room in graph[other] for other in graph
                                            if other.startswith("apps/") and other != "apps/commands")}
    wanted = [room for room in graph if (room.startswith("apps/") and room in shared) or not room.startswith("apps/")]
    return [room for room in sorted(wanted) if room.count("/") and (room.split("/")[-1] + "/") not in picture]


def main(arguments):
    root = Path(arguments[0]) if len(arguments) == 1 else None
    graph = room_graph(root) if root else {}
    if not graph:  # a check of nothing must not pass
        print(f"usage: check_layers.py ROOT, with C++ files in {', '.join(FOLDERS)}", file=sys.stderr)
        return 2
    layers, left = layers_of(graph)
    for number, layer in reversed(list(enumerate(layers))):
        print(f"{number:3}  {'  '.join(layer)}")
    if left:
        print("a circle of folders:", " -> ".join(circle_in(graph, left)))
    picture = root / "docs" / "architecture.svg"
    missing = missing_in_picture(folders_of(root, graph), picture.read_text(encoding="utf-8")) if picture.exists() else []
    for room in missing:
        print(f"docs/architecture.svg does not show {room}/")
    return 1 if left or missing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
