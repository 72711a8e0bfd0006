#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Times the specplan command with real threads, in pairs with sequential A*, and prints Markdown tables."""
import argparse
import csv
import json
import os
import statistics
import subprocess

SCENE = "demos/scenes/city-128.map"


class Timer:
    """Runs pairs and keeps every single time for the CSV file."""

    def __init__(self, command, repetitions):
        self.command = command
        self.repetitions = repetitions
        self.rows = []

    def plan(self, check, threads, policy, extra=()):
        arguments = [self.command, "plan", SCENE, "--json", "--threads", str(threads), "--policy", policy]
        result = subprocess.run(arguments + list(check) + list(extra), capture_output=True, text=True, check=True)
        report = json.loads(result.stdout)
        self.rows.append([" ".join(check), threads, policy, report["wall_time_s"], report["order_hash"]])
        return report

    def ratio(self, check, threads, policy, repetitions=None):
        """Median over pairs of sequential time / time."""
        ratios = []
        for _ in range(repetitions or self.repetitions):
            sequential = self.plan(check, 1, policy)
            parallel = self.plan(check, threads, policy)
            assert sequential["order_hash"] == parallel["order_hash"]
            ratios.append(sequential["wall_time_s"] / parallel["wall_time_s"])
        return statistics.median(ratios)


def table(title, columns):
    print(f"\n### {title}\n")
    print("| " + " | ".join(columns) + " |")
    print("|" + "---|" * len(columns))


def busy(timer, cores):
    counts = sorted({2, cores} | {n for n in (4, 8, 16, 32, 64) if n < cores})
    table(f"Speed-up, checks that burn CPU, {cores} processors", ["check"] + [f"{p}, {n} threads" for n in counts for p in ("direction", "runahead")])
    for duration in ("10us", "20us", "100us", "1ms"):
        repetitions = 3 if duration == "1ms" else None
        cells = [f"{timer.ratio(['--check-busy', duration], n, p, repetitions):.2f}" for n in counts for p in ("direction", "runahead")]
        print(f"| {duration} | " + " | ".join(cells) + " |")


def cheap(timer):
    table("Time as a multiple of sequential A*, cheap checks", ["check", "2 threads", "8 threads"])
    for duration in ("0ns", "50ns", "200ns", "1us", "5us"):
        check = [] if duration == "0ns" else ["--check-busy", duration]
        cells = [f"{1.0 / timer.ratio(check, n, 'runahead', 2 * timer.repetitions + 1):.3f}" for n in (2, 8)]
        print(f"| {duration} | " + " | ".join(cells) + " |")


def sleeping(timer):
    workers = (2, 8, 32, 128)
    table("Speed-up, sleeping checks, by the durations of the checks used; in brackets on the virtual clock",
          ["check"] + [f"{n} workers" for n in workers])
    for duration in ("100us", "1ms", "5ms", "25ms"):
        cells = []
        for n in workers:
            if duration == "25ms" and n < 32:
                cells.append("-")
                continue
            real = timer.plan(["--check-latency", duration], n, "runahead")
            virtual = timer.plan(["--check-latency", duration, "--executor", "virtual"], n, "runahead")
            cells.append(f"{real['speedup']:.1f} ({virtual['speedup']:.1f})")
        print(f"| {duration} | " + " | ".join(cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--command", required=True)
    parser.add_argument("--repetitions", type=int, default=11)
    parser.add_argument("--out", required=True)
    options = parser.parse_args()
    timer = Timer(options.command, options.repetitions)
    busy(timer, os.cpu_count() or 2)
    cheap(timer)
    sleeping(timer)
    with open(os.path.join(options.out, "real.csv"), "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["check", "threads", "policy", "wall_time_s", "order_hash"])
        writer.writerows(timer.rows)


if __name__ == "__main__":
    main()
