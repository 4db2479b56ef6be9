#!/usr/bin/env python3
"""Makes a large CityGML file out of a real tile: its members again and again, with new ids and in new places.

repeat_citygml.py TILE OUT [--megabytes 100]

Each copy stands beside those before it on a square grid of cells as wide as the tile; ids and the links inside a member
get the copy's number. Appearances of the city model are written once, as they stand.
"""
import argparse
import math
import re

MEMBER = re.compile(rb"<(?:\w+:)?cityObjectMember\b[^>]*>.*?</(?:\w+:)?cityObjectMember>", re.DOTALL)
POSITIONS = re.compile(rb"(<gml:(?:posList|pos|lowerCorner|upperCorner)\b[^>]*>)([^<]*)(<)")
NAMES = re.compile(rb'((?:gml:id|xlink:href|uri|ring)\s*=\s*")(#?[^"]*)(")')


class Copier:
    """Members cut into fixed text, names and positions once, so that a copy is a join."""

    def __init__(self, members):
        self.pieces = []  # bytes; ("name", bytes); (xs, ys, zs)
        self.low = [math.inf, math.inf]
        self.high = [-math.inf, -math.inf]
        for member in members:
            self.cut(member)

    def cut(self, text):
        end = 0
        marks = [(m, "name") for m in NAMES.finditer(text)] + [(m, "positions") for m in POSITIONS.finditer(text)]
        for match, kind in sorted(marks, key=lambda mark: mark[0].start()):
            self.pieces.append(text[end : match.start(2)])
            self.pieces.append(("name", match.group(2)) if kind == "name" else self.positions(match.group(2)))
            end = match.end(2)
        self.pieces.append(text[end:] + b"\n")

    def positions(self, text):
        words = text.split()
        xs, ys, zs = [float(w) for w in words[0::3]], [float(w) for w in words[1::3]], words[2::3]
        for axis, values in enumerate((xs, ys)):
            self.low[axis] = min([self.low[axis], *values])
            self.high[axis] = max([self.high[axis], *values])
        return xs, ys, zs

    def copy(self, number, per_row):
        dx = (number % per_row) * (self.high[0] - self.low[0])
        dy = (number // per_row) * (self.high[1] - self.low[1])
        suffix = b"_%d" % number
        out = []
        for piece in self.pieces:
            if isinstance(piece, bytes):
                out.append(piece)
            elif piece[0] == "name":
                out.append(piece[1] + suffix)
            else:
                out.append(b" ".join(b"%.9f %.9f %s" % (x + dx, y + dy, z) for x, y, z in zip(*piece)))
        return b"".join(out)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tile")
    parser.add_argument("out")
    parser.add_argument("--megabytes", type=float, default=100)
    options = parser.parse_args()
    with open(options.tile, "rb") as file:
        text = file.read()
    found = list(MEMBER.finditer(text))
    copier = Copier([match.group(0) for match in found])
    copies = math.ceil(options.megabytes * 1e6 / sum(len(match.group(0)) for match in found))
    per_row = math.ceil(math.sqrt(copies))
    with open(options.out, "wb") as file:
        file.write(text[: found[0].start()])
        for number in range(copies):
            file.write(copier.copy(number, per_row))
        file.write(text[found[-1].end() :])
    print(f"{copies} copies of {len(found)} members in {options.out}")


if __name__ == "__main__":
    main()
