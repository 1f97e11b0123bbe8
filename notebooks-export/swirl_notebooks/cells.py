"""Cells from a Python file in the percent format (`# %% [markdown]`, `# %%`), as a notebook that has been executed."""

import os
import queue
import re
import threading

MARK = "made by swirl notebook"

#: What executing needs beyond what a figure does.
PACKAGES = "python3-nbformat python3-nbclient python3-ipykernel"

_HEAD = re.compile(r"^# %%(?: \[(\w+)\])?\s*$", re.M)


def cells_of(text):
    """[(kind, source)]: kind is `code`, `markdown`, or another word in brackets."""
    parts = _HEAD.split(text)
    cells = []
    for kind, source in zip(parts[1::2], parts[2::2]):
        if kind is not None:  # its lines are comments
            source = re.sub(r"^# ?", "", source.strip("\n"), flags=re.M)
        cells.append((kind or "code", source.strip("\n")))
    return cells


def notebook_of(cells, title):
    """A notebook, not executed; equal cells give equal notebooks."""
    import nbformat
    book = nbformat.v4.new_notebook()
    for number, (kind, source) in enumerate(cells):
        make = nbformat.v4.new_markdown_cell if kind == "markdown" else nbformat.v4.new_code_cell
        cell = make(source)
        cell["id"] = f"cell-{number}"
        if kind == "data":
            cell.metadata["jupyter"] = {"source_hidden": True}
        book.cells.append(cell)
    book.metadata.update({"title": title, "origin": MARK,
                          "kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}})
    return book


class CellFailed(Exception):
    """A cell that raised, in one line."""


def executed(book, folder, timeout=120):
    """Executes the cells in `folder`. CellFailed where one raises."""
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError
    client = NotebookClient(book, timeout=timeout, kernel_name="python3", record_timing=False,
                            resources={"metadata": {"path": str(folder)}})
    client._cleanup_kernel = lambda: None  # at the exit it would wait for a kernel that an interruption has ended
    try:
        os.environ.setdefault("PYDEVD_DISABLE_FILE_VALIDATION", "1")  # the kernel's debugger, which nobody asked for, warns
        _in_thread(client, client.execute)
    except (CellExecutionError, CellTimeoutError, DeadKernelError) as error:
        raise CellFailed(" ".join(re.sub(r"\x1b\[[0-9;]*m", "", str(error)).split())[-300:]) from error
    return book


def _in_thread(client, work):
    """work() in a thread of its own, so that interruptions stay with the main one (nbclient would take them); an
    exception there, such as an interruption's, ends the kernel."""
    outcome = queue.Queue()

    def run():
        try:
            work()
            outcome.put(None)
        except BaseException as error:
            outcome.put(error)
    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    try:
        while thread.is_alive():
            thread.join(0.1)
    except BaseException:
        _end_kernel(client)
        raise
    error = outcome.get()
    if error is not None:
        raise error


def _end_kernel(client):
    process = getattr(getattr(client.km, "provisioner", None), "process", None)
    if process is not None:
        process.kill()
        client.km.cleanup_connection_file()


def printed(book):
    """What the code cells printed, one text a cell."""
    texts = []
    for cell in book.cells:
        if cell.cell_type == "code":
            texts.append("".join(output["text"] for output in cell.outputs if output.output_type == "stream"))
    return texts


def as_bytes(book):
    import nbformat
    return (nbformat.writes(book) + "\n").encode()
