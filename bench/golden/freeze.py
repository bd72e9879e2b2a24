#!/usr/bin/env python3
"""Writes down what a roomgen makes, or says in what two of them differ:

freeze.py ROOMGEN OUT.json [--only solve,create,generate] [--cases generate/007,solve] [--keep FOLDER] [--jobs N]
freeze.py --compare A.json B.json [--files plan.json,scene.json]

Three suites, all with seed 1: `solve` on tests/data/rooms, `create` on the sentences of bench/create (those that must
be refused too) and `generate` on the lines of prompts.txt. OUT.json holds, for each case, the SHA-256 of every file that
came out (of a trace without its times), cut to 16 digits; a case that failed has its exit code and the hash of what it
said on standard error instead. --keep leaves all files but the meshes in FOLDER/SUITE/CASE, for diff -r. The furniture
is indexed anew each time, so that nothing in the user's cache counts; --cache FOLDER keeps the index, for one binary.

--compare lists the cases that differ and exits 1 if there are any; --files looks at these files only (a failure counts
always). Both must have had the same furniture package, and another C library may round otherwise. Add prompts at the end
of prompts.txt, since a case is called by its line.
"""

import argparse
import collections
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SUITES = ("solve", "create", "generate")


def sentences(suite):
    """The prompt of every case whose input is one."""
    if suite == "generate":
        lines = (HERE / "prompts.txt").read_text(encoding="utf-8").splitlines()
        return {f"generate/{number:03d}": line for number, line in enumerate(lines, 1)}
    found = {}
    for name, base in (("prompts", "create"), ("refused", "create/refused")):
        entries = json.loads((ROOT / "bench" / "create" / f"{name}.json").read_text(encoding="utf-8"))
        found.update({f"{base}/{number:03d}": entry["prompt"] for number, entry in enumerate(entries, 1)})
    return found


def cases(suite):
    """Case -> arguments of roomgen and the file that must lie beside it."""
    if suite == "solve":
        return {f"solve/{file.stem}": (["solve", file.name, "-o", "made/scene.json", "--seed", "1"], file)
                for file in sorted((ROOT / "tests" / "data" / "rooms").glob("*.json"))}
    if suite == "create":
        options = ["-o", "made/object.glb", "--write-program", "made/program.json", "--seed", "1", "--json"]
    else:
        options = ["-o", "made", "--no-pictures", "--seed", "1", "--quiet"]
    return {case: ([suite, *options, "--", prompt], None) for case, prompt in sentences(suite).items()}


def without_times(trace):
    return re.sub(rb',"seconds":[-+.e0-9]+', b"", trace)


def digest(data):
    return hashlib.sha256(data).hexdigest()[:16]


def run(options, case, arguments, beside, environment):
    # Relative paths only, so that no message depends on where this ran.
    with tempfile.TemporaryDirectory(prefix="freeze-") as name:
        made = Path(name) / "made"
        made.mkdir()
        if beside:
            shutil.copy(beside, name)
        try:
            done = subprocess.run([options.roomgen, *arguments], cwd=name, env=environment, capture_output=True,
                                  stdin=subprocess.DEVNULL, timeout=options.timeout)
            code, error = done.returncode, done.stderr
        except subprocess.TimeoutExpired:
            code, error = None, b""
        if case.startswith("create/") and code == 0:
            (made / "summary.json").write_bytes(done.stdout)
        for trace in made.rglob("trace.jsonl"):
            trace.write_bytes(without_times(trace.read_bytes()))
        if code != 0:
            (made / "stderr.txt").write_bytes(error)
        if options.keep:
            kept = options.keep / case
            shutil.rmtree(kept, ignore_errors=True)
            shutil.copytree(made, kept, ignore=shutil.ignore_patterns("*.glb"))
        if code != 0:
            return {"exit": code, "stderr": digest(error)}
        return {str(file.relative_to(made)): digest(file.read_bytes())
                for file in sorted(made.rglob("*")) if file.is_file()}


def wanted(case, only):
    return not only or any(case == name or case.startswith(name + "/") for name in only.split(","))


def freeze(options):
    # A program of which only the name is given, or the place from here, is not where the cases run.
    options.roomgen = str(Path(shutil.which(options.roomgen) or options.roomgen).resolve())
    tasks = [(case, *how) for suite in options.only.split(",") for case, how in cases(suite).items()
             if wanted(case, options.cases)]
    if not tasks:
        sys.exit("no such case")
    with tempfile.TemporaryDirectory(prefix="freeze-") as temporary:
        cache = (options.cache or Path(temporary)).resolve()
        environment = {**os.environ, "XDG_CACHE_HOME": str(cache)}
        if any(case.startswith("generate/") for case, *_ in tasks):
            cache.mkdir(parents=True, exist_ok=True)
            subprocess.run([options.roomgen, "--quiet", "assets", "index"], env=environment, check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with ThreadPoolExecutor(options.jobs) as pool:
            results = list(pool.map(lambda task: run(options, *task, environment), tasks))
    table = {case: result for (case, *_), result in zip(tasks, results)}
    lines = [f"{json.dumps(case)}: {json.dumps(table[case], sort_keys=True)}" for case in sorted(table)]
    options.out.write_text("{\n" + ",\n".join(lines) + "\n}\n")
    for suite in sorted({case.split("/")[0] for case in table}):
        own = [result for case, result in table.items() if case.startswith(suite + "/")]
        print(f"{suite}: {len(own)} cases, {sum('exit' in result for result in own)} failed")


def compare(options):
    first, second = (json.loads(Path(file).read_text()) for file in options.compare)
    prompts = {**sentences("create"), **sentences("generate")}
    looked_at = set(options.files.split(",")) | {"exit", "stderr"} if options.files else None
    kinds, cases_differ = collections.Counter(), 0
    for case in sorted(first.keys() | second.keys()):
        if not wanted(case, options.cases):
            continue
        sides = [side.get(case) for side in (first, second)]
        if None in sides:
            differ = [f"only in {options.compare[0 if sides[1] is None else 1]}"]
        else:
            differ = [file for file in sorted(sides[0].keys() | sides[1].keys())
                      if sides[0].get(file) != sides[1].get(file) and (not looked_at or file in looked_at)]
        if differ:
            cases_differ += 1
            kinds.update((case.split("/")[0], file) for file in differ)
            print(f"{case}: {', '.join(differ)}" + (f"  ({prompts[case][:70]})" if case in prompts else ""))
    for (suite, file), count in sorted(kinds.items()):
        print(f"{suite} {file}: {count}")
    print(f"{cases_differ} cases differ")
    sys.exit(1 if cases_differ else 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roomgen", nargs="?")
    parser.add_argument("out", type=Path, nargs="?")
    parser.add_argument("--only", default=",".join(SUITES), help="suites, with commas")
    parser.add_argument("--cases", help="cases or beginnings of their names, with commas")
    parser.add_argument("--keep", type=Path, metavar="FOLDER")
    parser.add_argument("--cache", type=Path, metavar="FOLDER")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--timeout", type=float, default=600)
    parser.add_argument("--compare", nargs=2, metavar=("A.json", "B.json"))
    parser.add_argument("--files", help="names of files to compare, with commas")
    options = parser.parse_args()
    if options.compare:
        compare(options)
    if not options.roomgen or not options.out:
        parser.error("ROOMGEN and OUT.json, or --compare, are required")
    if not set(options.only.split(",")) <= set(SUITES):
        parser.error(f"--only takes {', '.join(SUITES)}")
    freeze(options)


if __name__ == "__main__":
    main()
