#!/usr/bin/env python3
"""Compares ways of fusing constraints with suggested places, with scripted models that suggest well and badly.

    fusion.py ROOMGEN FOLDER [--manners good,noisy,hopeless]

Six rooms for each way and model, over a real HTTP server; judged by tests/checker. Prints Markdown.
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "designer"))

from model_in_the_loop import ROOMS, folder_of, one_room, total  # noqa: E402

WAYS = {
    "scaled, s = 30": ["--lost-step", "30"],
    "scaled, s = 120": ["--lost-step", "120"],
    "scaled, s = 300": ["--lost-step", "300"],
    "constraints first": ["--lost-step", "1e9"],
    "paper (ordinal)": ["--fusion", "paper"],
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("roomgen")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--manners", default="good,noisy,hopeless")
    args = parser.parse_args()
    print("| fusion | model | objects | left out | constraints held | within 0.5 m | within 1 m | violations |")
    print("|---|---|---|---|---|---|---|---|")
    for manner in args.manners.split(","):
        for way, options in WAYS.items():
            t = total([one_room(args.roomgen, p, manner, folder_of(args.folder, p), options) for p in ROOMS])
            print(
                f"| {way} | {manner} | {t['objects']} | {t['left out']} | {t['held']:.1%} | {t['half']:.1%} | "
                f"{t['one']:.1%} | {t['violations']} |",
                flush=True,
            )


if __name__ == "__main__":
    main()
