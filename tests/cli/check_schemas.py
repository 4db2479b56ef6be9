#!/usr/bin/env python3
"""Holds what the command line writes against the JSON schemas of resources/schemas.

usage: check_schemas.py LODESTONE_CLI SOURCE_FOLDER
Exit status 77 (skipped) without the Python package jsonschema.
"""
import copy
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    from jsonschema import Draft7Validator
except ImportError:
    print("python3-jsonschema is not installed: skipped")
    sys.exit(77)

CLI = sys.argv[1]
SOURCE = pathlib.Path(sys.argv[2])
TOWN = str(SOURCE / "resources/sample/town.city.json")


def run(*arguments):
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit(f"{' '.join(map(str, arguments))}: exit status {done.returncode}\n{done.stderr}")


def errors(schema, document):
    return [f"/{'/'.join(map(str, e.absolute_path))}: {e.message}"
            for e in Draft7Validator(schema).iter_errors(document)]


def check(name, path):
    """True when the document fits its schema, and the schema notices each required property that is missing."""
    schema = json.loads((SOURCE / f"resources/schemas/{name}.json").read_text())
    Draft7Validator.check_schema(schema)
    document = json.loads(path.read_text())
    found = errors(schema, document)
    for message in found[:10]:
        print(f"{path.name} against {name}.json {message}")
    for key in schema["required"]:
        broken = copy.copy(document)
        del broken[key]
        if not errors(schema, broken):
            found.append(key)
            print(f"{name}.json does not notice that '{key}' is missing")
    print(f"{name}: {'ok' if not found else 'FAILED'}")
    return not found


def eye_and_target():
    """Somebody in the middle of the town's southern edge who looks north."""
    town = json.loads(pathlib.Path(TOWN).read_text())
    scale, move = town["transform"]["scale"], town["transform"]["translate"]
    xs, ys, zs = ([v[i] * scale[i] + move[i] for v in town["vertices"]] for i in range(3))
    middle, height = (min(xs) + max(xs)) / 2, min(zs) + 2
    return [f"{middle},{min(ys)},{height}", "--towards", f"{middle},{max(ys)},{height}"]


def main():
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder)
        report = out / "report.json"
        run("cluster", TOWN, "-o", out / "d.json", "--report", report)
        run("cut", TOWN, "-o", out / "cut.json", "--camera", "fit")
        run("fly", TOWN, "-o", out / "fly.csv", "--fps", "1", "--save-path", out / "path.json", "--report",
            out / "fly.json")
        run("fly", TOWN, "-o", out / "again.csv", "--fps", "1", "--path", out / "path.json")
        run("chain", TOWN, "-o", out / "chain", "--formats", "geojson", "--report", out / "chain.json")
        run("classify", TOWN, "-o", out / "classes.json")
        run("simplify", TOWN, "--rate", "0.3", "--a", "auto", "-o", out / "less.city.json", "--report",
            out / "simplify.json")
        run("visibility", TOWN, out / "less.city.json", "--street", "qem", "--viewpoint", *eye_and_target(),
            "-o", out / "visible.json", "--picture", out / "visible.png")
        run("perceive", TOWN, "--views", "2", "--size", "64x64", "-o", out / "perceived", "--report", out / "seen.json")
        run("compare", TOWN, out / "less.city.json", "--views", "2", "--size", "64", "-o", out / "compared", "--report",
            out / "compare.json")
        run("compare", out / "compared/view_00_a.png", out / "compared/view_00_b.png", "-o", out / "pictures")
        good = [check("dendrogram", out / "d.json"), check("cut", out / "cut.json"), check("report", report),
                check("path", out / "path.json"), check("report", out / "fly.json"),
                check("report", out / "chain.json"), check("recipe", out / "chain/recipe.json"),
                check("classification", out / "classes.json"), check("report", out / "simplify.json"),
                check("visibility", out / "visible.json"), check("views", out / "perceived/views.json"),
                check("perception", out / "perceived/triangles.json"), check("report", out / "seen.json"),
                check("comparison", out / "compared/comparison.json"),
                check("comparison", out / "pictures/comparison.json"), check("report", out / "compare.json")]
    sys.exit(0 if all(good) else 1)


main()
