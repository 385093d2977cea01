# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs commands on given cores and says what they took: wall time, CPU time, peak memory."""
import os
import statistics
import sys
import time


class Failed(Exception):
    """A command that should have succeeded did not."""


class Command:
    """A program to measure: `words` run in `folder`; any exit code but those of `accept` is a failure."""

    def __init__(self, name, words, folder, accept=(0,)):
        self.name, self.words, self.folder, self.accept = name, [str(word) for word in words], folder, accept
        self.log = os.path.join(folder, "log of " + name.replace("/", " ") + ".txt")
        self.runs = []

    def run(self, cores):
        """One run: (wall [s], CPU [s], peak resident set [MiB])."""
        start = time.perf_counter()
        pid = os.fork()
        if pid == 0:
            try:
                os.chdir(self.folder)
                os.sched_setaffinity(0, cores)
                out = os.open(self.log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o644)
                os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
                os.dup2(out, 1)
                os.dup2(out, 2)
                os.execvp(self.words[0], self.words)
            finally:
                os._exit(127)
        _, status, usage = os.wait4(pid, 0)
        wall = time.perf_counter() - start
        code = os.waitstatus_to_exitcode(status)
        if code not in self.accept:
            raise Failed(f"{' '.join(self.words)}: exit code {code}, see {self.log}")
        self.runs.append((wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024))

    def median(self, column):
        return statistics.median(run[column] for run in self.runs)

    wall = property(lambda self: self.median(0))
    cpu = property(lambda self: self.median(1))
    memory = property(lambda self: self.median(2))

    def spread(self):
        """Half the range of the wall times, relative to the median."""
        walls = [run[0] for run in self.runs]
        return (max(walls) - min(walls)) / 2 / self.wall

    def record(self):
        return {"command": self.words, "wall_s": [r[0] for r in self.runs], "cpu_s": [r[1] for r in self.runs],
                "peak_MiB": [r[2] for r in self.runs], "median_wall_s": self.wall, "median_cpu_s": self.cpu,
                "median_peak_MiB": self.memory}


def measure(commands, runs, cores):
    """Runs every command `runs` times, in turns, so that a machine that slows down slows all of them."""
    for turn in range(runs):
        for command in commands:
            print(f"  {command.name}: run {turn + 1} of {runs}", file=sys.stderr, flush=True)
            command.run(cores)
