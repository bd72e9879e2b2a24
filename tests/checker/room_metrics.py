#!/usr/bin/env python3
"""Sums up many scenes: objects, objects left out, constraints held, scenes with violations.

A folder given stands for every scene.json below it. With --problems, the problem of a scene is the
file there named like the scene's folder (or like the scene file itself).
"""

import argparse
import json
import sys
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path

from roomgen_checker import files, reach, report
from roomgen_checker.constraints import LOOSE, STRICT


def arguments():
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    p.add_argument("scenes", nargs="+", help="scene files, or folders with scene.json files below")
    p.add_argument("--problems", type=Path, help="folder of problem files")
    p.add_argument("--categories", help="folder of kinds; default: data/kinds of this checkout")
    p.add_argument("--loose", action="store_true", help="the looser limits of an earlier solver")
    p.add_argument("--no-glb", action="store_true", help="let boxes decide what overlaps")
    p.add_argument("--lenience", type=float, default=reach.LENIENCE)
    p.add_argument("--jobs", type=int, default=1, help="processes to use")
    p.add_argument("--json", type=Path, help="also write the figures to this file")
    return p.parse_args()


def scene_files(paths):
    """Every scene file named or found, in a stable order."""
    found = []
    for path in map(Path, paths):
        found += sorted(path.rglob("*scene.json")) if path.is_dir() else [path]
    return found


def problem_for(path, folder):
    """The problem a scene answers, by name; None if there is none."""
    stems = (path.parent.name, path.name.removesuffix(".json").removesuffix(".scene"))
    for stem in stems if folder else ():
        candidate = folder / f"{stem}.json"
        if candidate.exists():
            return files.read_problem(files.read_json(candidate))
    return None


def label(path):
    return path.parent.name if path.name == "scene.json" else path.name.removesuffix(".json")


def check_one(job):
    path, options, problems = job
    found = report.check_file(path, replace(options, problem=problem_for(path, problems)))
    return {**found, "scene": label(path)}


def share(part, whole):
    return round(part / whole, 4) if whole else None


def merge_names(reports):
    """{constraint: [held, all]} over all scenes."""
    table = {}
    for r in reports:
        for name, (held, total) in r["constraints"]["by_name"].items():
            row = table.setdefault(name, [0, 0])
            row[0] += held
            row[1] += total
    return dict(sorted(table.items()))


def count_rules(reports):
    table = {}
    for r in reports:
        for v in r["violations"]:
            table[v["rule"]] = table.get(v["rule"], 0) + 1
    return dict(sorted(table.items()))


def summary(reports):
    """The figures over all scenes."""
    placed = sum(r["objects"] for r in reports)
    left_out = sum(len(r["unplaced"]) for r in reports)
    held = sum(r["constraints"]["held"] for r in reports)
    total = sum(r["constraints"]["total"] for r in reports)
    return {
        "scenes": len(reports),
        "objects": placed,
        "objects_min": min(r["objects"] for r in reports),
        "unplaced": left_out,
        "unplaced_share": share(left_out, placed + left_out),
        "constraints_held": held,
        "constraints": total,
        "constraints_share": share(held, total),
        "scenes_with_everything": sum(
            not r["unplaced"]
            and not r["violations"]
            and r["constraints"]["held"] == r["constraints"]["total"]
            for r in reports
        ),
        "scenes_with_violations": sum(bool(r["violations"]) for r in reports),
        "violations": count_rules(reports),
        "by_constraint": merge_names(reports),
    }


def percent(value):
    return "-" if value is None else f"{100 * value:.1f} %"


def row(r):
    c = r["constraints"]
    return (
        f"{r['scene'][:32]:32} {r['objects']:7} {len(r['unplaced']):8} {100 * r['fill']:5.0f} "
        f"{c['held']:5}/{c['total']:<5} {percent(share(c['held'], c['total'])):>8} "
        f"{len(r['violations']):10}"
    )


def table(reports, figures):
    lines = [
        f"{'scene':32} {'objects':>7} {'left out':>8} {'fill%':>5} {'constraints':>20} " f"{'violations':>10}"
    ]
    lines += map(row, reports)
    lines += [
        "",
        f"{figures['scenes']} scenes, {figures['objects']} objects (at least "
        f"{figures['objects_min']} a scene), {figures['unplaced']} left out "
        f"({percent(figures['unplaced_share'])}), {figures['constraints_held']} of "
        f"{figures['constraints']} constraints ({percent(figures['constraints_share'])}), "
        f"{figures['scenes_with_violations']} scenes with violations "
        f"{figures['violations'] or ''}, {figures['scenes_with_everything']} with everything",
    ]
    lines += [
        f"  {name:18} {held:5}/{total:<5} {percent(share(held, total)):>8}"
        for name, (held, total) in figures["by_constraint"].items()
    ]
    return "\n".join(lines)


def main():
    args = arguments()
    categories = files.Categories.load(args.categories) if args.categories else files.Categories.default()
    options = report.Options(
        categories, LOOSE if args.loose else STRICT, "never" if args.no_glb else "auto", None, args.lenience
    )
    jobs = [(p, options, args.problems) for p in scene_files(args.scenes)]
    if not jobs:
        print("room_metrics: no scenes found", file=sys.stderr)
        return 2
    if args.jobs > 1:
        with ProcessPoolExecutor(args.jobs) as pool:
            reports = list(pool.map(check_one, jobs))
    else:
        reports = list(map(check_one, jobs))
    figures = summary(reports)
    print(table(reports, figures))
    if args.json:
        args.json.write_text(json.dumps({"summary": figures, "scenes": reports}, indent=1) + "\n")
    return 1 if figures["scenes_with_violations"] else 0


if __name__ == "__main__":
    sys.exit(main())
