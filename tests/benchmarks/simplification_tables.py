#!/usr/bin/env python3
"""Prints, as Markdown, what simplification does to real buildings: the tables of resources/docs/simplification.md.

simplification_tables.py CLI DATA [--models NAME…] [--rates 0.5…] [--json FILE] [--from FILE]

CLI is lodestone-cli, DATA the folder with the models below. Every figure is read from the reports of
`lodestone-cli simplify`; --json keeps them.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile

HAN = "han_china_0ad/meshes/structural/han_{}.dae"
GAZEBO = "gazebo_buildings/{0}/meshes/{0}.dae"
IFC = "ifc_to_obj_derived/{}.obj"
MODELS = {
    **{f"Han {name.replace('_', ' ')}": HAN.format(name) for name in
       ("academy", "civic_center_no_towers", "farmstead", "great_tower", "house_a", "house_b", "house_c", "house_d",
        "market", "shrine", "temple")},
    **{f"Gazebo {name.replace('_', ' ')}": GAZEBO.format(name) for name in
       ("apartment", "fast_food", "house_1", "office_building", "police_station", "school", "water_tower")},
    "FZK-Haus": IFC.format("AC14-FZK-Haus"),
    "Duplex": IFC.format("Ifc2x3_Duplex_Architecture"),
}
MODELS = {name.replace(" no towers", "").replace(" building", ""): path for name, path in MODELS.items()}
FIGURE_16 = ("Han temple", "Gazebo apartment")

RATES = (0.5, 0.6, 0.7, 0.8)
METHODS = {
    "a = 2": ("--a", "2"),
    "auto": ("--a", "auto"),
    "QEM": ("--method", "qem"),
    "optimal": ("--method", "qem-optimal"),
    "clustering": ("--method", "vertex-clustering"),
}
# Open edges held by planes across them: what QEM has in its authors' paper and in most programs.
RIM_METHODS = {
    "a = 2": METHODS["a = 2"],
    "auto": METHODS["auto"],
    "a = 2, rim planes": ("--a", "2", "--rim-planes"),
    "a = 4, rim planes": ("--a", "4", "--rim-planes"),
    "QEM, rim planes": ("--method", "qem", "--rim-planes"),
}
SHOWN = ("a = 2", "auto", "QEM")


class Measures:
    """Reports of simplify, each made once."""

    def __init__(self, cli, data, earlier=None):
        self.cli = cli
        self.data = data
        self.known = {}
        for one in json.loads(earlier.read_text()) if earlier else ():
            self.known[one.pop("model"), one.pop("rate"), tuple(one.pop("arguments"))] = one

    def get(self, model, rate, arguments):
        key = (model, rate, arguments)
        if key not in self.known:
            self.known[key] = self.run(*key)
        return self.known[key]

    def run(self, model, rate, arguments):
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder, "report.json")
            command = [self.cli, "simplify", self.data / MODELS[model], "--rate", str(rate), *arguments,
                       "--quiet", "--report", report, "-o", pathlib.Path(folder, "simplified.obj")]
            done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
            if done.returncode not in (0, 3):
                sys.exit(f"{model}: {done.stderr}")
            read = json.loads(report.read_text())
        figures = read["figures"]
        figures["seconds"] = sum(s["seconds"] for s in read["stages"] if s["name"] == "simplify")
        figures["broken"] = figures["contacts_separated"] + figures["contacts_lost"]
        return figures


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---|" + "--:|" * (len(head) - 1)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def contacts(figures):
    return f"{figures['contacts_separated']} + {figures['contacts_lost']} = {figures['broken']}"


def left_of(figures):
    counts_left = [f"{f['triangles_after']:,}" for f in figures]
    return counts_left[0] if len(set(counts_left)) == 1 else " / ".join(counts_left)


def metres(value):
    return f"{value:.3f}" if value < 9.9995 else f"{value:.2f}"


def seconds(value):
    return f"{value:.2f}"


def marked(texts, values):
    """The first two texts are ours: bold where no other value is smaller, if the values differ at all."""
    least = min(values)
    return [f"**{t}**" if v == least and max(values) > least else t for t, v in zip(texts, values)]


def rate_table(measures, models, rate):
    head = ["model", "triangles: before", "wanted", "left", "contacts"]
    head += [f"{what}: {method}" if method == SHOWN[0] else method
             for what in ("components left", "separated + lost", "widest gap, m", "Hausdorff, m", "seconds")
             for method in SHOWN]
    rows = []
    for model in models:
        all_ = [measures.get(model, rate, METHODS[method]) for method in SHOWN]
        broken, gap, far = ([f[key] for f in all_] for key in ("broken", "widest_gap_m", "hausdorff_m"))
        before = all_[0]["triangles_before"]
        wanted = before - math.ceil(rate * before - 1e-9)
        rows.append([model, f"{before:,}", f"{wanted:,}", left_of(all_),
                     str(all_[0]["contacts"]), *(f"{f['components_after']}" for f in all_),
                     *marked([contacts(f) for f in all_], broken),
                     *marked([metres(v) for v in gap], [round(v, 3) for v in gap]),
                     *marked([metres(v) for v in far], [round(v, 3) for v in far]),
                     *(seconds(f["seconds"]) for f in all_)])
    return table(head, rows)


def counts(ours, others):
    better = sum(o < t for o, t in zip(ours, others))
    worse = sum(o > t for o, t in zip(ours, others))
    return f"{better} / {len(ours) - better - worse} / {worse}"


def summary(measures, models, rates, methods, peer):
    head = ["rate", "method", "components left", "separated + lost", "mean widest gap, m", "mean Hausdorff, m",
            f"contacts: better / equal / worse than {peer}", "gap", "Hausdorff", "seconds"]
    rows = []
    for rate in rates:
        qem = [measures.get(model, rate, methods[peer]) for model in models]
        for method, arguments in methods.items():
            all_ = [measures.get(model, rate, arguments) for model in models]
            total = {key: sum(f[key] for f in all_) for key in
                     ("components_after", "contacts_separated", "contacts_lost", "broken", "seconds")}
            against = ["", "", ""] if method == peer else [
                counts([round(f[key], 3) for f in all_], [round(f[key], 3) for f in qem])
                for key in ("broken", "widest_gap_m", "hausdorff_m")]
            rows.append([f"{rate:.0%}", method, f"{total['components_after']:,}", contacts(total),
                         *(metres(sum(f[key] for f in all_) / len(models)) for key in ("widest_gap_m", "hausdorff_m")),
                         *against, seconds(total["seconds"])])
    return table(head, rows)


def losses(measures, models, rates):
    """Where neither a = 2 nor auto is as good as plain QEM."""
    rows = []
    for model in models:
        for rate in rates:
            ours = [measures.get(model, rate, METHODS[method]) for method in SHOWN[:2]]
            qem = measures.get(model, rate, METHODS["QEM"])
            for what, key, show in (("separated + lost", "broken", contacts), ("widest gap, m", "widest_gap_m", None),
                                    ("Hausdorff, m", "hausdorff_m", None)):
                if min(round(f[key], 3) for f in ours) > round(qem[key], 3):
                    text = show or (lambda f, key=key: metres(f[key]))
                    rows.append([model, f"{rate:.0%}", what, *(text(f) for f in (*ours, qem)),
                                 *(str(f["components_after"]) for f in (*ours, qem))])
    head = ["model", "rate", "measure", *SHOWN, *(f"components left: {method}" for method in SHOWN)]
    return table(head, rows)


def figure_16(measures, model, rates):
    head = ["rate", "a", "components left", "separated + lost", "widest gap, m", "Hausdorff, m", "seconds"]
    rows = []
    for rate in rates:
        for a in ("1", "2", "4", "8", "auto"):
            figures = measures.get(model, rate, ("--a", a))
            shown = a if a != "auto" else f"auto: {figures['a']:g}"
            rows.append([f"{rate:.0%}", shown, str(figures["components_after"]), contacts(figures),
                         metres(figures["widest_gap_m"]), metres(figures["hausdorff_m"]), seconds(figures["seconds"])])
    return table(head, rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cli", type=pathlib.Path)
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--models", nargs="+", choices=MODELS, default=list(MODELS), metavar="NAME")
    parser.add_argument("--rates", nargs="+", type=float, default=RATES, metavar="RATE")
    parser.add_argument("--json", type=pathlib.Path, help="file for all reports")
    parser.add_argument("--from", type=pathlib.Path, dest="earlier", help="such a file: what it has is not made again")
    args = parser.parse_args()
    measures = Measures(args.cli.resolve(), args.data, args.earlier)
    print("## All models together\n")
    print(summary(measures, args.models, args.rates, METHODS, "QEM"))
    print("## With open edges held by planes\n")
    print(summary(measures, args.models, args.rates, RIM_METHODS, "QEM, rim planes"))
    print("## Where we lose\n")
    print(losses(measures, args.models, args.rates))
    for rate in args.rates:
        print(f"## {rate:.0%} of the triangles removed\n")
        print(rate_table(measures, args.models, rate))
    for model in FIGURE_16:
        if model in args.models:
            print(f"## Values of a: {model}\n")
            print(figure_16(measures, model, args.rates))
    if args.json:
        args.json.write_text(json.dumps([{"model": m, "rate": r, "arguments": a, **f}
                                         for (m, r, a), f in measures.known.items()], indent=1))


if __name__ == "__main__":
    main()
