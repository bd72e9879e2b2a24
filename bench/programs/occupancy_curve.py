#!/usr/bin/env python3
"""RoomGen's figure 3 as a picture: which share of a room's things find a place, over the floor that they would cover.

    bench_occupancy > TABLE; bench/programs/occupancy_curve.py TABLE occupancy.svg"""
import pathlib
import re
import sys

COLORS = ["#888", "#1f6fb4", "#6a9f3a", "#c8551b", "#8e5ea2"]
LEFT, TOP, WIDTH, HEIGHT = 56, 16, 300, 220


def read(table):
    """The names of the searches, and of each line the floor asked for with the share that each search placed."""
    lines = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in table.splitlines() if line.startswith("|")]
    number = lambda cell: float(re.match(r"[\d.]+", cell).group())
    return lines[0][1:], [(number(line[0]), [number(cell) for cell in line[1:]]) for line in lines[2:]]


def plot(names, rows):
    low = 10 * int(min(min(values) for _, values in rows) // 10)
    x = lambda floor: LEFT + WIDTH * (floor - rows[0][0]) / (rows[-1][0] - rows[0][0])
    y = lambda share: TOP + HEIGHT * (100 - share) / (100 - low)
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" width="620" height="290" font-family="sans-serif" font-size="12">',
             '<rect width="620" height="290" fill="white"/>']
    for share in range(low, 101, 10):
        parts.append(f'<line x1="{LEFT}" x2="{LEFT + WIDTH}" y1="{y(share):.1f}" y2="{y(share):.1f}" stroke="#ddd"/>')
        parts.append(f'<text x="{LEFT - 34}" y="{y(share) + 4:.1f}">{share} %</text>')
    for floor, _ in rows:
        parts.append(f'<text x="{x(floor) - 10:.1f}" y="{TOP + HEIGHT + 18}">{floor:.0f} %</text>')
    parts.append(f'<text x="{LEFT + 60}" y="{TOP + HEIGHT + 38}">floor that all things would cover</text>')
    for i, name in enumerate(names):
        points = " ".join(f"{x(floor):.1f},{y(values[i]):.1f}" for floor, values in rows)
        parts.append(f'<polyline fill="none" stroke-width="2" stroke="{COLORS[i]}" points="{points}"/>')
        height = TOP + 20 + 20 * i
        parts.append(f'<rect x="{LEFT + WIDTH + 14}" y="{height - 9}" width="12" height="4" fill="{COLORS[i]}"/>')
        parts.append(f'<text x="{LEFT + WIDTH + 32}" y="{height}">{name}</text>')
    return "\n".join(parts + ["</svg>", ""])


if __name__ == "__main__":
    pathlib.Path(sys.argv[2]).write_text(plot(*read(pathlib.Path(sys.argv[1]).read_text())))
