#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the README's summary from the tables that scripts/benchmark has written."""
import argparse
import csv
import re
import sys

BEGIN = "<!-- benchmark summary: written by scripts/benchmark --readme -->"
END = "<!-- end of benchmark summary -->"


def mean(lines, section, policy, workers):
    """The mean speed-up, accuracy and coverage in one row of a table of virtual.md."""
    inside = False
    for line in lines:
        if line.startswith("### "):
            inside = line[4:].strip() == section
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if inside and len(cells) > 5 and cells[0] == policy and cells[1] == str(workers):
            return cells[-3].strip("*"), cells[-2], cells[-1]
    sys.exit(f"summary.py: no row for {policy}, {workers} in '{section}'")


def rate(text, name):
    """Expansions a second of one measurement of search.txt, in millions."""
    found = re.search(rf"^{name}\S*\s.*expansions/s=([\d.]+)(k|M)", text, re.MULTILINE)
    if not found:
        sys.exit(f"summary.py: {name} is missing in search.txt")
    return float(found.group(1)) * (1.0 if found.group(2) == "M" else 1e-3)


def cost_per_check(folder):
    """Mean microseconds of search and shadow for each check run, 32 workers, weight 1."""
    with open(f"{folder}/virtual.csv", newline="", encoding="utf-8") as file:
        costs = [float(row["search_us_per_check"]) for row in csv.DictReader(file)
                 if row["policy"] == "runahead" and row["workers"] == "32" and row["weight"] == "1" and row["durations"] == "0" and row["predictor"] == "learning"]
    return sum(costs) / len(costs)


def summary(folder):
    with open(f"{folder}/virtual.md", encoding="utf-8") as file:
        lines = file.readlines()
    with open(f"{folder}/search.txt", encoding="utf-8") as file:
        search = file.read()
    with open(f"{folder}/real.md", encoding="utf-8") as file:
        real = file.read().strip()
    section = "Speed-up, bundled scenes, weight 1"
    out = ["Speed-up over sequential A*, geometric mean over the four largest scenes, virtual clock:", "",
           "| workers | neighbours in parallel | the paper's scheme | run-ahead | its accuracy | its coverage |", "|---|---|---|---|---|---|"]
    for workers in (2, 8, 32, 128):
        runahead = mean(lines, section, "runahead", workers)
        out.append(f"| {workers} | {mean(lines, section, 'none', workers)[0]} | {mean(lines, section, 'direction', workers)[0]} | "
                   f"{runahead[0]} | {runahead[1]} | {runahead[2]} |")
    out += ["", f"The search itself, one thread, checks for free: {rate(search, 'core'):.2f} million expansions a second through the core, "
            f"{rate(search, 'planner'):.2f} million through OMPL's states. Search, shadow and virtual clock together, 32 workers: "
            f"{cost_per_check(folder):.1f} µs a check.", "", real]
    return "\n".join(out).replace("\n###", "\n####")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder")
    parser.add_argument("--into", help="Markdown file whose summary is replaced")
    options = parser.parse_args()
    text = summary(options.folder)
    if not options.into:
        print(text)
        return
    with open(options.into, encoding="utf-8") as file:
        old = file.read()
    if BEGIN not in old or END not in old:
        sys.exit(f"summary.py: {options.into} has no place for the summary")
    new = old[:old.index(BEGIN)] + BEGIN + "\n\n" + text + "\n\n" + old[old.index(END):]
    with open(options.into, "w", encoding="utf-8") as file:
        file.write(new)


if __name__ == "__main__":
    main()
