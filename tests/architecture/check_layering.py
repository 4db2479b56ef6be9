#!/usr/bin/env python3
"""Fails on an #include that crosses a layer (resources/docs/architecture.md).

model <- algorithms <- cli, and model <- algorithms <- gui/view3d <- gui. System-wide headers such as CGAL's compile
without a link line, so the link lines alone cannot keep the layers apart.
"""
import pathlib
import re
import sys

OWN = {
    "model": {"model"},
    "model/io": {"model", "model/io"},
    "algorithms": {"model", "model/io", "algorithms"},
    "cli": {"model", "model/io", "algorithms", "cli"},
    "gui/view3d": {"model", "algorithms", "gui/view3d"},
    "gui": {"model", "model/io", "algorithms", "gui/view3d", "gui"},
}

# Within a layer: the folders that a folder may include. A layer that is not here has no such order.
PARTS = {
    "algorithms": {
        "geometry": set(),
        "synthesis": set(),
        "footprints": {"geometry"},
        "clustering": {"geometry"},
        "rendering": {"geometry"},
        "perception": {"geometry", "rendering"},
        "simplification": {"geometry", "rendering", "perception"},
        "merging": {"geometry", "clustering"},
        "chains": {"geometry", "merging"},
        "switching": {"merging"},
        "flights": {"rendering", "perception", "merging", "chains", "switching"},
    },
    "gui": {
        "widgets": set(),
        "surfaces": set(),
        "workspace": set(),
        "city": {"widgets", "surfaces", "workspace"},
        "simplification": {"widgets", "surfaces", "workspace"},
        "perception": {"widgets", "surfaces", "workspace", "simplification"},
        "dialogs": {"widgets", "workspace", "simplification"},
        "window": {"widgets", "workspace", "city", "simplification", "perception", "dialogs"},
    },
}

# Library headers by the folders that may include them.
LIBRARIES = {
    r"(gdal|ogr|cpl_|proj|GeographicLib/|expat|simdjson|assimp/)": {"model/io"},
    r"nlohmann/": {"model/io", "cli"},
    r"(CGAL/|OpenMesh/|embree|OpenImageIO/)": {"algorithms"},
    r"(tbb/|oneapi/)": {"model/io", "algorithms", "cli", "gui/view3d", "gui"},
    r"vtk": {"gui/view3d", "gui"},
    r"(Q[A-Z]|Qt[A-Z])": {"gui"},
    r"EGL/": {"gui", "gui/view3d"},
    r"CLI/": {"cli"},
    r"Eigen/": set(OWN),
    r"fmt/": set(OWN) - {"gui", "gui/view3d"},  # texts for people are Qt's there
}
STANDARD = re.compile(r"[a-z0-9_]+$|(sys/\w+|unistd|dlfcn|iconv)\.h$")  # C++ and POSIX
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def layer_of(path):
    """The layer that a file of ours belongs to, or None."""
    parts = pathlib.PurePosixPath(path).parts
    for length in (2, 1):
        name = "/".join(parts[:length])
        if len(parts) > length and name in OWN:
            return name
    return None


def complaints(root):
    files = 0
    for folder in ("model", "algorithms", "cli", "gui"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            files += 1
            relative = path.relative_to(root).as_posix()
            layer = layer_of(relative)
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                found = INCLUDE.match(line)
                if not found:
                    continue
                quote, target = found.groups()
                problem = check(layer, quote, target) or check_part(relative, quote, target)
                if problem:
                    yield f"{relative}:{number}: {problem}"
    if files == 0:
        yield f"no sources found below {root}"


def check(layer, quote, target):
    if quote == '"':
        other = layer_of(target)
        if other is None:
            return None if target in ("version.h",) or target.endswith(".moc") else f'"{target}" is not named from the root'
        return None if other in OWN[layer] else f"{layer} must not include {other} ({target})"
    for pattern, allowed in LIBRARIES.items():
        if re.match(pattern, target):
            return None if layer in allowed else f"{layer} must not include <{target}>"
    return None if STANDARD.match(target) else f"no layer may include <{target}> yet: this check does not know it"


def part_of(path, layer):
    """The folder within its layer that a file belongs to, or None."""
    parts = pathlib.PurePosixPath(path).relative_to(layer).parts
    return parts[0] if len(parts) > 1 else None


def check_part(path, quote, target):
    layer = layer_of(path)
    if quote != '"' or layer not in PARTS or layer_of(target) != layer:
        return None
    part, other = part_of(path, layer), part_of(target, layer)
    if part is None or part == other:
        return None
    if part not in PARTS[layer]:
        return f"{layer}/{part} has no place in the order of {layer}'s folders yet"
    return None if other in PARTS[layer][part] else f"{layer}/{part} must not include {layer}/{other} ({target})"


def self_test():
    """The check must be able to fail."""
    assert check("model", '"', "algorithms/clustering/clustering.h")
    assert check("algorithms", "<", "QWidget")
    assert check("gui/view3d", "<", "QWidget")
    assert check("model", "<", "CGAL/Point_2.h")
    assert check("cli", "<", "vtkActor.h")
    assert check("gui", "<", "fmt/format.h")
    assert check("algorithms", "<", "boost/heap/d_ary_heap.hpp")
    assert not check("algorithms", "<", "fmt/format.h")
    assert not check("cli", "<", "sys/stat.h")
    assert not check("gui", '"', "gui/view3d/scene.h")
    assert check_part("algorithms/geometry/a.cpp", '"', "algorithms/merging/merging.h")
    assert check_part("gui/new/a.cpp", '"', "gui/widgets/icons.h")
    assert not check_part("gui/window/a.cpp", '"', "gui/city/viewport.h")
    assert not check_part("gui/window/a.cpp", '"', "gui/view3d/scene.h")


if __name__ == "__main__":
    self_test()
    found = list(complaints(pathlib.Path(sys.argv[1])))
    print("\n".join(found) if found else "layers kept")
    sys.exit(1 if found else 0)
