#!/usr/bin/env python3
"""Checks scene.json files against docs/constraints.md, independently of the solver.

Exit code 0: nothing broken, 1: a violation in some scene, 2: a file could not be read.
"""

import argparse
import json
import sys
from pathlib import Path

from roomgen_checker import files, reach, report, schemas
from roomgen_checker.constraints import LOOSE, STRICT


def arguments():
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    p.add_argument("scenes", nargs="+", help="scene.json files, or folders that hold one")
    p.add_argument("--categories", help="folder of kinds; default: data/kinds of this checkout")
    p.add_argument(
        "--problem",
        help="the problem.json that the scenes answer: counts the "
        "constraints of objects left out, and tells what was changed",
    )
    p.add_argument(
        "--loose", action="store_true", help="the looser limits with which an earlier solver was measured"
    )
    p.add_argument("--glb", action="store_true", help="demand scene.glb beside each scene")
    p.add_argument("--no-glb", action="store_true", help="let boxes decide even if it is there")
    p.add_argument(
        "--lenience",
        type=float,
        default=reach.LENIENCE,
        help="metres by which a person is thinner than 0.5 m / 2 (default %(default)s)",
    )
    p.add_argument("--schema", action="store_true", help="also validate against docs/*.schema.json")
    p.add_argument("--json", action="store_true", help="print JSON")
    p.add_argument("--quiet", action="store_true", help="only counts and violations")
    return p.parse_args()


def options_from(args):
    categories = files.Categories.load(args.categories) if args.categories else files.Categories.default()
    problem = files.read_problem(files.read_json(args.problem)) if args.problem else None
    meshes = "never" if args.no_glb else "always" if args.glb else "auto"
    return report.Options(categories, LOOSE if args.loose else STRICT, meshes, problem, args.lenience)


def check_path(path, options, with_schema):
    path = Path(path)
    path = path / "scene.json" if path.is_dir() else path
    found = report.check_file(path, options)
    if with_schema:
        found["violations"] += [
            {"rule": "schema", "objects": [], "detail": e} for e in schemas.errors(files.read_json(path))
        ]
    return found


def main():
    args = arguments()
    try:
        options = options_from(args)
        reports = [check_path(p, options, args.schema) for p in args.scenes]
    except (OSError, ValueError, KeyError, IndexError, TypeError) as error:
        print(f"check_scene: {type(error).__name__}: {error}", file=sys.stderr)
        return 2
    if args.json:
        print(json.dumps(reports, indent=1))
    else:
        print("\n".join(report.as_text(r, not args.quiet) for r in reports))
    return 1 if any(r["violations"] for r in reports) else 0


if __name__ == "__main__":
    sys.exit(main())
