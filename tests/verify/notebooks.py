# SPDX-License-Identifier: GPL-3.0-or-later
"""Executes notebooks and stores their pictures for inspection.

usage: notebooks.py FOLDER NOTEBOOK...

Each notebook has its own folder in FOLDER.
"""
import base64
import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient

for path in map(Path, sys.argv[2:]):
    notebook = nbformat.read(path, as_version=4)
    for cell in notebook.cells:
        assert not cell.get("outputs"), f"{path}: has outputs stored"
    folder = Path(sys.argv[1]) / path.stem
    folder.mkdir(parents=True, exist_ok=True)
    client = NotebookClient(notebook, timeout=600, kernel_name="python3",
                            resources={"metadata": {"path": str(folder)}})
    client.execute()
    pictures = 0
    for k, cell in enumerate(notebook.cells):
        for output in cell.get("outputs", []):
            assert output.get("name") != "stderr" or \
                "OverrollWarning" in output.text, output
            data = output.get("data", {})
            if "image/png" in data:
                pictures += 1
                (folder / f"cell_{k:02}.png").write_bytes(
                    base64.b64decode(data["image/png"]))
    nbformat.write(notebook, folder / path.name)
    print(f"{path.stem}: {len(notebook.cells)} cells, {pictures} pictures")
    assert pictures, f"{path}: no picture"
