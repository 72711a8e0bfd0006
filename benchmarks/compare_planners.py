#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares planners on .cfg problems with `specplan benchmark` and prints a Markdown table for each problem and validity resolution."""
import argparse
import json
import math
import os
import statistics
import subprocess
import sys


def text(value, digits=3):
    return "never" if math.isinf(value) else f"{value:.{digits}g}" if value < 100 else f"{value:.0f}"


def time_to(run, cost):
    """Seconds until the run had a path of at most this cost."""
    return next((time for time, reached in run["costs"] if reached <= cost * (1 + 1e-9)), math.inf)


def last_cost(run):
    return run["costs"][-1][1] if run["costs"] else math.inf


class Comparison:
    """All runs of one problem at one validity resolution."""

    def __init__(self, report):
        self.runs = {}
        for run in report["results"]:
            self.runs.setdefault(run["planner"].removeprefix("geometric_"), []).append(run)
        # What the best of OMPL's planners comes to in most of its runs.
        self.goal = min((self.median(last_cost, name) for name in self.runs if not self.is_ours(name)), default=math.inf)

    def is_ours(self, planner):
        return "speculative_checks" in self.runs[planner][0]

    def median(self, value, planner):
        return statistics.median(value(run) for run in self.runs[planner])

    def row(self, planner):
        runs = self.runs[planner]
        solved = [run for run in runs if run["costs"]]
        finer = [run.get("valid_at_finer_resolution", False) for run in solved]
        return [planner, f"{len(solved)} of {len(runs)}",
                text(self.median(lambda run: time_to(run, math.inf), planner)),
                text(self.median(lambda run: run["costs"][0][1] if run["costs"] else math.inf, planner), 4),
                text(self.median(last_cost, planner), 4),
                text(self.median(lambda run: time_to(run, self.goal), planner)),
                f"{self.median(lambda run: run['state_checks'], planner):.0f}",
                f"{sum(finer)} of {len(finer)}"]


def print_table(rows):
    columns = ["planner", "solved", "first path, s", "its cost", "cost at the end", "best cost of OMPL's planners reached, s", "state checks",
               "valid at a tenth of the resolution"]
    print("| " + " | ".join(columns) + " |")
    print("|" + "---|" * len(columns))
    for row in rows:
        print("| " + " | ".join(row) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--command", default="build/release/apps/specplan/specplan")
    parser.add_argument("--planners", default="RRTConnect,RRTstar,InformedRRTstar,BITstar,ABITstar,LazyPRMstar,SpeculativeAStar:name=eager,SpeculativeAStar:evaluation=lazy;name=lazy")
    parser.add_argument("--resolutions", default="0.01,0.001")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--time-limit", help="of each run, such as 10s [the problem's]")
    parser.add_argument("--out", help="folder for the results as JSON")
    parser.add_argument("problems", nargs="+")
    options = parser.parse_args()
    for problem in options.problems:
        for resolution in options.resolutions.split(","):
            command = [options.command, "benchmark", problem, "--json", "--runs", str(options.runs), "--planners", options.planners,
                       "--validity-resolution", resolution]
            if options.time_limit:
                command += ["--time-limit", options.time_limit]
            result = subprocess.run(command, capture_output=True, text=True)
            if not result.stdout:
                sys.exit(f"{' '.join(command)}: {result.stderr.strip()}")
            report = json.loads(result.stdout)
            if options.out:
                os.makedirs(options.out, exist_ok=True)
                name = f"{os.path.splitext(os.path.basename(problem))[0]}-{resolution}.json"
                with open(os.path.join(options.out, name), "w") as file:
                    file.write(result.stdout)
            comparison = Comparison(report)
            print(f"\n### {report['experiment']}, resolution {resolution}, {report['time_limit_s']:g} s a run, medians of {options.runs}\n")
            print_table([comparison.row(planner) for planner in comparison.runs])


if __name__ == "__main__":
    main()
