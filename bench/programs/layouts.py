#!/usr/bin/env python3
"""What each way of laying rooms out is worth in real rooms that are small for what they shall hold, with equal time.

    bench/programs/layouts.py ROOMGEN FOLDER [--seeds 3]

`generate --layout steps` and `both` with the same plans, and the best of several seeds of `steps`, of as many as take as
long as `both`. Things left out, clauses of the prompt that are met, processor seconds."""
import argparse
import json
import os
import pathlib
import resource
import subprocess

ROOMS = [
    ("a bedroom with a double bed, two nightstands, a wardrobe, a dresser, a desk, a chair and a bookshelf", "3x3.2"),
    ("a bedroom with two single beds, two nightstands, two desks, two chairs and a wardrobe", "3.2x3.4"),
    ("a children's room with a bunk bed, two desks, two chairs, a toy shelf, a wardrobe and a bean bag", "3x3.4"),
    ("a living room with a sofa, two armchairs, a coffee table, a tv stand, two bookshelves, a sideboard and a piano", "3.6x3.8"),
    ("a living room with a corner sofa, an armchair, a coffee table, a tv stand, a desk, a chair and three bookshelves", "3.6x4"),
    ("a dining room with a dining table, eight chairs, a sideboard, two display cabinets and a bar cart", "3.2x3.8"),
    ("a study with two desks, two office chairs, five bookshelves, a filing cabinet and an armchair", "3x3.2"),
    ("an office with four desks, four office chairs, three filing cabinets and a sofa", "4x4"),
    ("a kitchen with a stove, a refrigerator, a sink, four base cabinets, a dining table and four chairs", "3x3.6"),
    ("a studio flat with a double bed, a wardrobe, a sofa, a coffee table, a desk, a chair, a dining table and two chairs", "4x4.4"),
    ("a library with eight bookshelves, two reading tables, six chairs and two armchairs", "4x4.4"),
    ("a waiting room with twelve chairs, three side tables, a reception desk, an office chair and two plants", "3.6x4"),
    ("a gym with two treadmills, two exercise bikes, two weight benches and a dumbbell rack", "4x4.2"),
    ("a workshop with two workbenches, two stools, three tool cabinets, a table saw and two shelving units", "3.4x3.6"),
    ("a dormitory with four bunk beds, eight lockers and a table with four chairs", "4x4.6"),
    ("a nursery with two cribs, a changing table, a rocking chair, a dresser, a wardrobe and a toy shelf", "3x3.4"),
]


def furnish(roomgen, folder, prompt, size, layout, seed):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([roomgen, "generate", prompt, "--size", size, "-o", folder, "--force", "--no-pictures", "--json",
                           "--quiet", "--seed", str(seed), "--layout", layout], capture_output=True, text=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    said = json.loads(done.stdout)
    valid = subprocess.run([roomgen, "check", folder / "scene.json"], capture_output=True).returncode == 0
    return {"out": len(said["unplaced"]), "all": len(said["unplaced"]) + said["objects"],
            "met": sum(r["met"] for r in said["requirements"]), "asked": len(said["requirements"]), "valid": int(valid),
            "seconds": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime}


def best(runs):
    return min(runs, key=lambda run: (run["out"], -run["met"])) | {"seconds": sum(run["seconds"] for run in runs)}


def row(name, runs):
    total = {key: sum(run[key] for run in runs) for key in ("out", "all", "met", "asked", "valid", "seconds")}
    print(f"| {name} | {total['out']} of {total['all']} | {100 * total['met'] / total['asked']:.1f} % | "
          f"{total['valid']} of {len(runs)} | {total['seconds'] / len(runs):.1f} |", flush=True)
    return total["seconds"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roomgen")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seeds", type=int, default=3)
    known = parser.parse_args()
    os.makedirs(known.folder, exist_ok=True)
    print("| layout | left out | clauses met | valid | s a room |\n|---|---|---|---|---|")
    cases = [(prompt, size, seed) for seed in range(1, known.seeds + 1) for prompt, size in ROOMS]
    seconds = {}
    for layout in ("steps", "both"):
        runs = [furnish(known.roomgen, known.folder / "room", *case[:2], layout, case[2]) for case in cases]
        seconds[layout] = row(layout, runs)
    tries = max(2, round(seconds["both"] / seconds["steps"]))
    runs = [best([furnish(known.roomgen, known.folder / "room", prompt, size, "steps", 100 * seed + k) for k in range(tries)])
            for prompt, size, seed in cases]
    row(f"steps, best of {tries} seeds", runs)


if __name__ == "__main__":
    main()
