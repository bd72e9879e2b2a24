#!/usr/bin/env python3
"""Shows a design as rooms of three sizes and seeds: one sheet of pictures, and what was moved or left out.

    bench/designs/look.py build/release/roomgen DESIGN.json OUT.png [--wish WISH] [--sizes 3.6x3.2,5x4] [--seeds 1,2,3] [--views iso,top]

Without --sizes: nearly the least size, the usual one (as the design chooses it) and nearly the most."""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image, ImageDraw

PIXELS = 640


def sizes_of(design):
    size = design["size_m"]
    between = []
    for bound in ("least", "most"):
        if bound in size:
            between.append("x".join(f"{side:.2f}" for side in size[bound]))
    return [between[0] if between else None, None, between[1] if len(between) > 1 else None]


def room(roomgen, design, wish, size, seed, folder):
    command = [roomgen, "generate", wish, "--design", str(design), "-o", str(folder), "--force", "--seed", str(seed)]
    if size:
        command += ["--size", size]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.returncode, [line for line in (done.stderr + done.stdout).splitlines() if line.strip()]


def picture(roomgen, folder, view):
    target = folder / f"{view}.png"
    subprocess.run([roomgen, "render", str(folder / "scene.json"), "--view", view, "--pixels", str(PIXELS), "-o", str(target)],
                   capture_output=True, check=True)
    return Image.open(target).convert("RGB")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roomgen")
    parser.add_argument("design", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--wish")
    parser.add_argument("--sizes")
    parser.add_argument("--seeds", default="1,2,3")
    parser.add_argument("--views", default="iso,top")
    options = parser.parse_args()
    design = json.loads(options.design.read_text())
    wish = options.wish or "a " + design["for"][0]
    sizes = options.sizes.split(",") if options.sizes else sizes_of(design)
    seeds = [int(seed) for seed in options.seeds.split(",")]
    views = options.views.split(",")
    columns = []
    failed = False
    with tempfile.TemporaryDirectory() as scratch:
        for number, size in enumerate(sizes):
            folder = pathlib.Path(scratch) / str(number)
            seed = seeds[number % len(seeds)]
            code, told = room(options.roomgen, options.design, wish, size, seed, folder)
            print(f"--- size {size or 'usual'}, seed {seed}: exit {code}")
            print("\n".join("  " + line for line in told if "designed after" not in line))
            if code:
                failed = True
                continue
            scene = json.loads((folder / "scene.json").read_text())
            xs, ys = zip(*scene["room"]["polygon"])
            label = f"{max(xs) - min(xs):.1f} x {max(ys) - min(ys):.1f} m, {len(scene['objects'])} things"
            columns.append((label, [picture(options.roomgen, folder, view) for view in views]))
    if columns:
        rows = [max(column[1][row].height for column in columns) for row in range(len(views))]
        sheet = Image.new("RGB", (PIXELS * len(columns), sum(rows) + 24), "white")
        draw = ImageDraw.Draw(sheet)
        for number, (label, pictures) in enumerate(columns):
            draw.text((number * PIXELS + 8, 6), label, fill="black")
            top = 24
            for row, one in enumerate(pictures):
                sheet.paste(one, (number * PIXELS, top))
                top += rows[row]
        sheet.save(options.out)
        print(f"wrote {options.out}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
